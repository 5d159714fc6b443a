#include "text/diagnostics.h"

#include <algorithm>
#include <tuple>

namespace grafwire {

Diagnostic& Diagnostics::error(Code code, Location where, Localized message) {
    ++error_count_;
    return items_.emplace_back(Diagnostic{Severity::error, code, where, std::move(message), {}});
}

Diagnostic& Diagnostics::warning(Code code, Location where, Localized message) {
    return items_.emplace_back(Diagnostic{Severity::warning, code, where, std::move(message), {}});
}

void Diagnostics::sort_by_place() {
    std::stable_sort(items_.begin(), items_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
    });
}

}  // namespace grafwire
