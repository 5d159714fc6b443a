// Sketches compiled by the compiler of the Arduino IDE for an Arduino Mega 2560, with the board's
// own functions for pins, and executed by simavr instruction by instruction, are the reference. The
// clock is the only part that is not the board's: it stands still within a scan, so that scans are
// at the very moments of the reference.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "random/random_cases.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What board and simulator share: the place of `Shared` is in GPIOR1 and GPIOR2; GPIOR0 is 1 when
/// a scan is over and becomes 2 when the next may begin.
constexpr const char* shared_h = R"(
#include <stdint.h>
struct __attribute__((packed)) Shared {
    uint32_t now;
    uint16_t steps;          // where the table of the steps is
    uint16_t registers[70];  // per pin, its input register; direction and output are next to it
    uint8_t masks[70];
};
)";

constexpr const char* simulated_board = R"(
#include <Arduino.h>
#include "sketch.ino"
#include "shared.h"

static struct Shared shared;

unsigned long micros() {
    return shared.now;
}
void delay(unsigned long) {}

static void wait_for_scan() {
    GPIOR0 = 1;
    while (GPIOR0 != 2) {}
}

int main() {
    for (uint8_t pin = 0; pin < 70; ++pin) {
        shared.registers[pin] = (uint16_t)portInputRegister(digitalPinToPort(pin));
        shared.masks[pin] = digitalPinToBitMask(pin);
    }
    shared.steps = (uint16_t)&chart.Ts;
    GPIOR1 = (uint16_t)&shared & 0xff;
    GPIOR2 = (uint16_t)&shared >> 8;
    wait_for_scan();
    setup();
    for (;;) {
        loop();
        wait_for_scan();
    }
}
)";

/// Runs a program with as many inputs, steps and outputs. Inputs are contacts, to ground from
/// PULLED_UP on, and to 5 V before.
constexpr const char* simulator = R"(
#include <simavr/avr_ioport.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "shared.h"

static avr_t* avr;
enum { gpior0 = 0x3e, gpior1 = 0x4a, gpior2 = 0x4b };

static void require(bool holds) {
    if (!holds) abort();
}
static void say_nothing(avr_t*, const int, const char*, va_list) {}
// One instruction. Where a skip passes over ADIW or SBIW, simavr 1.6 takes some of them for a CALL,
// which has two words, and passes over the instruction behind as well.
static void run_instruction() {
    const avr_flashaddr_t at = avr->pc;
    const uint8_t next = avr->flash[at + 3];
    const int state = avr_run(avr);
    require(state != cpu_Done && state != cpu_Crashed);
    if (avr->pc == at + 6 && (next == 0x96 || next == 0x97)) avr->pc -= 2;
}
static void run_until_ready() {
    for (long n = 0; avr->data[gpior0] != 1; ++n) {
        require(n < 10000000);
        run_instruction();
    }
}
static Shared shared() {
    Shared copy;
    memcpy(&copy, avr->data + (avr->data[gpior1] | avr->data[gpior2] << 8), sizeof copy);
    return copy;
}
static void set_level(unsigned input_register, uint8_t mask, bool level) {
    const char port = input_register < 0x100 ? "ABCDEFG"[(input_register - 0x20) / 3]
                                             : "HJKL"[(input_register - 0x100) / 3];
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(port), __builtin_ctz(mask)), level);
}

