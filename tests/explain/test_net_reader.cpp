// What is read off the gates of a step is what its equation says, in every style.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "explain/compare_functions.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

std::string text_of_file(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Count {
    std::size_t same = 0;
    std::size_t unread = 0;
};

void compare_all(const Grafcet& grafcet, const StyleRow& style, Count& count) {
    const Equations equations = equations_from(grafcet, {style.default_cdx, true});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(grafcet, equations, style.style, diagnostics);
    if (!netlist) return;  // counters need the clocked style
    const NetReader reader(grafcet, *netlist);
    const auto note = [&](const FunctionComparison& comparison, const std::string& name) {
        if (comparison.fault == Explanation::Fault::unread) {
            ++count.unread;
            return;
        }
        ++count.same;
        // Deactivation wins in the memory of NOR gates.
        const bool is_nor = style.style == Style::nor;
        const bool is_right = comparison.fault == Explanation::Fault::no_fault ||
                              (is_nor && comparison.fault == Explanation::Fault::priority);
        if (!is_right) {
            std::string texts;
            for (const auto& pair : comparison.equations) {
                texts += pair.name + " = " + pair.expected + " | " + pair.got + "\n";
            }
            FAIL_CHECK(grafcet.name << " " << style.name << " " << name << "\n" << texts);
        }
    };
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId step = grafcet.steps.id_at(i);
        note(compare_step(reader, equations, step), "X" + grafcet.steps[step].name);
    }
    for (std::size_t i = 0; i < grafcet.outputs.size(); ++i) {
        const OutputId output = grafcet.outputs.id_at(i);
        note(compare_output(reader, equations, output), grafcet.outputs[output].name);
    }
}

}  // namespace

TEST_CASE("the gates of every example say what the equations say") {
    Count count;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(GRAFWIRE_ROOT) + "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        const Grafcet grafcet = grafcet_of(text_of_file(entry.path()));
        for (const StyleRow& style : style_table) compare_all(grafcet, style, count);
    }
    MESSAGE(count.same << " compared, " << count.unread << " not to be read");
    CHECK(count.same > 6 * count.unread);
}

}  // namespace grafwire::testing
