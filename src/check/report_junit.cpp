// The report of a check for servers that build and test: one suite with one case. The time it took
// stands in it, as these servers expect, so it is the only result that is not the same every time.

#include <fmt/format.h>

#include "check/report.h"
#include "text/utf8.h"
#include "text/xml.h"

namespace grafwire {

namespace {

enum class Outcome { passed, failed, error };

/// `message`: why it failed, in a word or two.
std::string suite(const CheckSubject& subject, Outcome outcome, std::string_view message,
                  std::string_view details, double seconds) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += fmt::format(
        "<testsuite name=\"grafwire check\" tests=\"1\" failures=\"{}\" errors=\"{}\" "
        "time=\"{:.3f}\">\n",
        outcome == Outcome::failed ? 1 : 0, outcome == Outcome::error ? 1 : 0, seconds);
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
                        xml_attribute(visible(subject.file)), xml_attribute(visible(subject.name)),
                        seconds);
    if (outcome == Outcome::passed) {
        text += fmt::format("    <system-out>{}</system-out>\n", xml_attribute(details));
    } else {
        const std::string_view element = outcome == Outcome::failed ? "failure" : "error";
        text += fmt::format("    <{} message=\"{}\">{}</{}>\n", element, message,
                            xml_attribute(details), element);
    }
    return text + "  </testcase>\n</testsuite>\n";
}

}  // namespace

std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const ExplainedWitness& explained,
                              double seconds) {
    ExplainedWitness in_english = explained;
    in_english.text = fmt::format("{}\n", fmt::join(explained.lines, "\n"));
    const std::string details =
        write_check_text(subject, grafcet, result, in_english, Language::english);
    switch (result.verdict) {
        case Verdict::different:
            return suite(subject, Outcome::failed, name_of(result.witness->kind), details, seconds);
        case Verdict::undecided:
            return suite(subject, Outcome::error, "undecided", details, seconds);
        case Verdict::equivalent:
            break;
    }
    return suite(subject, Outcome::passed, "", details, seconds);
}

std::string write_refused_junit(const CheckSubject& subject, std::string_view messages,
                                double seconds) {
    return suite(subject, Outcome::error, "not checked", messages, seconds);
}

}  // namespace grafwire
