#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "s7/addresses/operand.h"
#include "text/source.h"

namespace grafwire::s7 {

// A program of a Siemens S7-200 (CPU 212, 214) in instruction list, as Cordier, "Méthode
// d'implémentation du GRAFCET" (1998), prints it: networks of instructions, the main program OB1
// first, then the subroutines. One instruction is one row of instruction_set.h.

/// The instructions of the method, and those that programs around it use.
enum class Operation : std::uint8_t {
    // Bit logic on the stack of nine.
    load,
    load_not,
    and_,
    and_not,
    or_,
    or_not,
    and_load,  ///< ULD, ALD: the two topmost levels by AND
    or_load,   ///< OLD
    push,
    read_push,
    pop,     ///< LPS, LRD, LPP
    negate,  ///< NOT
    rise,
    fall,    ///< EU, ED: 1 for one scan at a change of the top of the stack
    assign,  ///< =
    set,
    reset,  ///< S bit count, R bit count (R T37 K1 resets a timer)
    // Comparisons, `LDB>= VB100 K1`: the width and the relation are in Instruction.
    load_compare,
    and_compare,
    or_compare,
    // Work on bytes, words and double words, done where the top of the stack is 1.
    move,        ///< MOVB, MOVW, MOVD in out
    block_move,  ///< BMB, BMW in out count
    fill,        ///< FILL in out count
    invert,      ///< INVB, INVW, INVD
    and_words,   ///< UNDW, UNDD; ANDW, ANDD
    or_words,    ///< ORW, ORD
    xor_words,   ///< XORW, XORD
    add,
    subtract,  ///< +I, -I, +D, -D
    increment,
    decrement,  ///< INCW, DECW, INCD, DECD
    // Timers and counters.
    on_delay,            ///< TON timer preset
    retentive_on_delay,  ///< TONR
    count_up,            ///< CTU
    count_up_down,       ///< CTUD
    // Program control.
    call,                ///< CALL
    subroutine,          ///< SBR: begins a subroutine
    return_,             ///< RET, unconditional
    conditional_return,  ///< CRET
    jump,
    label,         ///< JMP, LBL
    end,           ///< END, conditional end of the main program
    main_end,      ///< MEND
    no_operation,  ///< NOP
};

enum class Compare : std::uint8_t { equal, not_equal, less, less_equal, greater, greater_equal };

struct Instruction {
    Operation operation = Operation::no_operation;
    Width width = Width::bit;          ///< of comparisons and of work on bytes, words, double words
    Compare compare = Compare::equal;  ///< of comparisons
    std::vector<Operand> operands;
    std::string comment;
    /// The byte offset printed before it; none where nothing is printed.
    static constexpr std::uint32_t no_offset = 0xffffffffU;
    std::uint32_t printed_offset = no_offset;
    Location where;
};

/// `NETWORK 26 // Traitement transition par transition`.
struct Network {
    std::uint32_t number = 0;
    std::string comment;
    std::vector<Instruction> instructions;
    Location where;
};

struct Listing {
    std::vector<std::string> head;  ///< comment lines before the first network
    std::vector<Network> networks;
};

/// A listing seen as what is executed: the instructions in one row, and the blocks they form, OB1
/// first. The listing must outlive it.
struct Outline {
    struct Line {
        const Instruction* instruction = nullptr;
        std::uint32_t network = 0;  ///< index into Listing::networks
        bool begins_network = false;
    };
    struct Block {
        static constexpr std::int32_t main_program = -1;
        std::int32_t number = main_program;          ///< of the subroutine
        std::size_t first = 0;                       ///< index of its first line, SBR included
        std::size_t end = 0;                         ///< one past its last
        std::map<std::int32_t, std::size_t> labels;  ///< the line of each; the first of its number
    };
    std::vector<Line> lines;
    std::vector<Block> blocks;
    std::map<std::int32_t, std::size_t> subroutines;  ///< number to block; the first of its number

    const Instruction& at(std::size_t line) const { return *lines[line].instruction; }
};

Outline outline_of(const Listing& listing);

}  // namespace grafwire::s7
