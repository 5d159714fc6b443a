#include "check/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "text/utf8.h"

namespace grafwire {

namespace {

std::string_view kind_name(DifferenceKind kind) {
    switch (kind) {
        case DifferenceKind::situation:
            return "situation";
        case DifferenceKind::output:
            return "output";
        case DifferenceKind::oscillation:
            return "oscillation";
        case DifferenceKind::race:
            return "race";
        case DifferenceKind::power_up:
            return "power-up";
    }
    return "";
}

std::string_view verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return "equivalent";
        case Verdict::different:
            return "different";
        case Verdict::undecided:
            return "undecided";
    }
    return "";
}

std::string_view french_verdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return "équivalent";
        case Verdict::different:
            return "différent";
        case Verdict::undecided:
            return "indécis";
    }
    return "";
}

/// Two spaces before every line.
std::string indented(const std::string& text) {
    std::string result;
    bool at_start = true;
    for (const char c : text) {
        if (at_start && c != '\n') result += "  ";
        result += c;
        at_start = c == '\n';
    }
    return result;
}

/// A program that is executed scan by scan passes through unstable situations like the reference.
std::string coverage_text(const CheckResult& result, bool is_scanned, bool french) {
    const Coverage& coverage = result.coverage;
    std::string text;
    if (is_scanned) {
        text = fmt::format(fmt::runtime(french ? "  {} situations, {} cycles comparés\n"
                                               : "  {} situations, {} scans compared\n"),
                           coverage.situations, coverage.cases);
    } else {
        text = fmt::format(
            fmt::runtime(
                french ? "  {} situations stables, {} cas comparés, {} sans situation stable\n"
                       : "  {} stable situations, {} cases compared, {} without a stable "
                         "situation\n"),
            coverage.situations, coverage.cases, coverage.unstable);
    }
    if (!result.complete && result.verdict == Verdict::undecided) {
        text += fmt::format(
            fmt::runtime(
                french ? "  exploration incomplète : {} états atteints restent à quitter\n"
                       : "  exploration incomplete: {} states reached are still to be left\n"),
            coverage.waiting);
    }
    return text;
}

std::string names_text(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

CheckSubject netlist_subject(const std::string& file, const std::string& style,
                             const std::string& cdx, const std::string& delay) {
    return {file,
            {{"style", "style", "style", style},
             {"cdx", "CDX", "CDX", cdx},
             {"delay", "delays", "retards", delay}},
            {},
            false};
}

CheckSubject device_subject(const std::string& file, const std::string& program, Time period) {
    return {file,
            {{"program", "program", "programme", program},
             {"period", "a scan every", "un cycle toutes les", format_duration(period)}},
            {},
            true};
}

std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const std::string& story,
                             Language language) {
    const bool french = language == Language::french;
    std::vector<std::string> properties;
    for (const CheckSubject::Property& property : subject.properties) {
        properties.push_back((french ? property.french : property.english) + " " +
                             visible(property.value));
    }
    std::string text =
        fmt::format("{}: {} ({})\n", visible(subject.file),
                    french ? french_verdict(result.verdict) : verdict_name(result.verdict),
                    fmt::join(properties, ", "));
    text += coverage_text(result, subject.is_scanned, french);
    if (result.first_unstable) {
        text += french ? "\nRemarque : le GRAFCET n'a pas de situation stable ici ("
                       : "\nRemark: the GRAFCET itself has no stable situation here (";
        text += names_text(result.first_unstable->changing);
        text += french ? " changent sans cesse) :\n" : " keep changing):\n";
        text += indented(write_stimuli(result.first_unstable->stimuli, grafcet));
    }
    if (result.witness) {
        text += french ? "\nTémoin :\n" : "\nWitness:\n";
        text += indented(write_stimuli(result.witness->stimuli, grafcet));
        text += '\n' + story;
    }
    return text;
}

std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ToldWitness& told) {
    nlohmann::ordered_json json;
    json["verdict"] = verdict_name(result.verdict);
    for (const CheckSubject::Property& property : subject.properties) {
        json[property.key] = property.value;
    }
    json["situations"] = result.coverage.situations;
    json["cases"] = result.coverage.cases;
    json["unstable"] = result.coverage.unstable;
    json["complete"] = result.complete;
    json["witness"] = nullptr;
    if (result.witness) {
        const Witness& witness = *result.witness;
        nlohmann::ordered_json shown;
        shown["kind"] = kind_name(witness.kind);
        shown["stimuli"] = write_stimuli(witness.stimuli, grafcet);
        shown["expected"] = nlohmann::ordered_json::object();
        shown["got"] = nlohmann::ordered_json::object();
        const auto put = [](nlohmann::ordered_json& into, const std::string& name, Logic value) {
            if (value == Logic::unknown) {
                into[name] = "x";
            } else {
                into[name] = value == Logic::one ? 1 : 0;
            }
        };
        for (const Witness::Value& value : witness.values) {
            put(shown["expected"], value.name, value.expected);
            put(shown["got"], value.name, value.got);
        }
        shown["cause"] = nullptr;
        if (!told.cause.empty()) shown["cause"] = told.cause;
        shown["story"] = told.story;
        shown["files"] = subject.witness_files;
        if (witness.scan_period != 0) shown["scan"] = format_duration(witness.scan_period);
        json["witness"] = std::move(shown);
    }
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

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

}  // namespace

std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const std::string& story) {
    const bool failed = result.verdict == Verdict::different;
    const bool error = result.verdict == Verdict::undecided;
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += fmt::format(
        "<testsuite name=\"grafwire check\" tests=\"1\" failures=\"{}\" errors=\"{}\">\n",
        failed ? 1 : 0, error ? 1 : 0);
    std::vector<std::string> values;
    for (const CheckSubject::Property& property : subject.properties) {
        values.push_back(xml_escaped(visible(property.value)));
    }
    text += fmt::format("  <testcase classname=\"{}\" name=\"{}\">\n",
                        xml_escaped(visible(subject.file)), fmt::join(values, " "));
    const std::string details =
        write_check_text(subject, grafcet, result, story, Language::english);
    if (failed || error) {
        const std::string_view element = failed ? "failure" : "error";
        text += fmt::format("    <{} message=\"{}\">{}</{}>\n", element,
                            failed ? kind_name(result.witness->kind) : "undecided",
                            xml_escaped(details), element);
    } else {
        text += fmt::format("    <system-out>{}</system-out>\n", xml_escaped(details));
    }
    text += "  </testcase>\n</testsuite>\n";
    return text;
}

}  // namespace grafwire
