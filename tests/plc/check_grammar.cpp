#include "plc/check_grammar.h"

#include <vector>

#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "support/iec_grammar.h"

namespace grafwire::testing {

std::string check_grammar(const PlcLanguage& language, const std::string& start,
                          std::uint64_t first_seed) {
    std::vector<std::string> charts;
    for (const ChartFiles& example : example_charts()) charts.push_back(example.chart);
    for (std::uint64_t seed = first_seed; seed < first_seed + 40; ++seed) {
        charts.push_back(random_case(seed, Features(), 1).chart);
    }
    for (const std::string& chart : charts) {
        const auto grafcet = read_grafcet(chart);
        Diagnostics diagnostics;
        const std::string text =
            plc_format_named(language.format)
                ->write(*grafcet, program_from(*grafcet, {}), language.options, diagnostics);
        if (diagnostics.has_errors()) continue;
        const std::string misfit = misfit_in_iec(text, start);
        if (!misfit.empty()) return misfit + "\n" + text;
    }
    return {};
}

}  // namespace grafwire::testing
