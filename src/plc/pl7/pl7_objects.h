#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The preset of a PL7-2 timer: so many times its time base.
struct Pl7Preset {
    std::string base;  ///< `10ms`, `100ms`, `1s`, `1mn`
    std::int64_t count = 0;
};
/// Empty where no base and count from 1 to 9999 give exactly the duration.
std::optional<Pl7Preset> pl7_preset(Time duration);

/// The objects of PL7-2 that stand for the bits, integers and timers of a program: inputs I0,0 and
/// outputs O0,0 on, module by module; steps X0 to X95, under their own numbers where they have any;
/// internal bits B, words W and timers T in the order in which they are asked for.
class Pl7Objects {
  public:
    // What a TSX 17-20, the smallest controller with PL7-2, is taken to have.
    static constexpr std::uint32_t steps = 96;
    static constexpr std::uint32_t bits = 256;
    static constexpr std::uint32_t words = 128;
    static constexpr std::uint32_t timers = 32;
    static constexpr std::uint32_t inputs_of_a_module = 24;
    static constexpr std::uint32_t outputs_of_a_module = 16;
    static constexpr std::uint32_t modules = 4;

    Pl7Objects(const Grafcet& grafcet, const ScanProgram& program);

    std::string of(Bit bit);
    std::string of(IntegerCell cell);
    std::string new_bit() { return "B" + std::to_string(bits_used_++); }
    std::string new_word() { return "W" + std::to_string(words_used_++); }
    /// A bit that keeps part of a condition; number 0 of its kind is the bit of a cold start.
    Bit new_work_bit() { return {BitKind::auxiliary, ++work_bits_used_}; }
    /// A timer of its own; gives its name, `T3`.
    std::string new_timer() { return "T" + std::to_string(timers_used_++); }
    /// A step beside those of the chart that is always active, for its source transitions, and one
    /// that its sink transitions lead to: `X4`; empty where the chart has none.
    const std::string& source_step() const { return source_step_; }
    const std::string& sink_step() const { return sink_step_; }
    /// From now on this stands for the bit: `T3,D` for a time condition.
    void name(Bit bit, std::string object) { names_[bit] = std::move(object); }

    /// The declared objects, each with the chart's name for it, in the order of the chart.
    std::vector<std::pair<std::string, std::string>> assignment();

    /// An error for each kind of which more are in use than there are.
    void check_limits(Diagnostics& diagnostics) const;

  private:
    void number_steps();
    static std::string at_module(char letter, std::uint32_t index, std::uint32_t size);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    std::vector<std::uint32_t> step_numbers_;
    std::string source_step_, sink_step_;
    std::map<Bit, std::string> names_;
    std::map<IntegerCell, std::string> word_names_;
    std::uint32_t bits_used_ = 0;
    std::uint32_t words_used_ = 0;
    std::uint32_t work_bits_used_ = 0;
    std::uint32_t timers_used_ = 0;
};

}  // namespace grafwire
