// The report of a check for servers that build and test: one suite with one case. The time it took
// stands in it, as these servers expect, so it is the only result that is not the same every time.

#include <fmt/format.h>

#include "check/report.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

std::string xml_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\n':
                result += "&#10;";
                break;
            default:
                // XML 1.0 has no place for other control characters.
                result += static_cast<unsigned char>(c) < 0x20 && c != '\t' ? '?' : c;
        }
    }
    return result;
}

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
                        xml_escaped(visible(subject.file)), xml_escaped(visible(subject.name)),
                        seconds);
    if (outcome == Outcome::passed) {
        text += fmt::format("    <system-out>{}</system-out>\n", xml_escaped(details));
    } else {
        const std::string_view element = outcome == Outcome::failed ? "failure" : "error";
        text += fmt::format("    <{} message=\"{}\">{}</{}>\n", element, message,
                            xml_escaped(details), element);
    }
    return text + "  </testcase>\n</testsuite>\n";
}

}  // namespace

std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const ToldWitness& told, double seconds) {
    ToldWitness in_english = told;
    in_english.text = fmt::format("{}\n", fmt::join(told.story, "\n"));
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
