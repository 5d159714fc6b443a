// Sketches for Arduino boards, compiled against a board of which only pins and clock are there, are
// the reference scan by scan: inputs, steps and outputs.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What sketches use of Arduino.h, and macros of such headers that get in the way of names.
constexpr const char* arduino_h = R"(
#pragma once
#include <stdint.h>
#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define F(text) (text)
#define bit(b) (1UL << (b))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define PB0 0
#define S1 broken
#define B1 1
void pinMode(uint8_t pin, uint8_t mode);
int digitalRead(uint8_t pin);
void digitalWrite(uint8_t pin, uint8_t value);
unsigned long micros();
)";

/// Lets the clock stand one second before its end as the run begins; pins refuse to be used in the
/// wrong direction.
constexpr const char* board = R"(
#include "Arduino.h"
#include "sketch.ino"
#include <stdio.h>
#include <stdlib.h>

static int modes[256];
static int levels[256];
static int64_t now;

static void require(bool holds) {
    if (!holds) abort();
}
void pinMode(uint8_t pin, uint8_t mode) {
    modes[pin] = mode + 1;
}
int digitalRead(uint8_t pin) {
    require(modes[pin] == INPUT + 1);
    return levels[pin];
}
void digitalWrite(uint8_t pin, uint8_t value) {
    require(modes[pin] == OUTPUT + 1);
    levels[pin] = value;
}
unsigned long micros() {
    return (uint32_t)(now - 1000000);
}

int main() {
    char text[40];
    while (getchar() != '\n') {}
    for (bool started = false; scanf("%39[0-9.]", text) == 1; started = true) {
        now = (int64_t)(strtod(text, 0) * 1000 + 0.5);
        printf("%s", text);
        for (int i = 0; i < INPUTS; ++i) {
            require(scanf(",%d", &levels[2 + i]) == 1);
            printf(",%d", levels[2 + i]);
        }
        getchar();
        if (!started) setup();
        loop();
        for (int s = 0; s < STEPS; ++s) printf(",%u", chart.Ts[s / 32] >> (s % 32) & 1u);
        for (int i = 0; i < OUTPUTS; ++i) printf(",%d", levels[2 + INPUTS + i]);
        putchar('\n');
    }
}
)";

std::vector<std::string> run_arduino(const Grafcet& grafcet, const ScanProgram& program,
                                     const std::vector<std::string>& scans) {
    const ScratchFolder folder;
    folder.file("sketch.ino", written("arduino", grafcet, program));
    folder.file("Arduino.h", arduino_h);
    // A random chart may compare a sum with itself.
    compile({"g++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-Wno-tautological-compare",
             "-I" + folder.path(""), fmt::format("-DINPUTS={}", grafcet.all_input_count()),
             fmt::format("-DOUTPUTS={}", grafcet.outputs.size()), folder.file("board.cpp", board),
             "-o", folder.path("board")});
    std::vector<std::string> traces = run_on({folder.path("board")}, scans);
    // The board knows no names.
    for (std::string& trace : traces) trace.insert(0, heading_without_internals(grafcet));
    return traces;
}

}  // namespace

TEST_CASE("a sketch for Arduino boards is the reference") {
    check_language(run_arduino, 960'000, 200, false);
}

}  // namespace grafwire::testing
