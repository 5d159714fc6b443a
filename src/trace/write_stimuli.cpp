#include <fmt/format.h>

#include <iterator>

#include "grafcet/lexer.h"
#include "trace/stimuli.h"

namespace grafwire {

namespace {

/// Unquoted where it is a word to the reader of stimuli and cannot be taken for the word `end`.
void append_name(std::string& out, std::string_view name) {
    const bool is_word = name != "end" && is_plain_word(name);
    if (!is_word) out += '"';
    out += name;
    if (!is_word) out += '"';
}

}  // namespace

std::string write_stimuli(const Stimuli& stimuli, const Grafcet& grafcet) {
    std::string out;
    for (const Stimuli::Change& change : stimuli.changes) {
        out += format_duration(change.at);
        out += " :";
        for (const Stimuli::Assignment& assignment : change.assignments) {
            out += ' ';
            append_name(out, input_name(grafcet, assignment.input));
            out += assignment.value ? "=1" : "=0";
        }
        out += '\n';
    }
    fmt::format_to(std::back_inserter(out), "{} : end\n", format_duration(stimuli.end));
    return out;
}

}  // namespace grafwire