int main(int, char** argv) {
    const int inputs = atoi(argv[2]), steps = atoi(argv[3]), outputs = atoi(argv[4]);
    const int pulled_up = atoi(argv[5]);
    avr_global_logger_set(say_nothing);
    elf_firmware_t firmware = {};
    require(elf_read_firmware(argv[1], &firmware) == 0);
    avr = avr_make_mcu_by_name("atmega2560");
    require(avr != nullptr);
    avr_init(avr);
    avr_load_firmware(avr, &firmware);
    run_until_ready();
    const Shared board = shared();
    char text[40];
    while (getchar() != '\n') {}
    while (scanf("%39[0-9.]", text) == 1) {
        const uint32_t now = (uint32_t)(strtod(text, 0) * 1000 + 0.5);
        memcpy(avr->data + (avr->data[gpior1] | avr->data[gpior2] << 8), &now, sizeof now);
        printf("%s", text);
        for (int i = 0; i < inputs; ++i) {
            int closed;
            require(scanf(",%d", &closed) == 1);
            printf(",%d", closed);
            set_level(board.registers[2 + i], board.masks[2 + i], closed != (i >= pulled_up));
        }
        getchar();
        avr->data[gpior0] = 2;
        run_until_ready();
        for (int s = 0; s < steps; ++s) {
            printf(",%d", avr->data[board.steps + s / 8] >> (s % 8) & 1);
        }
        for (int i = 0; i < inputs + outputs; ++i) {
            const uint8_t* registers = avr->data + board.registers[2 + i];
            const bool is_output = registers[1] & board.masks[2 + i];
            const bool level = registers[2] & board.masks[2 + i];
            require(is_output == (i >= inputs));
            if (is_output) {
                printf(",%d", level);
            } else {
                require(level == (i >= pulled_up));  // its pull-up resistor
            }
        }
        putchar('\n');
    }
}
)";

const std::string arduino_folder = "/usr/share/arduino/hardware/arduino/avr";

/// The compiler and its options, as the Arduino IDE calls it.
std::vector<std::string> board_compiler(const std::string& name) {
    return {name,
            "-mmcu=atmega2560",
            "-DF_CPU=16000000L",
            "-DARDUINO=10807",
            "-Os",
            "-Wall",
            "-Wextra",
            "-I" + arduino_folder + "/cores/arduino",
            "-I" + arduino_folder + "/variants/mega"};
}

void compile_with(std::vector<std::string> command, const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
    compile(command);
}

/// What all sketches have in common, compiled once.
class Workshop {
  public:
    Workshop() {
        folder_.file("shared.h", shared_h);
        compile({"g++", "-O1", folder_.file("simulator.cpp", simulator), "-lsimavr", "-o",
                 folder_.path("simulator")});
        compile_with(
            board_compiler("avr-gcc"),
            {"-w", "-c", arduino_folder + "/cores/arduino/wiring_digital.c", "-o", pins()});
    }
    std::string pins() const { return folder_.path("pins.o"); }
    std::string simulator_program() const { return folder_.path("simulator"); }

  private:
    ScratchFolder folder_;
};

std::vector<std::string> run_simulated(const Grafcet& grafcet, const ScanProgram& program,
                                       const std::vector<std::string>& scans) {
    static const Workshop workshop;
    const ScratchFolder folder;
    folder.file("sketch.ino", written("arduino", grafcet, program));
    folder.file("shared.h", shared_h);
    const std::string firmware = folder.path("board.elf");
    // A random chart may compare a sum with itself.
    compile_with(board_compiler("avr-g++"),
                 {"-std=gnu++11", "-Werror", "-Wno-tautological-compare", "-I" + folder.path(""),
                  folder.file("board.cpp", simulated_board), workshop.pins(), "-o", firmware});
    std::vector<std::string> traces = run_on(
        {workshop.simulator_program(), firmware, fmt::format("{}", grafcet.all_input_count()),
         fmt::format("{}", grafcet.steps.size()), fmt::format("{}", grafcet.outputs.size()),
         fmt::format("{}", grafcet.inputs.size())},
        scans);
    for (std::string& trace : traces) trace.insert(0, heading_without_internals(grafcet));
    return traces;
}

}  // namespace

TEST_CASE("a sketch on a simulated Arduino Mega is the reference") {
    for (const std::string& name : example_names()) {
        INFO("example " << name);
        CHECK(compare_with_reference(example_case(name), run_simulated, false, {},
                                     {100 * millisecond}) == "");
    }
    check_property(
        [](const RandomCase& item) {
            return compare_with_reference(item, run_simulated, false, {}, {10 * millisecond});
        },
        Features(), 962'000, 20, 15);
}

}  // namespace grafwire::testing
