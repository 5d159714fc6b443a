// The objects of PL7-2: what there are of them, and which stand for what.
//
// A step keeps its number where it has one from 0 to 95, so that the listing and the animation on
// the terminal show the chart's own numbers; `05` is no number, for X5 might be another step.
// Everything else takes the next object that is free, in the order in which the writers ask.
// Whether there were enough is told once at the end (check_limits), with the number that would be
// needed.

#include "plc/pl7/pl7_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "plc/pl7/messages.h"
#include "program/bit_names.h"
#include "program/messages.h"
#include "text/counted.h"

namespace grafwire {

namespace {

/// The number of a step that is called by one; empty for `05`, `s1`, and numbers without a bit X.
std::optional<std::uint32_t> own_number(std::string_view name) {
    if (name.empty() || name.size() > 2 || (name.size() > 1 && name[0] == '0')) return std::nullopt;
    std::uint32_t number = 0;
    for (const char c : name) {
        if (c < '0' || c > '9') return std::nullopt;
        number = number * 10 + static_cast<std::uint32_t>(c - '0');
    }
    if (number >= Pl7Objects::steps) return std::nullopt;
    return number;
}

}  // namespace

std::optional<Pl7Preset> pl7_preset(Time duration) {
    struct Base {
        const char* name;
        Time length;
    };
    static constexpr Base bases[] = {
        {"10ms", 10 * millisecond}, {"100ms", 100 * millisecond}, {"1s", second}, {"1mn", minute}};
    for (const Base& base : bases) {
        const Time count = duration / base.length;
        if (duration % base.length == 0 && count >= 1 && count <= 9999) {
            return Pl7Preset{base.name, count};
        }
    }
    return std::nullopt;
}

Pl7Objects::Pl7Objects(const Grafcet& grafcet, const ScanProgram& program)
    : grafcet_(grafcet), program_(program) {
    number_steps();
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) of(Bit{BitKind::var, v});
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) of(IntegerCell{false, c});
}

/// Steps without a number of their own get the lowest ones left; those that are not of the chart
/// come last.
void Pl7Objects::number_steps() {
    std::set<std::uint32_t> taken;
    for (const Step& step : grafcet_.steps) {
        if (const auto number = own_number(step.name)) taken.insert(*number);
    }
    std::uint32_t next = 0;
    const auto lowest_left = [&] {
        while (!taken.insert(next).second) ++next;
        return next;
    };
    for (const Step& step : grafcet_.steps) {
        const auto number = own_number(step.name);
        step_numbers_.push_back(number ? *number : lowest_left());
    }
    const auto any = [&](auto&& holds) {
        return std::any_of(grafcet_.transitions.begin(), grafcet_.transitions.end(), holds);
    };
    if (any([](const Transition& transition) { return transition.preceding.count == 0; })) {
        source_step_ = fmt::format("X{}", lowest_left());
    }
    if (any([](const Transition& transition) { return transition.following.count == 0; })) {
        sink_step_ = fmt::format("X{}", lowest_left());
    }
}

std::string Pl7Objects::at_module(char letter, std::uint32_t index, std::uint32_t size) {
    return fmt::format("{}{},{}", letter, index / size, index % size);
}

std::string Pl7Objects::of(Bit bit) {
    switch (bit.kind) {
        case BitKind::input:
            return at_module('I', bit.index, inputs_of_a_module);
        case BitKind::control:
            return at_module('I', static_cast<std::uint32_t>(grafcet_.inputs.size()) + bit.index,
                             inputs_of_a_module);
        case BitKind::output:
            return at_module('O', bit.index, outputs_of_a_module);
        case BitKind::step:
            return fmt::format("X{}", step_numbers_[bit.index]);
        default:
            break;
    }
    const auto found = names_.find(bit);
    if (found != names_.end()) return found->second;
    return names_.emplace(bit, new_bit()).first->second;
}

std::string Pl7Objects::of(IntegerCell cell) {
    const auto found = word_names_.find(cell);
    if (found != word_names_.end()) return found->second;
    return word_names_.emplace(cell, new_word()).first->second;
}

std::vector<std::pair<std::string, std::string>> Pl7Objects::assignment() {
    std::vector<std::pair<std::string, std::string>> rows;
    const auto add_bits = [&](BitKind kind, std::size_t count, std::string_view before = "") {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Bit bit{kind, i};
            rows.emplace_back(of(bit), fmt::format("{}{}", before, name_in_chart(grafcet_, bit)));
        }
    };
    add_bits(BitKind::input, grafcet_.inputs.size());
    if (program_.has_modes) add_bits(BitKind::control, control_input_count);
    add_bits(BitKind::output, grafcet_.outputs.size());
    add_bits(BitKind::var, grafcet_.vars.size());
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        rows.emplace_back(of(IntegerCell{false, c}), grafcet_.counters[CounterId{c}].name);
    }
    add_bits(BitKind::step, grafcet_.steps.size(), "X");
    return rows;
}

void Pl7Objects::check_limits(Diagnostics& diagnostics) const {
    namespace counted = messages::counted;
    const auto check = [&](std::size_t used, std::size_t there_are, const CountedMessage<>& what) {
        if (used <= there_are) return;
        diagnostics.error(code::unsupported_by_language, {},
                          messages::plc_pl7::needs_too_many(what(used), there_are));
    };
    const std::size_t inputs =
        grafcet_.inputs.size() + (program_.has_modes ? control_input_count : 0);
    check(inputs, inputs_of_a_module * modules, counted::inputs);
    check(grafcet_.outputs.size(), outputs_of_a_module * modules, counted::outputs);
    const std::size_t beside = (source_step_.empty() ? 0U : 1U) + (sink_step_.empty() ? 0U : 1U);
    check(grafcet_.steps.size() + beside, steps, counted::steps);
    check(bits_used_, bits, counted::internal_bits);
    check(words_used_, words, counted::words);
    check(timers_used_, timers, counted::timers);
}

}  // namespace grafwire
