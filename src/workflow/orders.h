#pragma once

#include <string>
#include <vector>

#include "check/report.h"
#include "orders/interlock.h"
#include "text/diagnostics.h"
#include "workflow/chart.h"

namespace grafwire {

/// Whether what a chart does depends on the order in which its transitions clear, which wiring in
/// the style handshake must not, and the chart with the interlocks that help.
struct OrderFindings {
    RaceReport races;
    InterlockedChart interlocked;
};

/// Looks for both, in as many cases as take a second or so on any machine; large charts are looked
/// at in part, and the same part each time. `modes`: whether there are Init, AUdur and AUdoux.
OrderFindings find_orders(const Chart& chart, bool modes);

/// The same chart with the interlocks. The text, and all places in it, stay those of the original.
Chart interlocked_chart(const Chart& chart, const OrderFindings& findings);

/// What to warn of before wiring is made of the chart, or of the interlocked one.
Diagnostics order_warnings(const Chart& chart, const OrderFindings& findings);
Diagnostics interlock_warnings(const Chart& chart, const OrderFindings& findings);

/// Which interlocks were added; one sentence each, a line each.
Localized told_interlocks(const OrderFindings& findings);
/// The same sentences for heads of files, in English.
std::vector<std::string> interlock_sentences(const OrderFindings& findings);

/// What the report of a check says of it. `is_interlocked`: the interlocked chart is compared with.
OrderRemarks order_remarks(const Chart& chart, const OrderFindings& findings, bool is_interlocked);

/// The text of the chart with its interlocks, all else as it was written.
std::string interlocked_text(const Chart& chart, const OrderFindings& findings);

}  // namespace grafwire
