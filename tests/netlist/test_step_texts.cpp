#include <filesystem>
#include <fstream>
#include <sstream>

#include "grafcet/write_grafcet.h"
#include "netlist/styles/annotate.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

TEST_CASE("the text of a step is that of its whole expression, whatever was written before") {
    int charts = 0;
    for (const auto& file : std::filesystem::directory_iterator(GRAFWIRE_ROOT "/examples")) {
        if (file.path().extension() != ".grafcet") continue;
        ++charts;
        CAPTURE(file.path().string());
        std::stringstream text;
        text << std::ifstream(file.path()).rdbuf();
        const Grafcet grafcet = grafcet_of(text.str());
        for (const CdxForm cdx : {CdxForm::successor, CdxForm::transition}) {
            for (const bool modes : {true, false}) {
                const Equations equations = equations_from(grafcet, {cdx, modes});
                Expressions pool = equations.expressions;
                StepTexts texts(grafcet, equations, 1'000'000);
                for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
                    const StepId step = grafcet.steps.id_at(i);
                    CHECK(texts.equation(step) ==
                          "X" + grafcet.steps[step].name + " = " +
                              write_expression(grafcet, pool,
                                               step_expression(equations, step, pool)));
                }
            }
        }
    }
    CHECK(charts > 5);
}

TEST_CASE("an equation too long to be read has no text, and the next one has") {
    std::string steps = "initial 0 ";
    std::string names;
    for (int i = 1; i <= 300; ++i) {
        steps += "step " + std::to_string(i) + " ";
        names += (i == 1 ? "" : ", ") + std::to_string(i);
    }
    const Grafcet grafcet = grafcet_of("input a graph G { " + steps + "step 301 " + names +
                                       " -> 301 : a  0 -> " + names + " : a  301 -> 0 : 1 }");
    const Equations equations = equations_from(grafcet, {CdxForm::successor, false});
    StepTexts texts(grafcet, equations, 256);
    CHECK(texts.equation(StepId{301}).empty());
    CHECK(texts.equation(StepId{1}) == "X1 = X0.a + /X301.X1");
    CHECK(texts.equation(StepId{0}).empty());
    CHECK(texts.equation(StepId{2}) == "X2 = X0.a + /X301.X2");
}

}  // namespace grafwire::testing
