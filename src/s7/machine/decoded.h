#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "s7/addresses/cpu.h"
#include "s7/listing.h"
#include "text/time.h"

namespace grafwire::s7 {

/// Where the areas of a controller lie in one row of bytes.
struct Layout {
    explicit Layout(const CpuRow& cpu);
    std::size_t byte_of(Area area, std::int32_t address) const {
        return begin[static_cast<std::size_t>(area)] + static_cast<std::size_t>(address);
    }
    std::array<std::size_t, 5> begin{};  ///< of input, output, variable, memento, special
    std::size_t bytes = 0;
};

/// An operand, looked up.
struct Place {
    enum class Kind : std::uint8_t { memory, constant, timer, counter };
    Kind kind = Kind::constant;
    std::uint8_t bit = 0;     ///< of a bit in memory
    std::size_t at = 0;       ///< its byte in the row; of a timer or counter its place in the state
    std::uint32_t value = 0;  ///< of a constant
};

/// An instruction with everything looked up that can be looked up before it is executed.
struct DecodedInstruction {
    Operation operation = Operation::no_operation;
    Width width = Width::bit;
    Compare compare = Compare::equal;
    std::array<Place, 2> operands;
    std::uint32_t count = 0;    ///< of S, R, FILL, BMB, BMW
    std::size_t target = 0;     ///< of CALL and JMP: where to go on
    std::size_t edge = 0;       ///< of EU, ED and counters: its place in MachineState::edges
    std::uint32_t network = 0;  ///< index into Listing::networks
    std::uint32_t network_number = 0;
    Location where;
};

/// A timer as the listing uses it.
struct UsedTimer {
    std::int32_t number = 0;
    Time tick = 0;
    /// The elapsed time beyond which nothing changes any more.
    Time most = 0;
    std::int32_t preset = -1;  ///< the greatest constant preset; -1: none, or one from memory
};

/// A listing as it is executed. Each block ends in MEND or RET, whether or not the listing does.
struct Decoded {
    Decoded(const Listing& listing, Cpu cpu);

    Layout layout;
    std::vector<DecodedInstruction> code;
    struct Block {
        std::size_t first = 0;
        std::size_t end = 0;
    };
    std::vector<Block> blocks;  ///< OB1 first
    std::vector<UsedTimer> timers;
    std::vector<std::int32_t> counters;  ///< their numbers
    std::size_t edges = 0;

    Place place_of(const Operand& operand) const;
};

/// The bytes of a byte, word or double word.
constexpr std::size_t bytes_of(Width width) {
    return width == Width::byte ? 1 : width == Width::word ? 2 : width == Width::dword ? 4 : 0;
}

}  // namespace grafwire::s7
