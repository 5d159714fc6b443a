// The names of a GRAFCET and the addresses that stand for them in a listing, from a table of
// assignment; and without a GRAFCET, from the table or the listing alone, the names there are.

#include "s7/machine/binding.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "s7/machine/decoded.h"
#include "s7/machine/messages.h"
#include "text/nearest_name.h"
#include "text/utf8.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_machine;

/// What an address must be to stand for a name.
enum class Wanted : std::uint8_t { input_bit, bit, word };

bool fits(const Operand& operand, Wanted wanted) {
    switch (wanted) {
        case Wanted::input_bit:
            return operand.area == Area::input && operand.width == Width::bit;
        case Wanted::bit:
            return operand.width == Width::bit;
        case Wanted::word:
            return operand.width != Width::bit || operand.area == Area::counter;
    }
    return false;
}

Localized text_of(Wanted wanted) {
    switch (wanted) {
        case Wanted::input_bit:
            return say::an_input_bit();
        case Wanted::bit:
            return say::a_bit();
        case Wanted::word:
            return say::a_word();
    }
    return {};
}

class Binder {
  public:
    Binder(const Grafcet& grafcet, Diagnostics& diagnostics)
        : grafcet_(grafcet), diagnostics_(diagnostics) {
        for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
            declare(std::string(input_name(grafcet, i)), binding_.inputs, Wanted::input_bit);
        }
        for (const Step& step : grafcet.steps) {
            declare("X" + step.name, binding_.steps, Wanted::bit);
        }
        for (const Output& output : grafcet.outputs) {
            declare(output.name, binding_.outputs, Wanted::bit);
        }
        for (const Var& var : grafcet.vars) declare(var.name, binding_.vars, Wanted::bit);
        for (const Counter& counter : grafcet.counters) {
            declare(counter.name, binding_.counters, Wanted::word);
        }
        for (const Transition& transition : grafcet.transitions) {
            declare("(" + transition.name + ")", binding_.transitions, Wanted::bit);
        }
        for (const Graph& graph : grafcet.graphs) {
            declare(graph.name, binding_.graphs, Wanted::bit);
        }
    }

    void assign(const IoAssignment::Entry& entry) {
        const auto found = slots_.find(entry.name);
        if (found == slots_.end()) {
            report_unknown(entry);
            return;
        }
        const Slot& slot = found->second;
        if (!fits(entry.operand, slot.wanted)) {
            diagnostics_.error(code::bad_address, entry.where,
                               say::wrong_address(write_operand(entry.operand, Mnemonics::simatic),
                                                  shortened(entry.name), text_of(slot.wanted)));
            return;
        }
        (*slot.list)[slot.index] = entry.operand;
    }

    /// Every step, output and declared input needs an address; the rest may do without.
    Binding finish() {
        for (std::size_t i = 0; i < grafcet_.inputs.size(); ++i) {
            require(binding_.inputs[i], say::input_without_address, input_name(grafcet_, i));
        }
        for (std::size_t i = 0; i < binding_.steps.size(); ++i) {
            require(binding_.steps[i], say::step_without_address,
                    "X" + grafcet_.steps[static_cast<StepId>(i)].name);
        }
        for (std::size_t i = 0; i < binding_.outputs.size(); ++i) {
            require(binding_.outputs[i], say::output_without_address,
                    grafcet_.outputs[static_cast<OutputId>(i)].name);
        }
        return std::move(binding_);
    }

  private:
    struct Slot {
        std::vector<std::optional<Operand>>* list = nullptr;
        std::size_t index = 0;
        Wanted wanted = Wanted::bit;
    };

    void declare(std::string name, std::vector<std::optional<Operand>>& list, Wanted wanted) {
        slots_.emplace(std::move(name), Slot{&list, list.size(), wanted});
        list.emplace_back();
    }

    std::string_view suggestion(const std::string& name) {
        if (++suggestion_count_ > most_suggestions) return {};
        std::vector<std::string_view> names;
        for (const auto& [known, slot] : slots_) names.push_back(known);
        std::sort(names.begin(), names.end());
        return nearest_name(name, names);
    }

    void report_unknown(const IoAssignment::Entry& entry) {
        const std::string_view nearest = suggestion(entry.name);
        const std::string shown = shortened(entry.name);
        diagnostics_.error(code::unknown_name, entry.where,
                           nearest.empty() ? say::not_in_the_grafcet(shown)
                                           : say::not_in_the_grafcet_near(shown, nearest));
    }

    void require(const std::optional<Operand>& operand, const Message<std::string_view>& message,
                 std::string_view name) {
        if (!operand) diagnostics_.error(code::bad_address, {}, message(name));
    }

    const Grafcet& grafcet_;
    Diagnostics& diagnostics_;
    Binding binding_;
    std::unordered_map<std::string, Slot> slots_;
    std::size_t suggestion_count_ = 0;
};

