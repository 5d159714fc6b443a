// Damaged files are refused or read as a whole netlist, and never anything else.

#include <doctest/doctest.h>

#include <random>

#include "formats/blif/read_blif.h"
#include "formats/yosys/read_yosys_json.h"

using namespace grafwire;

namespace {

const std::string blif = R"(# a comment
.model m
.inputs a b clk
.outputs X1 q t
.names a b X1
1- 1
-0 1
.latch X1 q re clk 0
.subckt grafwire_timer a=q q=t
.attr RISE "5s"
#@initially X1 1
.end
)";

const std::string json = R"({"modules": {"m": {"ports": {"a": {"direction": "input", "bits": [2]},
 "c": {"direction": "input", "bits": [3]}, "y": {"direction": "output", "bits": [4]}},
 "cells": {"g": {"type": "$_NAND_", "connections": {"A": [2], "B": ["1"], "Y": [5]}},
  "h": {"type": "$_DFF_P_", "connections": {"D": [5], "C": [3], "Q": [4]}},
  "l": {"type": "$lut", "parameters": {"LUT": "0110"}, "connections": {"A": [2, 4], "Y": [6]}}},
 "netnames": {"w": {"bits": [4, 5], "attributes": {"init": "10"}}}}}})";

template <typename Read>
void check_damaged(const std::string& whole, const Read& read, unsigned seed) {
    const auto check = [&](const std::string& text) {
        Diagnostics diagnostics;
        const std::optional<Netlist> netlist = read({"x", text}, diagnostics);
        CAPTURE(text);
        CHECK(netlist.has_value() != diagnostics.has_errors());
        if (netlist) CHECK(fault_of(*netlist) == "");
    };
    check(whole);
    for (std::size_t length = 0; length < whole.size(); ++length) check(whole.substr(0, length));
    std::mt19937 random(seed);
    const auto below = [&](std::size_t bound) {
        return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
    };
    for (int round = 0; round < 5000; ++round) {
        std::string text = whole;
        for (std::size_t changes = 1 + below(3); changes != 0; --changes) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
                case 0:
                    text[at] = static_cast<char>(below(256));
                    break;
                case 1:
                    text.erase(at, 1 + below(8));
                    break;
                case 2:
                    text.insert(at, text.substr(below(text.size()), below(20)));
                    break;
                default:
                    std::swap(text[at], text[below(text.size())]);
                    break;
            }
            if (text.empty()) break;
        }
        check(text);
    }
}

}  // namespace

TEST_CASE("damaged BLIF") {
    check_damaged(blif, read_blif, 1);
}

TEST_CASE("damaged JSON") {
    check_damaged(json, read_yosys_json, 2);
}
