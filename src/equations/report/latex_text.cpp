// Only characters that pdflatex knows by T1 and UTF-8 are written as they are: those of the Latin
// alphabets, and some signs. Greek letters are those of mathematical mode. Of all others the number
// is shown, for pdflatex would stop at them.
//
// Widths are those of Latin Modern Roman in 10 points, rounded up.

#include "equations/report/latex_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "text/utf8.h"

namespace grafwire {

namespace {

/// Characters in a row are broken where they are wider than the first, into pieces of the second.
constexpr double widest_run = 95;
constexpr double widest_piece = 55;
/// A wider index is not set as one.
constexpr double widest_index = 80;

struct Escape {
    char32_t character;
    std::string_view latex;
};
constexpr Escape escapes[] = {
    {'{', "\\{"},
    {'}', "\\}"},
    {'$', "\\$"},
    {'&', "\\&"},
    {'#', "\\#"},
    {'%', "\\%"},
    {'_', "\\_"},
    {'\\', "\\textbackslash{}"},
    {'^', "\\textasciicircum{}"},
    {'~', "\\textasciitilde{}"},
    {'<', "\\textless{}"},
    {'>', "\\textgreater{}"},
    {'|', "\\textbar{}"},
    // Blanks that are not to be broken at.
    {0x00a0, "~"},
    {0x202f, "\\,"},
};

constexpr char32_t first_greek = 0x391;
/// From Α to ω; empty where it looks like a Latin letter.
constexpr std::string_view greek[] = {
    "",           "",       "Gamma", "Delta", "",         "",      "",       "Theta",   "",
    "",           "Lambda", "",      "",      "Xi",       "",      "Pi",     "",        "",
    "Sigma",      "",       "",      "Phi",   "",         "Psi",   "Omega",  "",        "",
    "",           "",       "",      "",      "",         "alpha", "beta",   "gamma",   "delta",
    "varepsilon", "zeta",   "eta",   "theta", "iota",     "kappa", "lambda", "mu",      "nu",
    "xi",         "",       "pi",    "rho",   "varsigma", "sigma", "tau",    "upsilon", "varphi",
    "chi",        "psi",    "omega"};

bool is_known_to_latex(char32_t c) {
    constexpr char32_t unknown_letters[] = {0xad,  0x126, 0x127, 0x138, 0x13f,
                                            0x140, 0x149, 0x166, 0x167};
    constexpr char32_t signs[] = {0x2013, 0x2014, 0x2018, 0x2019, 0x201c, 0x201d, 0x2026,
                                  0x20ac, 0x2103, 0x2122, 0x2190, 0x2191, 0x2192, 0x2193};
    const auto is_among = [c](const auto& list) {
        return std::find(std::begin(list), std::end(list), c) != std::end(list);
    };
    if (c < 0x7f) return true;
    return c <= 0x17e ? c >= 0xa1 && !is_among(unknown_letters) : is_among(signs);
}

/// A character in text mode.
std::string latex_character(char32_t c, std::string_view bytes) {
    for (const Escape& escape : escapes) {
        if (escape.character == c) return std::string(escape.latex);
    }
    if (c >= first_greek && c < first_greek + std::size(greek) && !greek[c - first_greek].empty()) {
        return fmt::format("\\ensuremath{{\\{}}}", greek[c - first_greek]);
    }
    if (!is_known_to_latex(c)) return fmt::format("U+{:04X}", static_cast<std::uint32_t>(c));
    return std::string(bytes);
}

/// Whether TeX makes one sign of two characters, as of `--`; an empty group between them prevents
/// it.
bool is_ligature(std::string_view first, std::string_view second) {
    constexpr std::string_view doubled = "-,'`";
    if (first.size() != 1 || second.size() != 1) return false;
    return (first == second && doubled.find(first) != std::string_view::npos) ||
           ((first == "!" || first == "?") && second == "`");
}

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
        if (!characters.empty() && is_ligature(characters.back(), character)) {
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
        text += fmt::format("{}", fmt::join(pieces_of(words.substr(0, end)), "\\allowbreak{}"));
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
