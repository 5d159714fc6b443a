// A sketch for Arduino boards: the scan in C between `setup` and `loop`, and a table of pins at the
// head, which is what users edit.
//
// A pin that nothing is wired to is read as 0 or 1 by chance, and one AUdur of chance empties the
// chart. Who does not need Init, AUdur and AUdoux leaves them open, so these always have the
// pull-up resistors of the board and are 1 where a contact closes to ground.

#include <fmt/format.h>

#include <algorithm>

#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/shared/language_words.h"
#include "plc/shared/program_names.h"
#include "program/messages.h"

namespace grafwire {

namespace {

namespace say = messages::plc_computer;

/// 0 and 1 are the serial line.
constexpr std::size_t first_pin = 2;
/// Pins of the largest board that counts them from 0 on, an Arduino Mega 2560.
constexpr std::size_t pin_count = 70;

constexpr std::string_view clock_text = R"(
// @unending_clock
static int64_t clock_now() {
    static uint32_t last = 0;
    static int64_t sum = 0;
    const uint32_t now = micros();
    sum += (uint32_t)(now - last);
    last = now;
    return sum;
}
)";

class Sketch {
  public:
    Sketch(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options)
        : grafcet_(grafcet),
          options_(options),
          language_(options.language),
          core_(grafcet, program, {true, is_arduino_word}, options.language) {
        for (std::uint32_t o = 0; o < grafcet.outputs.size(); ++o) {
            outputs_.push_back({BitKind::output, o});
        }
    }

    std::size_t pins_needed() const { return core_.names().inputs().size() + outputs_.size(); }
    std::string write();

  private:
    void explain_pins();
    void write_pins();
    void write_pin_functions();
    void write_setup();
    void write_loop();
    /// Whether an input is a contact to ground, of the pull-up resistor of its pin.
    bool is_pulled_up(Bit input) const {
        return options_.pull_up || input.kind == BitKind::control;
    }
    /// The constant that holds the pin of an input or output.
    std::string pin(Bit bit) const {
        return (bit.kind == BitKind::output ? "out_" : "in_") + core_.names()[bit];
    }

    const Grafcet& grafcet_;
    const PlcOptions& options_;
    Language language_;
    CCore core_;
    std::vector<Bit> outputs_;
    SourceText out_{"//"};
};

std::string Sketch::write() {
    write_title(out_, grafcet_, say::sketch(), options_);
    write_changed_names(out_, core_.names(), language_);
    out_.blank();
    out_.block("#include <Arduino.h>\n#include <stdint.h>\n#include <string.h>\n\n");
    write_pins();
    out_.blank();
    out_.block(core_.types());
    out_.blank();
    out_.line(fmt::format("static {}_grafcet chart;", core_.names().chart()));
    out_.line(fmt::format("static {}_inputs inputs;", core_.names().chart()));
    out_.block(core_.functions());
    out_.block(with_texts(clock_text, {{"@unending_clock", say::unending_clock.in(language_)}}));
    write_pin_functions();
    write_setup();
    write_loop();
    return out_.take();
}

void Sketch::explain_pins() {
    const std::vector<Bit> inputs = core_.names().inputs();
    out_.comment(say::pins.in(language_));
    if (inputs.empty()) return;
    if (options_.pull_up) return out_.comment(say::inputs_pulled_up.in(language_));
    // The declared inputs come first.
    if (inputs.front().kind == BitKind::input) out_.comment(say::inputs_driven.in(language_));
    if (inputs.back().kind == BitKind::control) out_.comment(say::modes_pulled_up.in(language_));
}

void Sketch::write_pins() {
    explain_pins();
    std::size_t next = first_pin;
    for (const Bit bit : core_.names().inputs()) {
        out_.line(fmt::format("const uint8_t {} = {};", pin(bit), next++));
    }
    for (const Bit bit : outputs_) {
        out_.line(fmt::format("const uint8_t {} = {};", pin(bit), next++));
    }
}

void Sketch::write_pin_functions() {
    const ProgramNames& names = core_.names();
    out_.blank();
    out_.line("static void read_inputs() {");
    out_.indent();
    for (const Bit bit : names.inputs()) {
        out_.line(fmt::format("inputs.{} = digitalRead({}) == {};", names[bit], pin(bit),
                              is_pulled_up(bit) ? "LOW" : "HIGH"));
    }
    out_.outdent();
    out_.line("}");
    out_.blank();
    out_.line("static void write_outputs() {");
    out_.indent();
    for (const Bit bit : outputs_) {
        out_.line(
            fmt::format("digitalWrite({}, chart.outputs.{} ? HIGH : LOW);", pin(bit), names[bit]));
    }
    out_.outdent();
    out_.line("}");
}

void Sketch::write_setup() {
    const std::vector<Bit> inputs = core_.names().inputs();
    out_.blank();
    out_.line("void setup() {");
    out_.indent();
    for (const Bit bit : inputs) {
        out_.line(fmt::format("pinMode({}, {});", pin(bit),
                              is_pulled_up(bit) ? "INPUT_PULLUP" : "INPUT"));
    }
    for (const Bit bit : outputs_) out_.line(fmt::format("pinMode({}, OUTPUT);", pin(bit)));
    if (std::any_of(inputs.begin(), inputs.end(),
                    [this](Bit input) { return is_pulled_up(input); })) {
        out_.comment(say::until_charged.in(language_));
        out_.line("delay(1);");
    }
    out_.line("read_inputs();");
    out_.line(fmt::format("{}_start(&chart, &inputs);", core_.names().chart()));
    out_.outdent();
    out_.line("}");
}

void Sketch::write_loop() {
    out_.blank();
    out_.comment(say::one_scan.in(language_));
    out_.line("void loop() {");
    out_.indent();
    out_.line("read_inputs();");
    out_.line(fmt::format("{}_scan(&chart, &inputs, clock_now());", core_.names().chart()));
    out_.line("write_outputs();");
    out_.outdent();
    out_.line("}");
}

}  // namespace

std::string write_arduino(const Grafcet& grafcet, const ScanProgram& program,
                          const PlcOptions& options, Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "C", diagnostics)) return {};
    Sketch sketch(grafcet, program, options);
    constexpr std::size_t most = pin_count - first_pin;
    if (sketch.pins_needed() > most) {
        const auto& message =
            program.has_modes ? say::too_many_pins_with_modes : say::too_many_pins;
        diagnostics.error(code::beyond_limit, {}, message(sketch.pins_needed(), most));
        return {};
    }
    return sketch.write();
}

}  // namespace grafwire
