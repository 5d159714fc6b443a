#include "equations/report/write_equations.h"

#include "equations/report/reports.h"

namespace grafwire {

std::string write_equations(const Grafcet& grafcet, const Equations& equations,
                            const EquationReport& report) {
    Reported reported{grafcet, equations, equations.expressions};
    std::unique_ptr<Page> page;
    switch (report.format) {
        case EquationFormat::csv:
            return write_csv_report(reported);
        case EquationFormat::json:
            return write_json_report(reported, report.karnaugh);
        case EquationFormat::text:
            page = text_page(grafcet, reported.pool);
            break;
        case EquationFormat::markdown:
            page = markdown_page(grafcet, reported.pool);
            break;
        case EquationFormat::latex:
            page = latex_page(grafcet, reported.pool);
            break;
    }
    write_report(reported, report, *page);
    return page->finish();
}

}  // namespace grafwire
