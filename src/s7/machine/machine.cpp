// What the machine is from outside: its state between two scans, the image of the inputs, the time
// that passes, and what can be read after a scan.

#include "s7/machine/machine.h"

#include <algorithm>

#include "s7/machine/decoded.h"
#include "s7/machine/live_bits.h"
#include "s7/machine/machine_memory.h"
#include "s7/machine/scan_run.h"

namespace grafwire::s7 {

struct Machine::Parts {
    Parts(const Listing& listing, Cpu cpu)
        : program(std::make_shared<const Decoded>(listing, cpu)), memory(program->layout.bytes) {}
    std::shared_ptr<const Decoded> program;
    MachineMemory memory;
};

Machine::Machine(const Listing& listing, Cpu cpu) : parts_(std::make_unique<Parts>(listing, cpu)) {}
Machine::~Machine() = default;
Machine::Machine(const Machine& other) : parts_(std::make_unique<Parts>(*other.parts_)) {}
Machine::Machine(Machine&&) noexcept = default;
Machine& Machine::operator=(Machine&&) noexcept = default;

MachineState Machine::start() const {
    const Decoded& program = *parts_->program;
    MachineState state;
    state.memory.assign(program.layout.bytes, 0);
    state.timers.resize(program.timers.size());
    state.counters.resize(program.counters.size());
    state.edges.assign(program.edges, 0);
    return state;
}

Machine::ScanEnd Machine::scan(MachineState& state, const InputImage& inputs, Time now) {
    const Decoded& program = *parts_->program;
    MachineMemory& memory = parts_->memory;
    const Time passed = state.first_scan ? 0 : now - state.last_scan;
    for (std::size_t t = 0; t < state.timers.size(); ++t) {
        TimerState& timer = state.timers[t];
        if (!timer.running) continue;
        timer.elapsed = std::min(add_times(timer.elapsed, passed), program.timers[t].most);
    }
    memory.begin(state.memory);
    constexpr std::uint8_t always_one = 1;
    constexpr std::uint8_t one_at_first = 2;
    state.memory[program.layout.byte_of(Area::special, 0)] =
        state.first_scan ? always_one | one_at_first : always_one;
    for (std::size_t i = 0; i < InputImage::bytes; ++i) {
        memory.set_input(program.layout.byte_of(Area::input, static_cast<std::int32_t>(i)),
                         inputs.value[i], inputs.known[i], static_cast<std::uint16_t>(i * 8));
    }
    ScanEnd end = ScanRun(program, memory, state).run();
    state.first_scan = false;
    state.last_scan = now;
    return end;
}

Signal Machine::bit(const MachineState& state, const Operand& operand) const {
    const Place place = parts_->program->place_of(operand);
    switch (place.kind) {
        case Place::Kind::timer:
            return Signal::of(place.at < state.timers.size() && state.timers[place.at].bit);
        case Place::Kind::counter:
            return Signal::of(place.at < state.counters.size() && state.counters[place.at].bit);
        case Place::Kind::memory:
            return memory_bit_after(state, place.at * 8 + place.bit);
        case Place::Kind::constant:
            break;
    }
    return {};
}

Signal Machine::memory_bit_after(const MachineState& state, std::size_t memory_bit) const {
    const std::size_t byte = memory_bit / 8;
    const auto bit = static_cast<std::uint8_t>(memory_bit % 8);
    if (const auto cause = parts_->memory.open_cause(byte, bit)) return {Logic::unknown, *cause};
    return Signal::of((state.memory[byte] >> bit & 1U) != 0);
}

std::int32_t Machine::value(const MachineState& state, const Operand& operand) const {
    const Place place = parts_->program->place_of(operand);
    switch (place.kind) {
        case Place::Kind::timer:
            return place.at < state.timers.size() ? state.timers[place.at].current : 0;
        case Place::Kind::counter:
            return place.at < state.counters.size() ? state.counters[place.at].current : 0;
        case Place::Kind::memory: {
            std::uint32_t word = 0;
            for (std::size_t i = 0; i < bytes_of(operand.width); ++i) {
                word = word << 8 | state.memory[place.at + i];
            }
            return static_cast<std::int32_t>(as_number(word, operand.width));
        }
        case Place::Kind::constant:
            break;
    }
    return operand.address;
}

std::size_t Machine::memory_bit(const Operand& operand) const {
    return parts_->program->layout.byte_of(operand.area, operand.address) * 8 + operand.bit;
}

std::vector<std::uint8_t> Machine::live_at_start(const std::vector<Operand>& observed) const {
    return live_bits(*parts_->program, observed);
}

void Machine::record() {
    parts_->memory.record();
}

namespace {

std::optional<Machine::Writer> public_writer(const MachineMemory::Writer& writer,
                                             std::uint32_t scan) {
    if (writer.scan == 0) return std::nullopt;
    return Machine::Writer{writer.network, writer.scan == scan};
}

}  // namespace

std::optional<Machine::Writer> Machine::writer(const Operand& operand) const {
    return public_writer(parts_->memory.writer(memory_bit(operand)), parts_->memory.scan());
}

bool Machine::wrote_in_last_scan(std::uint32_t network) const {
    return parts_->memory.wrote_in_last_scan(network);
}

std::vector<Machine::Read> Machine::reads() const {
    const Layout& layout = parts_->program->layout;
    std::vector<Read> reads;
    for (const MachineMemory::Read& read : parts_->memory.reads()) {
        Operand operand;
        const std::size_t byte = read.memory_bit / 8;
        std::size_t area = layout.begin.size() - 1;
        while (byte < layout.begin[area]) --area;
        operand.area = static_cast<Area>(area);
        operand.address = static_cast<std::int32_t>(byte - layout.begin[area]);
        operand.bit = static_cast<std::uint8_t>(read.memory_bit % 8);
        reads.push_back({read.network, operand, static_cast<std::int32_t>(read.value),
                         public_writer(read.writer, parts_->memory.scan())});
    }
    return reads;
}

std::vector<Time> Machine::delays() const {
    std::vector<Time> delays;
    for (const UsedTimer& timer : parts_->program->timers) {
        delays.push_back(timer.tick);
        if (timer.preset > 0) delays.push_back(timer.preset * timer.tick);
    }
    return delays;
}

}  // namespace grafwire::s7
