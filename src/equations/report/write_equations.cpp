#include "equations/report/write_equations.h"

#include "equations/report/reports.h"

namespace grafwire {

std::string write_equations(const Equations& equations, const EquationReport& report) {
    Equations growing = equations;
    std::unique_ptr<Page> page;
    switch (report.format) {
        case EquationFormat::csv:
            return write_csv_report(growing);
        case EquationFormat::json:
            return write_json_report(growing, report.karnaugh);
        case EquationFormat::text:
            page = text_page(growing);
            break;
        case EquationFormat::markdown:
            page = markdown_page(growing);
            break;
        case EquationFormat::latex:
            page = latex_page(growing);
            break;
    }
    write_report(growing, report, *page);
    return page->finish();
}

}  // namespace grafwire
