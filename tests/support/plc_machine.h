#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "plc/formats.h"
#include "program/program.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// What a written program is not allowed to be, with its line: a text that the language refuses, a
/// value out of the range of its type, an index beyond its array.
struct PlcError : std::runtime_error {
    PlcError(std::size_t line, const std::string& message)
        : std::runtime_error("line " + std::to_string(line) + ": " + message) {}
};

/// A controller with a program in it.
class PlcMachine {
  public:
    virtual ~PlcMachine() = default;

    /// Declared inputs first, then Init, AUdur, AUdoux.
    virtual void set_input(std::uint32_t index, bool value) = 0;
    virtual void scan(Time now) = 0;
    virtual bool step(std::uint32_t index) const = 0;
    virtual bool output(std::uint32_t index) const = 0;
    virtual bool var(std::uint32_t index) const = 0;
    virtual std::int64_t counter(std::uint32_t index) const = 0;
};

/// Makes a machine for a program text; throws PlcError where the text is not one.
using MachineMaker =
    std::function<std::unique_ptr<PlcMachine>(const std::string& text, const Grafcet& grafcet)>;

/// Runs a program over stimuli, a scan every period; the trace has the reference's columns.
Trace run_machine(PlcMachine& machine, const Grafcet& grafcet, const Stimuli& stimuli, Time period);

/// A language under test.
struct PlcLanguage {
    const char* format = "";  ///< its name in plc_formats()
    MachineMaker make;
    PlcOptions options;
};

/// Writes the program of a chart, runs it, and compares it with the reference at two periods. Empty
/// where they agree, or where the writer refuses the chart (`refused`, if not null, counts that; a
/// refusal without a message is a fault).
std::string difference(const PlcLanguage& language, const Grafcet& grafcet, const Stimuli& stimuli,
                       const std::vector<Time>& periods, std::size_t* refused = nullptr);

/// Every example of examples/ over its stimuli; the number of those refused.
std::size_t check_examples(const PlcLanguage& language);

}  // namespace grafwire::testing
