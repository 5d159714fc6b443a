// An S7-200 listing as a device of the check.
//
// Most of a controller's memory does not matter between two scans: tables that every
// scan clears, and bits that are written before they are read. What can be read before it is
// written is alive (a backward data-flow analysis of the listing, Machine::live_at_start), a mask
// per byte; only that is packed into the memory that the check keeps and compares, besides timers,
// counters and the memories of edges. Otherwise states that differ in nothing but leftovers would
// be explored one by one.
//
// Unassigned inputs are bits of the input image that are not known. An unknown bit among what is
// compared or alive names one of them (Signal::cause), and the check decides it.

#include "s7check/listing_device.h"

#include <algorithm>

#include "text/packed_bytes.h"

namespace grafwire {

namespace {

constexpr std::uint32_t no_input = 0xffffffffU;

/// What the check reads after a scan: it counts as read at the end of every scan.
std::vector<s7::Operand> observed_of(const s7::Binding& binding) {
    std::vector<s7::Operand> observed;
    for (const auto* list : {&binding.steps, &binding.outputs}) {
        for (const auto& operand : *list) observed.push_back(*operand);
    }
    return observed;
}

std::size_t image_bit(const s7::Operand& operand) {
    return static_cast<std::size_t>(operand.address) * 8 + operand.bit;
}

void append_timer(std::string& memory, const s7::TimerState& timer) {
    append_packed(memory, timer.current);
    append_packed(memory, timer.elapsed);
    append_packed(memory, timer.bit);
    append_packed(memory, timer.running);
}

void take_timer(PackedReader& reader, s7::TimerState& timer) {
    reader.take(timer.current);
    reader.take(timer.elapsed);
    reader.take(timer.bit);
    reader.take(timer.running);
}

}  // namespace

ListingDevice::ListingDevice(const s7::Listing& listing, s7::Cpu cpu, const s7::Binding& binding)
    : binding_(binding),
      machine_(listing, cpu),
      blank_(machine_.start()),
      alive_(machine_.live_at_start(observed_of(binding))),
      input_of_bit_(s7::InputImage::bytes * 8, no_input) {
    for (std::size_t i = 0; i < alive_.size(); ++i) {
        if (alive_[i] != 0) alive_bytes_.push_back(i);
    }
    for (std::uint32_t i = 0; i < binding_.inputs.size(); ++i) {
        if (binding_.inputs[i]) input_of_bit_[image_bit(*binding_.inputs[i])] = i;
    }
}

bool ListingDevice::has_modes() const {
    return std::any_of(binding_.inputs.end() - control_input_count, binding_.inputs.end(),
                       [](const auto& operand) { return operand.has_value(); });
}

/// An input without an address cannot change anything in the listing, and has no bit.
s7::InputImage ListingDevice::image_of(const PartialInputs& inputs) const {
    s7::InputImage image;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!binding_.inputs[i]) continue;
        const std::size_t bit = image_bit(*binding_.inputs[i]);
        const auto mask = static_cast<std::uint8_t>(1U << bit % 8);
        std::uint8_t& value = image.value[bit / 8];
        std::uint8_t& known = image.known[bit / 8];
        if (inputs[i] == PartialInput::one) value = static_cast<std::uint8_t>(value | mask);
        if (inputs[i] == PartialInput::unassigned) known = static_cast<std::uint8_t>(known & ~mask);
    }
    return image;
}

ScannedDevice::Outcome ListingDevice::scan(const std::string& memory, const PartialInputs& inputs,
                                           Time now) const {
    Outcome outcome;
    s7::MachineState state = unpacked(memory);
    const s7::Machine::ScanEnd end = machine_.scan(state, image_of(inputs), now);
    if (end.error) {
        outcome.stop = Stop{end.error->network, end.error->where, end.error->message};
        outcome.steps.assign(binding_.steps.size(), Logic::unknown);
        outcome.outputs.assign(binding_.outputs.size(), Logic::unknown);
        return outcome;
    }
    std::optional<std::uint32_t> needed = end.needs;
    if (!needed) needed = observe(state, outcome);
    if (!needed) needed = unknown_alive(state);
    if (needed) {
        outcome.needs = input_of_bit_[*needed];
        return outcome;
    }
    outcome.memory = packed(state);
    return outcome;
}

/// Reads X and outputs; returns an open input on which one of them depends.
std::optional<std::uint32_t> ListingDevice::observe(const s7::MachineState& state,
                                                    Outcome& outcome) const {
    const auto read = [&](const std::vector<std::optional<s7::Operand>>& operands,
                          std::vector<Logic>& values) -> std::optional<std::uint32_t> {
        for (const auto& operand : operands) {
            const s7::Signal bit = machine_.bit(state, *operand);
            if (!bit.is_known()) return bit.cause;
            values.push_back(bit.value);
        }
        return std::nullopt;
    };
    if (const auto needed = read(binding_.steps, outcome.steps)) return needed;
    return read(binding_.outputs, outcome.outputs);
}

/// An open input on which a bit depends that is alive at the start of the next scan.
std::optional<std::uint32_t> ListingDevice::unknown_alive(const s7::MachineState& state) const {
    for (const std::size_t byte : alive_bytes_) {
        for (std::uint8_t bit = 0; bit < 8; ++bit) {
            if ((alive_[byte] >> bit & 1U) == 0) continue;
            const s7::Signal seen = machine_.memory_bit_after(state, byte * 8 + bit);
            if (!seen.is_known()) return seen.cause;
        }
    }
    return std::nullopt;
}

/// The time of the last scan, then what is alive: see key().
std::string ListingDevice::packed(const s7::MachineState& state) const {
    std::string memory;
    append_packed(memory, state.last_scan);
    for (const std::size_t byte : alive_bytes_) {
        memory += static_cast<char>(state.memory[byte] & alive_[byte]);
    }
    for (const s7::TimerState& timer : state.timers) append_timer(memory, timer);
    for (const s7::TimerState& counter : state.counters) append_timer(memory, counter);
    memory.append(state.edges.begin(), state.edges.end());
    return memory;
}

/// What is not alive may be anything; it is as in a controller that has just been switched on.
s7::MachineState ListingDevice::unpacked(const std::string& memory) const {
    s7::MachineState state = blank_;
    if (memory.empty()) return state;
    PackedReader reader(memory);
    state.first_scan = false;
    reader.take(state.last_scan);
    for (const std::size_t byte : alive_bytes_) reader.take(state.memory[byte]);
    for (s7::TimerState& timer : state.timers) take_timer(reader, timer);
    for (s7::TimerState& counter : state.counters) take_timer(reader, counter);
    for (std::uint8_t& edge : state.edges) reader.take(edge);
    return state;
}

std::string ListingDevice::key(const std::string& memory, Time) const {
    // What has elapsed of a timer is kept as of the last scan, which is now.
    return memory.substr(std::min(memory.size(), sizeof(Time)));
}

}  // namespace grafwire
