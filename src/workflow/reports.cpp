#include "workflow/check.h"

namespace grafwire {

namespace {

std::string text(const Judgement& judgement, const Chart& chart, double, Language language) {
    return write_check_text(judgement.subject, chart.grafcet, judgement.result, judgement.explained,
                            language);
}

std::string json(const Judgement& judgement, const Chart& chart, double, Language) {
    return write_check_json(judgement.subject, chart.grafcet, judgement.result,
                            judgement.explained);
}

std::string junit(const Judgement& judgement, const Chart& chart, double seconds, Language) {
    return write_check_junit(judgement.subject, chart.grafcet, judgement.result,
                             judgement.explained, seconds);
}

constexpr ReportRow table[] = {{"text", text}, {"json", json}, {"junit", junit}};

}  // namespace

std::span<const ReportRow> report_forms() {
    return table;
}

}  // namespace grafwire
