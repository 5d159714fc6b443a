// What the statements of a program look like.

#include <doctest/doctest.h>

#include "grafcet/grafcet.h"
#include "program/program.h"
#include "random/read_text.h"

namespace grafwire::testing {

TEST_CASE("the manipulator's upper graph as a program") {
    const auto grafcet = read_grafcet(R"(
        input dcy, au
        output lamp
        graph G0 {
          initial 0 : G1{}
          step 1 : G1{10}
          step 2 : G1{*}
          0 -> 1 : ↑dcy . /au
          1 -> 2 : =1
          2 -> 0 : 5s/X2
        }
        graph G1 {
          step 10 : lamp if dcy
          10 -> : au
        })");
    REQUIRE(grafcet);
    CHECK(write_program_text(*grafcet, program_from(*grafcet, {})) ==
          R"(start: set Tfig[G0] Tfig[G1] if 1  # no graph is frozen
start: set Tp[0] Ts[0] if 1  # initial step 0
start: memory[0] := dcy  # memory of ↑dcy
begin: table  # Tp = Ts
begin: table  # Ta = Td = Tf1 = Tf0 = 0
edges: edge[0] := dcy . /memory[0]  # ↑dcy
edges: memory[0] := dcy  # memory of ↑dcy
conditions: Tt[0] := edge[0] . /au . Tfig[G0]  # (0) 0 -> 1 : ↑dcy./au
conditions: Tt[1] := Tfig[G0]  # (1) 1 -> 2 : 1
conditions: Tt[2] := time[0] . Tfig[G0]  # (2) 2 -> 0 : 5s/X2
conditions: Tt[3] := au . Tfig[G1]  # (3) 10 -> : au
evolution: set Ta[1] Td[0] if Ts[0] . Tt[0]  # (0) 0 -> 1
evolution: set Ta[2] Td[1] if Ts[1] . Tt[1]  # (1) 1 -> 2
evolution: set Ta[0] Td[2] if Ts[2] . Tt[2]  # (2) 2 -> 0
evolution: set Td[10] if Ts[10] . Tt[3]  # (3) 10 ->
evolution: table  # Ts = Tp . /Td + Ta
evolution: set Ts[0] if Init  # Init: initial steps
evolution: reset Ts[1] Ts[2] Ts[10] if Init  # Init: all other steps
orders: set Tf0[10] if Ts[0]  # forcing orders of step 0
orders: set Tf0[10] Tf1[10] if Ts[1]  # forcing orders of step 1
orders: table  # Ts = Ts . /Tf0 + Tf1
orders: reset Ts[0] Ts[1] Ts[2] Ts[10] if AUdur  # AUdur: every step
orders: table  # Tpulse = Ts . /Tp
times: time[0] := 5s/Ts[2]/0s  # 5s/X2
outputs: lamp := Ts[10] . dcy . /AUdoux  # lamp
outputs: Tfig[G1] := /Ts[2]  # G1 may evolve
)");
}

TEST_CASE("without modes nothing reads Init, AUdur and AUdoux") {
    const auto grafcet = read_grafcet(R"(
        input a
        output lamp
        graph G { initial 0 : lamp  0 -> 0 : a + Init })");
    REQUIRE(grafcet);
    const ScanProgram with = program_from(*grafcet, {true});
    CHECK(reads_control(with, ControlInput::init));
    CHECK(reads_control(with, ControlInput::au_dur));
    CHECK(reads_control(with, ControlInput::au_doux));
    const ScanProgram without = program_from(*grafcet, {false});
    CHECK_FALSE(reads_control(without, ControlInput::init));
    CHECK_FALSE(reads_control(without, ControlInput::au_dur));
    CHECK_FALSE(reads_control(without, ControlInput::au_doux));
}

TEST_CASE("what an earlier action writes is read before it") {
    const auto grafcet = read_grafcet(R"(
        var a, b
        counter c : 0..9
        graph G {
          initial 0
          step 1 : a := /a, b := a, c := c + 1
          0 -> 1 : =1 do c := c + 1
          1 -> 0 : =1
        })");
    REQUIRE(grafcet);
    const std::string text = write_program_text(*grafcet, program_from(*grafcet, {false}));
    CHECK(text.find(R"(stored: S0 := /a  # value of a on activation of step 1
stored: S1 := a  # value of b on activation of step 1
stored: I0 := c+1 within 0..9 if 1  # value of c on activation of step 1
stored: c := c+1 within 0..9 if Tp[0] . Tt[0]  # c on clearing of (0) 0 -> 1
stored: set a if Tpulse[1] . S0  # a on activation of step 1
stored: reset a if Tpulse[1] . /S0  # a on activation of step 1
stored: set b if Tpulse[1] . S1  # b on activation of step 1
stored: reset b if Tpulse[1] . /S1  # b on activation of step 1
stored: c := I0 within 0..9 if Tpulse[1]  # c on activation of step 1
)") != std::string::npos);
}

TEST_CASE("the range of a sum counts what is reached on the way") {
    const auto grafcet = read_grafcet("counter c : -5..9\ngraph G { initial 0 }");
    REQUIRE(grafcet);
    const auto range =
        range_of(*grafcet, {{false, 0, 0}, {true, 0, 0}, {false, SumTerm::no_counter, 3}});
    REQUIRE(range);
    CHECK(range->low == -14);
    CHECK(range->high == 17);
    const std::int64_t big = INT64_MAX;
    CHECK_FALSE(range_of(*grafcet, {{false, SumTerm::no_counter, big}, {false, 0, 0}}));
}

}  // namespace grafwire::testing
