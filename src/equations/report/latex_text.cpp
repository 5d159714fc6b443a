// Widths are those of Latin Modern Roman in 10 points, rounded up.

#include "equations/report/latex_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "text/joined.h"
#include "text/latex.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// Characters in a row are broken where they are wider than the first, into pieces of the second.
constexpr double widest_run = 95;
constexpr double widest_piece = 55;
/// A wider index is not set as one.
constexpr double widest_index = 80;

/// A run of characters, cut where it is too wide to stand in one line of a narrow column: behind
/// words where there are some.
std::vector<std::string> pieces_of(std::string_view run) {
    std::vector<std::string> characters;
    double width = 0;
    for (std::size_t at = 0; at < run.size();) {
        const CodePoint point = decode_utf8(run, at);
        const std::uint32_t bytes = std::max(point.length, 1U);
        std::string character = latex_character(point.value, run.substr(at, bytes));
        width += printed_width(character);
        if (!characters.empty() && is_latex_ligature(characters.back(), character)) {
            characters.back() += "{}";
        }
        characters.push_back(std::move(character));
        at += bytes;
    }
    const bool is_cut = width > widest_run;
    std::vector<std::string> pieces{""};
    width = 0;
    for (const std::string& character : characters) {
        const double more = printed_width(character);
        if (is_cut && width + more > widest_piece) {
            pieces.emplace_back();
            width = 0;
        }
        pieces.back() += character;
        const bool ends_word = character == "\\_" || character == " " || character == "-";
        width = ends_word && width > widest_piece / 3 ? widest_piece : width + more;
    }
    return pieces;
}

}  // namespace

std::string latex_words(std::string_view words) {
    std::string text;
    while (true) {
        const std::size_t end = std::min(words.find(' '), words.size());
        text += joined(pieces_of(words.substr(0, end)), "\\allowbreak{}");
        if (end == words.size()) return text;
        text += ' ';
        words.remove_prefix(end + 1);
    }
}

std::string latex_identifier(std::string_view name) {
    if (name.size() == 1 && is_ascii_letter(name.front())) return std::string(name);
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char c) {
        return is_ascii_letter(c) || is_digit(c) || c == '_';
    });
    std::string text;
    for (const std::string& piece : pieces_of(name)) {
        // A line is rather broken at an operator.
        if (!text.empty()) text += "\\penalty999 ";
        text += (is_plain ? "\\mathrm{" : "\\text{") + piece + "}";
    }
    return text;
}

std::string latex_symbol(std::string_view symbol) {
    return symbol.size() == 1 ? std::string(symbol) : fmt::format("\\mathit{{{}}}", symbol);
}

std::string latex_indexed(std::string_view symbol, std::string_view name) {
    const bool is_number = std::all_of(name.begin(), name.end(), is_digit);
    const std::string index = is_number ? std::string(name) : latex_identifier(name);
    if (printed_width(index) > widest_index) {
        return latex_identifier(std::string(symbol) + std::string(name));
    }
    return fmt::format("{}_{{{}}}", latex_symbol(symbol), index);
}

namespace {

double width_of_command(std::string_view name) {
    constexpr std::string_view of_no_width[] = {"overline", "mathrm",     "mathit",
                                                "text",     "ensuremath", "allowbreak"};
    constexpr std::string_view relations[] = {"neq", "leq", "geq", "to", "oplus"};
    const auto is_among = [name](const auto& list) {
        return std::find(std::begin(list), std::end(list), name) != std::end(list);
    };
    if (is_among(of_no_width)) return 0;
    if (is_among(relations)) return 16;
    return 8.5;
}

double width_of_character(char c) {
    if (is_digit(c)) return 5;
    switch (c) {
        case '{':
        case '}':
        case '$':
        case '_':
            return 0;
        case '+':
        case '=':
        case '<':
        case '>':
            return 13.4;
        case ' ':
            return 2.5;
        case 'm':
        case 'w':
            return 8.4;
        case 'M':
        case 'W':
        case '@':
            return 10.4;
        default:
            break;
    }
    if (c >= 'A' && c <= 'Z') return 7.9;
    if (c >= 'a' && c <= 'z') return 5.6;
    return begins_character(c) ? 6.5 : 0;
}

}  // namespace

double printed_width(std::string_view latex) {
    double width = 0;
    for (std::size_t at = 0; at < latex.size();) {
        if (latex[at] != '\\') {
            width += width_of_character(latex[at++]);
            continue;
        }
        std::size_t end = at + 1;
        while (end < latex.size() && is_ascii_letter(latex[end])) ++end;
        const std::string_view name = latex.substr(at + 1, end - at - 1);
        width += width_of_command(name);
        at = std::max(end, at + 2);
        // Its number is no text.
        if (name == "penalty") {
            while (at < latex.size() && is_digit(latex[at])) ++at;
            width -= width_of_command(name);
        }
    }
    return width;
}

}  // namespace grafwire
