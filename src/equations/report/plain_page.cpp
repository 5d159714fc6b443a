#include "equations/report/plain_page.h"

#include "equations/report/report_parts.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

std::string PlainPage::expression(ExprId id) const {
    return write_expression(grafcet_, pool_, id);
}

std::string PlainPage::name(Variable variable) const {
    return shown_name(grafcet_, variable);
}

std::string PlainPage::of_step(std::string_view quantity, StepId step) const {
    return quoted_where_needed(std::string(quantity) + grafcet_.steps[step].name);
}

std::string PlainPage::held(StepId step) const {
    return "/" + of_step("CDX", step) + "." + of_step("X", step);
}

std::string PlainPage::write(Variable target, const StoredWrite& write) const {
    return write_text(grafcet_, pool_, target, write);
}

}  // namespace grafwire