bool is_control(std::string_view name) {
    return name == "Init" || name == "AUdur" || name == "AUdoux";
}

bool is_freeze_bit(const Operand& operand) {
    return operand.area == Area::variable && operand.width == Width::bit && operand.address <= 1;
}

}  // namespace

std::optional<Binding> bind(const Grafcet& grafcet, const IoAssignment& io,
                            Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    Binder binder(grafcet, diagnostics);
    for (const IoAssignment::Entry& entry : io.entries) binder.assign(entry);
    Binding binding = binder.finish();
    diagnostics.sort_by_place();
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return binding;
}

bool is_shown(const IoAssignment::Entry& entry) {
    return !entry.name.starts_with('(') && !is_freeze_bit(entry.operand);
}

Grafcet names_of(const IoAssignment& io) {
    Grafcet grafcet;
    for (const IoAssignment::Entry& entry : io.entries) {
        const Operand& operand = entry.operand;
        if (is_control(entry.name) || !is_shown(entry)) continue;
        if (operand.width != Width::bit || operand.area == Area::counter) {
            Counter counter;
            counter.name = entry.name;
            counter.low = INT16_MIN;
            counter.high = INT16_MAX;
            grafcet.counters.add(counter);
        } else if (operand.area == Area::input) {
            grafcet.inputs.add({entry.name, entry.where});
        } else if (operand.area == Area::output) {
            grafcet.outputs.add({entry.name, false, entry.where});
        } else if (entry.name.starts_with('X') && entry.name.size() > 1) {
            Step step;
            step.name = entry.name.substr(1);
            grafcet.steps.add(step);
        } else {
            grafcet.vars.add({entry.name, entry.where});
        }
    }
    return grafcet;
}

namespace {

/// How many bits an instruction takes from where an operand of it begins.
std::int32_t bits_taken(const Instruction& instruction, const Operand& operand) {
    const std::int32_t bits =
        operand.width == Width::bit ? 1 : 8 * static_cast<std::int32_t>(bytes_of(operand.width));
    switch (instruction.operation) {
        case Operation::set:
        case Operation::reset:
            return instruction.operands[1].address;
        case Operation::fill:
        case Operation::block_move:
            return bits * instruction.operands[2].address;
        default:
            return bits;
    }
}

/// The bit so many bits after the one with which an operand begins.
Operand bit_after(Operand operand, std::int32_t distance) {
    const std::int32_t bit = operand.bit + distance;
    operand.width = Width::bit;
    operand.address += bit / 8;
    operand.bit = static_cast<std::uint8_t>(bit % 8);
    return operand;
}

void add_image_bits(const Instruction& instruction, std::set<Operand>& bits) {
    for (const Operand& operand : instruction.operands) {
        if (operand.area != Area::input && operand.area != Area::output) continue;
        const std::int32_t count = bits_taken(instruction, operand);
        for (std::int32_t i = 0; i < count; ++i) bits.insert(bit_after(operand, i));
    }
}

}  // namespace

IoAssignment addresses_of(const Listing& listing) {
    std::set<Operand> bits;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            add_image_bits(instruction, bits);
        }
    }
    IoAssignment io;
    for (const Operand& bit : bits) {
        io.entries.push_back({bit, write_operand(bit, Mnemonics::simatic), {}});
    }
    return io;
}

InputImage image_of(const Binding& binding, const InputValues& inputs) {
    InputImage image;
    for (std::size_t i = 0; i < binding.inputs.size(); ++i) {
        if (!binding.inputs[i] || inputs[i] == 0) continue;
        std::uint8_t& byte = image.value[static_cast<std::size_t>(binding.inputs[i]->address)];
        byte = static_cast<std::uint8_t>(byte | 1U << binding.inputs[i]->bit);
    }
    return image;
}

}  // namespace grafwire::s7
