// What programs in C, Pascal and Python have alike: names of functions and of what holds the bits,
// the head of the file, and the heading of the trace that their main programs write.

#include "plc/computer/language_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"
#include "plc/computer/messages.h"
#include "plc/shared/program_needs.h"
#include "program/bit_names.h"
#include "program/messages.h"
#include "trace/trace.h"

namespace grafwire {

namespace say = messages::plc_computer;

std::string_view section_function(SectionKind section) {
    switch (section) {
        case SectionKind::start:
            return "start";
        case SectionKind::begin:
            return "begin_scan";
        case SectionKind::edges:
            return "find_edges";
        case SectionKind::conditions:
            return "test_conditions";
        case SectionKind::evolution:
            return "evolve";
        case SectionKind::orders:
            return "obey_orders";
        case SectionKind::stored:
            return "run_stored_actions";
        case SectionKind::times:
            return "observe_times";
        case SectionKind::outputs:
            return "drive_outputs";
    }
    return {};
}

std::string_view holder_name(BitKind kind) {
    switch (kind) {
        case BitKind::input:
        case BitKind::control:
            return "inputs";
        case BitKind::output:
            return "outputs";
        case BitKind::var:
            return "vars";
        case BitKind::edge:
            return "edge";
        case BitKind::edge_memory:
            return "memory";
        case BitKind::time_value:
            return "time";
        default:
            return table_name(kind);  // empty for bits that stand alone
    }
}

std::int64_t microseconds(Time delay) {
    return delay / microsecond + (delay % microsecond != 0 ? 1 : 0);
}

bool check_integers(const Grafcet& grafcet, const ScanProgram& program, std::string_view language,
                    Diagnostics& diagnostics) {
    if (integer_bits(grafcet, program)) return true;
    diagnostics.error(code::beyond_limit, wide_integer(grafcet, program, 64),
                      say::sum_too_wide(language));
    return false;
}

void write_title(SourceText& out, const Grafcet& grafcet, const Localized& kind,
                 const PlcOptions& options) {
    out.comment(titled_name(quoted_where_needed(grafcet.name), grafcet.title, options.language));
    if (!options.made_by.empty()) out.comment(options.made_by);
    out.comment({});
    out.comment(say::what_it_is.in(options.language, kind));
}

bool says_more(const Statement& statement) {
    return statement.kind != Statement::Kind::table ||
           (statement.operation != TableOperation::remember &&
            statement.operation != TableOperation::clear);
}

void write_changed_names(SourceText& out, const ProgramNames& names, Language language) {
    if (names.changed().empty()) return;
    out.comment({});
    out.comment(say::changed_names.in(language));
    std::size_t longest = 0;
    for (const auto& [name, original] : names.changed()) {
        longest = std::max(longest, name.size());
    }
    for (const auto& [name, original] : names.changed()) {
        out.comment(fmt::format("  {:<{}}  {}", name, longest, original));
    }
}

/// Cut behind commas, so that a part is a text between quotation marks on a line of its own.
std::vector<std::string> trace_heading(const Grafcet& grafcet) {
    constexpr std::size_t longest = 70;
    std::string heading = write_csv(empty_trace(grafcet));
    heading.pop_back();  // the end of the line
    std::vector<std::string> parts{""};
    for (std::size_t at = 0; at < heading.size();) {
        const std::size_t end = std::min(heading.find(',', at), heading.size() - 1) + 1;
        if (!parts.back().empty() && parts.back().size() + end - at > longest) {
            parts.emplace_back();
        }
        parts.back() += heading.substr(at, end - at);
        at = end;
    }
    return parts;
}

}  // namespace grafwire
