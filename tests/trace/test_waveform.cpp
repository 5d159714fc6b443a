#include <doctest/doctest.h>

#include <set>

#include "text/version.h"
#include "trace/sample_trace.h"
#include "trace/waveform.h"

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
    CHECK(writer.finish(12) == "$version " + program_and_version() +
                                   " $end\n"
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

TEST_CASE("names are written in what GTKWave reads, and differ") {
    VcdWriter writer("a\tb", nanosecond);
    for (const char* const name : {"x y", "x_y", "$end", "", "a[1]:b", "été +", "X0$set"}) {
        writer.add_signal(name);
    }
    CHECK(writer.shown_name(5) == "a_b.ete_plus");
    writer.begin();
    CHECK(writer.finish(0) == "$version " + program_and_version() +
                                  " $end\n"
                                  "$timescale 1 ns $end\n"
                                  "$scope module a_b $end\n"
                                  "$var wire 1 ! x_y $end\n"
                                  "$var wire 1 \" x_y_2 $end\n"
                                  "$var wire 1 # _end $end\n"
                                  "$var wire 1 $ _ $end\n"
                                  "$var wire 1 % a_1__b $end\n"
                                  "$var wire 1 & ete_plus $end\n"
                                  "$var wire 1 ' X0$set $end\n"
                                  "$upscope $end\n"
                                  "$enddefinitions $end\n"
                                  "#0\n"
                                  "$comment a_b is a b $end\n"
                                  "$comment x_y is x y $end\n"
                                  "$comment x_y_2 is x_y $end\n"
                                  "$comment _end is _end $end\n"
                                  "$comment _ is  $end\n"
                                  "$comment a_1__b is a[1]:b $end\n"
                                  "$comment ete_plus is été + $end\n");
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

TEST_CASE("a trace as a waveform: only changes, counters as vectors, x for the unknown") {
    CHECK(waveform_of(sample_trace(), "my machine").vcd ==
          "$version " + program_and_version() +
              " $end\n"
              "$timescale 1 us $end\n"
              "$scope module my_machine $end\n"
              "$var wire 1 ! a $end\n"
              "$var wire 1 \" a,b_\"c\" $end\n"
              "$var wire 4 # count $end\n"
              "$upscope $end\n"
              "$enddefinitions $end\n"
              "#0\n"
              "0!\n"
              "1\"\n"
              "b1101 #\n"
              "#1500\n"
              "1!\n"
              "x\"\n"
              "b0101 #\n"
              "#2000000\n"
              "0\"\n"
              "$comment my_machine is my machine $end\n"
              "$comment a,b_\"c\" is a,b \"c\" $end\n");
}

TEST_CASE("the timescale of a waveform is as coarse as its moments allow") {
    const auto timescale = [](Time moment) {
        Trace trace;
        trace.times = {0, moment};
        const std::string text = waveform_of(trace, "m").vcd;
        const std::size_t first = text.find("1 ");
        return text.substr(first, 4) + text.substr(text.rfind('#'));
    };
    CHECK(timescale(3 * second) == "1 ms#3000\n");
    CHECK(timescale(3 * microsecond) == "1 us#3\n");
    CHECK(timescale(second + nanosecond) == "1 ns#1000000001\n");
    CHECK(timescale(7) == "1 ps#7\n");
    CHECK(waveform_of(Trace{}, "").vcd.find("$scope module _ $end") != std::string::npos);
}

TEST_CASE("a viewer is told to show inputs, steps and outputs in groups, counters as numbers") {
    CHECK(write_gtkw(waveform_of(sample_trace(), "my machine"), "run.vcd") ==
          "[*] " + program_and_version() +
              "\n[dumpfile] \"run.vcd\"\n"
              "[timestart] 0\n"
              "@800200\n-inputs\n"
              "@28\nmy_machine.a\n"
              "@1000200\n-inputs\n"
              "@800200\n-outputs\n"
              "@28\nmy_machine.a,b_\"c\"\n"
              "@1000200\n-outputs\n"
              "@800200\n-vars and counters\n"
              "@420\nmy_machine.count[3:0]\n"
              "@1000200\n-vars and counters\n");
}

}  // namespace grafwire::testing
