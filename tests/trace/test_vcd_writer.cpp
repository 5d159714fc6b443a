#include <doctest/doctest.h>

#include <set>

#include "trace/trace.h"

namespace grafwire::testing {

TEST_CASE("a waveform written signal by signal") {
    VcdWriter writer("top");
    const std::uint32_t a = writer.add_signal("H+");
    const std::uint32_t b = writer.add_signal("word", 3);
    writer.begin();
    writer.change(0, a, 'x');
    writer.change(0, b, 'x');
    writer.change(5, b, std::int64_t{-1});
    writer.change(5, a, '1');
    writer.change(7, b, std::int64_t{2});
    CHECK(writer.finish(12) ==
          "$version grafwire $end\n"
          "$timescale 1 ps $end\n"
          "$scope module top $end\n"
          "$var wire 1 ! H+ $end\n"
          "$var wire 3 \" word $end\n"
          "$upscope $end\n"
          "$enddefinitions $end\n"
          "#0\n"
          "x!\n"
          "bx \"\n"
          "#5\n"
          "b111 \"\n"
          "1!\n"
          "#7\n"
          "b010 \"\n"
          "#12\n");
}

TEST_CASE("names become one word each, and differ") {
    VcdWriter writer("a\tb", nanosecond);
    for (const char* const name : {"x y", "x_y", "$end", "", "x y", "x_y_2", "été"}) {
        writer.add_signal(name);
    }
    writer.begin();
    CHECK(writer.finish(0) ==
          "$version grafwire $end\n"
          "$timescale 1 ns $end\n"
          "$scope module a_b $end\n"
          "$var wire 1 ! x_y $end\n"
          "$var wire 1 \" x_y_2 $end\n"
          "$var wire 1 # _end $end\n"
          "$var wire 1 $ _ $end\n"
          "$var wire 1 % x_y_3 $end\n"
          "$var wire 1 & x_y_2_2 $end\n"
          "$var wire 1 ' été $end\n"
          "$upscope $end\n"
          "$enddefinitions $end\n"
          "#0\n");
}

TEST_CASE("identifiers are short, printable and all different") {
    VcdWriter writer("top");
    for (int i = 0; i < 20000; ++i) writer.add_signal(std::to_string(i));
    writer.begin();
    const std::string text = writer.finish(0);
    std::set<std::string> seen;
    for (std::size_t at = text.find("$var"); at != std::string::npos;
         at = text.find("$var", at + 1)) {
        const std::size_t first = at + std::string("$var wire 1 ").size();
        const std::string id = text.substr(first, text.find(' ', first) - first);
        CHECK(id.size() <= 3);
        for (const char c : id) CHECK((c >= '!' && c <= '~'));
        seen.insert(id);
    }
    CHECK(seen.size() == 20000);
}

TEST_CASE("wide numbers are extended with their sign") {
    VcdWriter writer("top");
    const std::uint32_t wide = writer.add_signal("wide", 66);
    writer.begin();
    writer.change(0, wide, std::int64_t{-2});
    const std::string text = writer.finish(1);
    CHECK(text.find("\nb" + std::string(65, '1') + "0 !\n") != std::string::npos);
}

}  // namespace grafwire::testing
