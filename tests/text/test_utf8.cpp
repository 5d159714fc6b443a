#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "text/diagnostics.h"
#include "text/utf8.h"

using namespace grafwire;
using namespace std::string_literals;

namespace {

std::string checked(const std::string& text) {
    Diagnostics diagnostics;
    if (check_utf8(text, diagnostics)) return "good";
    const Diagnostic& item = diagnostics.items().at(0);
    CHECK(item.code == code::not_utf8);
    return std::to_string(item.where.line) + ":" + std::to_string(item.where.column) + " " +
           item.message.english.substr(0, 13);
}

}  // namespace

TEST_CASE("well-formed text passes") {
    CHECK(checked("") == "good");
    CHECK(checked("↑dcy é 𝄞 \U0010ffff") == "good");
    CHECK(checked("\xef\xbb\xbfgraph") == "good");
    CHECK(checked("a\0b"s) == "good");
}

TEST_CASE("the first stray byte is found") {
    CHECK(checked("\x80") == "1:1 the byte 0x80");
    CHECK(checked("é\nétape\xe9 12345678") == "2:6 the byte 0xE9");
    CHECK(checked("\xef\xbb\xbf"
                  "ab\xff") == "1:3 the byte 0xFF");
    CHECK(checked("01234567890123456789\nabc\xc0\xaf") == "2:4 the byte 0xC0");
    CHECK(checked("\xe0\x80\xaf") == "1:1 the byte 0xE0");
    CHECK(checked("\xed\xa0\x80") == "1:1 the byte 0xED");
    CHECK(checked("\xf4\x90\x80\x80") == "1:1 the byte 0xF4");
    CHECK(checked("x\xe2\x86") == "1:2 the byte 0xE2");
}

TEST_CASE("code points are counted, not bytes") {
    CHECK(count_code_points("") == 0);
    CHECK(count_code_points("↑é𝄞a") == 4);
    CHECK(decode_utf8("↑", 0).value == 0x2191);
    CHECK(decode_utf8("↑", 0).length == 3);
    CHECK(decode_utf8("↑", 1).length == 0);
}

TEST_CASE("control characters are found, and made visible") {
    for (const std::string text :
         {"\x01", "\t", "\n", "\x7f", "\u0085", "\u009f", "\u061c", "\u200e", "\u200f", "\u2028",
          "\u2029", "\u202a", "\u202e", "\u2066", "\u2069"}) {
        CHECK(find_control("é" + text) == 2);
        CHECK(visible("é" + text + "a", {}) == "é\ufffda");
    }
    for (const std::string text : {" ", "~", "\u00a0", "\u061b", "\u061d", "\u200d", "\u2010",
                                   "\u2027", "\u202f", "\u2065", "\u206a", "é𝄞"}) {
        CHECK(find_control(text) == std::string::npos);
        CHECK(visible(text) == text);
    }
    CHECK(visible("a\tb\nc\xff") == "a\tb\ufffdc\ufffd");
    CHECK(visible("a\tb\nc", "\t\n") == "a\tb\nc");
    CHECK(control_in_name_message("a\x1b").english.starts_with(
        "'a\ufffd' holds the control character U+001B, "));
}

TEST_CASE("long names are cut in messages") {
    CHECK(grafwire::quoted("lamp").english == "'lamp'");
    std::string sixty;
    for (int i = 0; i < 60; ++i) sixty += "é";
    CHECK(grafwire::quoted(sixty).english == "'" + sixty + "'");
    CHECK(grafwire::quoted(sixty + "é").english == "'" + sixty + "…'");
    CHECK(grafwire::quoted(sixty + "é").french == "«\u00a0" + sixty + "…\u00a0»");
}

TEST_CASE("lists of texts are joined in both languages") {
    const std::vector<Localized> texts = {quoted("a"), quoted("b")};
    CHECK(joined(texts, ", ").english == "'a', 'b'");
    CHECK(joined(texts, ", ").french == "«\u00a0a\u00a0», «\u00a0b\u00a0»");
    CHECK(joined({}, ", ").english.empty());
}
