// Sketches for Arduino boards, compiled against a board of which only pins and clock are there, are
// the reference scan by scan: inputs, steps and outputs.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "random/read_text.h"
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
#define INPUT_PULLUP 0x2
#define F(text) (text)
#define bit(b) (1UL << (b))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define PB0 0
#define PORTB broken
#define B1 1
void pinMode(uint8_t pin, uint8_t mode);
int digitalRead(uint8_t pin);
void digitalWrite(uint8_t pin, uint8_t value);
unsigned long micros();
void delay(unsigned long ms);
)";

/// Inputs are contacts: to ground where the pin has to have its pull-up resistor, from PULLED_UP
/// on, and to 5 V elsewhere. With OPEN_PINS nothing is wired, and every pin is read as 1. Lets the
/// clock stand one second before its end as the run begins; pins refuse to be used in the wrong
/// direction.
constexpr const char* board = R"(
#include "Arduino.h"
#include "sketch.ino"
#include <stdio.h>
#include <stdlib.h>

static int modes[256];
static int levels[256];  // of an input: whether the contact is closed
static int64_t now;

static void require(bool holds) {
    if (!holds) abort();
}
void pinMode(uint8_t pin, uint8_t mode) {
    modes[pin] = mode + 1;
}
int digitalRead(uint8_t pin) {
    const bool is_pulled_up = pin >= 2 + PULLED_UP;
    require(modes[pin] == (is_pulled_up ? INPUT_PULLUP : INPUT) + 1);
#ifdef OPEN_PINS
    return HIGH;
#endif
    return is_pulled_up ? !levels[pin] : levels[pin];
}
void digitalWrite(uint8_t pin, uint8_t value) {
    require(modes[pin] == OUTPUT + 1);
    levels[pin] = value;
}
void delay(unsigned long) {}
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

/// How the board of a run is wired.
struct Wiring {
    bool pull_up = false;
    bool open_pins = false;
};

std::vector<std::string> run_wired(const Grafcet& grafcet, const ScanProgram& program,
                                   const std::vector<std::string>& scans, const Wiring& wiring) {
    const ScratchFolder folder;
    PlcOptions options;
    options.pull_up = wiring.pull_up;
    folder.file("sketch.ino", written("arduino", grafcet, program, options));
    folder.file("Arduino.h", arduino_h);
    // A random chart may compare a sum with itself.
    compile({"g++", "-std=c++11", "-Wall", "-Wextra", "-Werror", "-Wno-tautological-compare",
             "-I" + folder.path(""), fmt::format("-DINPUTS={}", grafcet.all_input_count()),
             fmt::format("-DOUTPUTS={}", grafcet.outputs.size()),
             fmt::format("-DPULLED_UP={}", wiring.pull_up ? 0 : grafcet.inputs.size()),
             wiring.open_pins ? "-DOPEN_PINS" : "-DWIRED", folder.file("board.cpp", board), "-o",
             folder.path("board")});
    std::vector<std::string> traces = run_on({folder.path("board")}, scans);
    // The board knows no names.
    for (std::string& trace : traces) trace.insert(0, heading_without_internals(grafcet));
    return traces;
}

std::vector<std::string> run_arduino(const Grafcet& grafcet, const ScanProgram& program,
                                     const std::vector<std::string>& scans) {
    return run_wired(grafcet, program, scans, {});
}

std::vector<std::string> run_pulled_up(const Grafcet& grafcet, const ScanProgram& program,
                                       const std::vector<std::string>& scans) {
    return run_wired(grafcet, program, scans, {true, false});
}

/// The steps after two scans of a board that nothing is wired to, as `1,0`.
std::string steps_with_open_pins(bool pull_up) {
    const auto grafcet =
        read_grafcet("input go\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : go\n}\n");
    REQUIRE(grafcet);
    const auto traces = run_wired(*grafcet, program_from(*grafcet, {}),
                                  {"x\n0,0,0,0,0\n10,0,0,0,0\n"}, {pull_up, true});
    const std::string last = "\n10,0,0,0,0,";
    const std::size_t at = traces.front().find(last);
    REQUIRE(at != std::string::npos);
    return traces.front().substr(at + last.size(), 3);
}

}  // namespace

TEST_CASE("a sketch for Arduino boards is the reference") {
    check_language(run_arduino, 960'000, 160, false);
}

TEST_CASE("so it is with contacts to ground and the pull-up resistors of the board") {
    check_language(run_pulled_up, 961'000, 40, false);
}

TEST_CASE("left open, Init, AUdur and AUdoux are 0; with pull-up resistors so are all inputs") {
    CHECK(steps_with_open_pins(false) == "0,1");
    CHECK(steps_with_open_pins(true) == "1,0");
}

TEST_CASE("names of charts stay in sketches, but for those that Arduino.h takes") {
    const auto grafcet = read_grafcet(
        "input MOTEUR, \"épais\", S1, KM12, B1, PORTB, PM1, word\noutput F_CPU, MAX\n"
        "graph G { initial 0 : F_CPU, MAX if MOTEUR . \"épais\" . S1 . KM12 . B1 . PORTB . PM1 . "
        "word }\n");
    REQUIRE(grafcet);
    const std::string sketch = written("arduino", *grafcet, program_from(*grafcet, {}));
    CHECK(contains(sketch,
                   "//   epais    épais\n//   B1_2     B1\n//   PORTB_2  PORTB\n"
                   "//   word_2   word\n//   F_CPU_2  F_CPU\n\n"));
    CHECK(contains(sketch,
                   "const uint8_t in_MOTEUR = 2;\nconst uint8_t in_epais = 3;\n"
                   "const uint8_t in_S1 = 4;\nconst uint8_t in_KM12 = 5;\n"));
}

}  // namespace grafwire::testing
