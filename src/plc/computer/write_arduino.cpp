// A sketch for Arduino boards: the scan in C between `setup` and `loop`, and a table of pins at the
// head, which is what users edit.

#include <fmt/format.h>

#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/shared/reserved_words.h"
#include "program/messages.h"

namespace grafwire {

namespace {

/// 0 and 1 are the serial line.
constexpr std::size_t first_pin = 2;
/// Pins of the largest board that counts them from 0 on, an Arduino Mega 2560.
constexpr std::size_t pin_count = 70;

constexpr std::string_view clock_text = R"(
// micros() starts again at 0 after 71 minutes; this clock does not, if it is read more often.
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
    Sketch(const Grafcet& grafcet, const ScanProgram& program)
        : grafcet_(grafcet), core_(grafcet, program, {true, is_arduino_word}) {
        for (std::uint32_t o = 0; o < grafcet.outputs.size(); ++o) {
            outputs_.push_back({BitKind::output, o});
        }
    }

    std::size_t pins_needed() const { return core_.names().inputs().size() + outputs_.size(); }
    std::string write();

  private:
    void write_pins();
    void write_functions();
    /// The constant that holds the pin of an input or output.
    std::string pin(Bit bit) const {
        return (bit.kind == BitKind::output ? "out_" : "in_") + core_.names()[bit];
    }

    const Grafcet& grafcet_;
    CCore core_;
    std::vector<Bit> outputs_;
    SourceText out_{"//"};
};

std::string Sketch::write() {
    write_title(out_, grafcet_, "a sketch for Arduino boards");
    write_changed_names(out_, core_.names());
    out_.blank();
    out_.block("#include <Arduino.h>\n#include <stdint.h>\n#include <string.h>\n\n");
    write_pins();
    out_.blank();
    out_.block(core_.types());
    out_.blank();
    out_.line(fmt::format("static {}_grafcet chart;", core_.names().chart()));
    out_.line(fmt::format("static {}_inputs inputs;", core_.names().chart()));
    out_.block(core_.functions());
    out_.block(clock_text);
    write_functions();
    return out_.take();
}

void Sketch::write_pins() {
    out_.comment("The pins: change them to suit the wiring. An input is 1 where its pin is HIGH.");
    std::size_t next = first_pin;
    for (const Bit bit : core_.names().inputs()) {
        out_.line(fmt::format("const uint8_t {} = {};", pin(bit), next++));
    }
    for (const Bit bit : outputs_) {
        out_.line(fmt::format("const uint8_t {} = {};", pin(bit), next++));
    }
}

void Sketch::write_functions() {
    const ProgramNames& names = core_.names();
    out_.blank();
    out_.line("static void read_inputs() {");
    out_.indent();
    for (const Bit bit : names.inputs()) {
        out_.line(fmt::format("inputs.{} = digitalRead({}) == HIGH;", names[bit], pin(bit)));
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
    out_.blank();
    out_.line("void setup() {");
    out_.indent();
    for (const Bit bit : names.inputs()) out_.line(fmt::format("pinMode({}, INPUT);", pin(bit)));
    for (const Bit bit : outputs_) out_.line(fmt::format("pinMode({}, OUTPUT);", pin(bit)));
    out_.line("read_inputs();");
    out_.line(fmt::format("{}_start(&chart, &inputs);", names.chart()));
    out_.outdent();
    out_.line("}");
    out_.blank();
    out_.comment("One scan.");
    out_.line("void loop() {");
    out_.indent();
    out_.line("read_inputs();");
    out_.line(fmt::format("{}_scan(&chart, &inputs, clock_now());", names.chart()));
    out_.line("write_outputs();");
    out_.outdent();
    out_.line("}");
}

}  // namespace

std::string write_arduino(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions&,
                          Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "C", diagnostics)) return {};
    Sketch sketch(grafcet, program);
    constexpr std::size_t most = pin_count - first_pin;
    if (sketch.pins_needed() > most) {
        const auto& message = program.has_modes ? messages::plc_computer::too_many_pins_with_modes
                                                : messages::plc_computer::too_many_pins;
        diagnostics.error(code::beyond_limit, {}, message(sketch.pins_needed(), most));
        return {};
    }
    return sketch.write();
}

}  // namespace grafwire
