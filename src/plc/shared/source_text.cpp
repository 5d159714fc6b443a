// The text of a program: headings, lines that are wrapped, comments that no compiler reads as code,
// and parts that are the same for every chart.
//
// A line is wrapped at a blank in its second half, the one within the fewest parentheses, so that
// operands stay together: `a && (b ||` is the last choice.

#include "plc/shared/source_text.h"

#include <fmt/format.h>

#include "plc/shared/messages.h"
#include "text/utf8.h"

namespace grafwire {

Localized section_title(SectionKind kind) {
    namespace say = messages::plc_shared;
    switch (kind) {
        case SectionKind::start:
            return say::section_start();
        case SectionKind::begin:
            return say::section_begin();
        case SectionKind::edges:
            return say::section_edges();
        case SectionKind::conditions:
            return say::section_conditions();
        case SectionKind::evolution:
            return say::section_evolution();
        case SectionKind::orders:
            return say::section_orders();
        case SectionKind::stored:
            return say::section_stored();
        case SectionKind::times:
            return say::section_times();
        case SectionKind::outputs:
            return say::section_outputs();
    }
    return {};
}

namespace {

bool is_word_sign(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Where to break a line so that the first part has at most `room` bytes: in its second half, at
/// the last blank of those within the fewest parentheses, `least_depth` at least; npos where there
/// is none. `depth` counts the parentheses that are open, at the beginning and then at the break.
std::size_t break_of(std::string_view text, std::size_t room, int least_depth, int& depth) {
    constexpr std::size_t least_rest = 6;  // no line for ` then` or ` {` alone
    std::size_t best = std::string_view::npos;
    int here = depth;
    for (std::size_t at = 0; at <= room; ++at) {
        if (text[at] == '(') ++here;
        if (text[at] == ')') --here;
        if (text[at] != ' ' || at < room / 2 || text.size() - at < least_rest) continue;
        if (here < least_depth || (best != std::string_view::npos && here > depth)) continue;
        best = at;
        depth = here;
    }
    return best;
}

}  // namespace

void SourceText::line(std::string_view text) {
    const int least_depth = breaks_ == Breaks::within_parentheses ? 1 : 0;
    std::size_t indentation = depth_;
    int parentheses = 0;
    while (indentation + text.size() > width) {
        const std::size_t at = break_of(text, width - indentation, least_depth, parentheses);
        if (at == std::string_view::npos) break;
        text_.append(indentation, ' ').append(text.substr(0, at)) += '\n';
        text.remove_prefix(at + 1);
        indentation = depth_ + 8;
    }
    text_.append(indentation, ' ').append(text) += '\n';
}

void SourceText::whole_line(std::string_view text) {
    text_.append(depth_, ' ').append(text) += '\n';
}

void SourceText::comment(std::string_view text) {
    for (bool goes_on = true; goes_on;) {
        const std::size_t end = text.find('\n');
        const std::string_view one = text.substr(0, end);
        whole_line(one.empty() ? comment_sign_
                               : fmt::format("{} {}", comment_sign_, comment_text(one)));
        goes_on = end != std::string_view::npos;
        if (goes_on) text.remove_prefix(end + 1);
    }
}

std::string comment_text(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = decode_utf8(text, at);
        const std::size_t length = point.length == 0 ? 1 : point.length;
        if (point.value < 0x20 || point.value == 0x7F) {
            result += ' ';
        } else if (is_control(point.value)) {
            result += fmt::format("<{:04X}>", static_cast<std::uint32_t>(point.value));
        } else {
            result += text.substr(at, length);
        }
        at += length;
    }
    // A backslash, or the trigraph of one, would join the next line to the comment.
    if (!result.empty() && (result.back() == '\\' || result.back() == '/')) result += " .";
    return result;
}

namespace {

/// What the next line of a text begins with, after a line that begins so.
std::string continuation_of(std::string_view line) {
    const std::string blanks(line.find_first_not_of(' ') == std::string_view::npos
                                 ? line.size()
                                 : line.find_first_not_of(' '),
                             ' ');
    if (line.ends_with("f\"")) return fmt::format("\"\n{}f\"", std::string(line.size() - 2, ' '));
    for (const std::string_view sign : {"// ", "# "}) {
        if (line.ends_with(sign)) return fmt::format("\n{}{}", blanks, sign);
    }
    return "\n" + blanks;
}

}  // namespace

std::string with_texts(std::string_view block, std::initializer_list<MarkedText> texts) {
    std::string result(block);
    for (const MarkedText& marked : texts) {
        for (std::size_t at = 0; (at = result.find(marked.mark, at)) != std::string::npos;) {
            const std::size_t line = result.rfind('\n', at) + 1;  // 0 where it is the first
            const std::string next =
                continuation_of(std::string_view(result).substr(line, at - line));
            std::string text;
            for (const char c : marked.text) text += c == '\n' ? next : std::string(1, c);
            result.replace(at, marked.mark.size(), text);
            at += text.size();
        }
    }
    return result;
}

bool calls(std::string_view program, std::string_view function) {
    const std::string call = std::string(function) + "(";
    for (std::size_t at = program.find(call); at != std::string_view::npos;
         at = program.find(call, at + 1)) {
        if (at == 0 || !is_word_sign(program[at - 1])) return true;
    }
    return false;
}

}  // namespace grafwire
