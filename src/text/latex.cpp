// Only characters that pdflatex knows by T1 and UTF-8 are written as they are: those of the Latin
// alphabets, and some signs. Greek letters are those of mathematical mode. Of all others the number
// is shown, for pdflatex would stop at them.

#include "text/latex.h"

#include <fmt/format.h>

#include <algorithm>

namespace grafwire {

namespace {

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

}  // namespace

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

bool is_latex_ligature(std::string_view first, std::string_view second) {
    constexpr std::string_view doubled = "-,'`";
    if (first.size() != 1 || second.size() != 1) return false;
    return (first == second && doubled.find(first) != std::string_view::npos) ||
           ((first == "!" || first == "?") && second == "`");
}

}  // namespace grafwire
