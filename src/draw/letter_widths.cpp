// A picture is laid out before any program that knows fonts sees it, so the widths of letters are
// told here: the advances of DejaVu Sans 2.37, in thousandths of the size, from the table `hmtx` of
// the font. Arial and its metric twins are some 15 % narrower in typical conditions: what fits here
// fits there.

#include "draw/letter_widths.h"

#include <cstdint>

#include "text/utf8.h"

namespace grafwire {

namespace {

// clang-format off
constexpr std::uint16_t ascii_widths[] = {  // from the blank to `~`
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,
    318, 337, 636, 636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337,
    838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295,
    295, 656, 557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989,
    685, 611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615,
    352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521,
    392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838,
};
constexpr std::uint16_t latin_widths[] = {  // from the no-break space to `ÿ`
    318, 401, 636, 636, 636, 636, 337, 500, 500, 1000, 471, 612, 838, 361,
    1000, 500, 500, 838, 401, 401, 500, 636, 636, 318, 500, 401, 471, 612,
    969, 969, 969, 531, 684, 684, 684, 684, 684, 684, 974, 698, 632, 632,
    632, 632, 295, 295, 295, 295, 775, 748, 787, 787, 787, 787, 787, 838,
    787, 732, 732, 732, 732, 611, 605, 630, 613, 613, 613, 613, 613, 613,
    982, 550, 615, 615, 615, 615, 278, 278, 278, 278, 612, 634, 612, 612,
    612, 612, 612, 838, 612, 634, 634, 634, 634, 592, 635, 592,
};
// clang-format on

/// Of arrows, relations and the like.
constexpr std::uint16_t sign_width = 838;
/// Of Chinese, Japanese and Korean characters, which are as wide as high.
constexpr std::uint16_t ideograph_width = 1000;
/// No letter of the other alphabets that is common is wider by much.
constexpr std::uint16_t other_width = 700;

std::uint16_t width_of_character(char32_t c) {
    if (c >= 0x20 && c < 0x7f) return ascii_widths[c - 0x20];
    if (c >= 0xa0 && c < 0x100) return latin_widths[c - 0xa0];
    if (c >= 0x300 && c < 0x370) return 0;  // accents that stand over the letter before
    if (c >= 0x2190 && c < 0x2300) return sign_width;
    if (c >= 0x1100 && c < 0x1200) return ideograph_width;
    if (c >= 0x2e80) return ideograph_width;
    return other_width;
}

}  // namespace

double width_in_letters(std::string_view text) {
    std::uint64_t width = 0;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint c = decode_utf8(text, at);
        width += c.length == 0 ? other_width : width_of_character(c.value);
        at += c.length == 0 ? 1 : c.length;
    }
    return static_cast<double>(width) / 1000;
}

}  // namespace grafwire
