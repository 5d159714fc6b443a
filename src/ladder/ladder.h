#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/expression.h"
#include "text/message.h"
#include "text/source.h"
#include "text/time.h"

namespace grafwire::ladder {

// A ladder diagram (IEC 61131-3, section 8.2; the "langage à contacts" of the course "Mise en œuvre
// du GRAFCET", section 3.1): rungs between two power rails, executed from top to bottom once a
// scan. In each rung the contacts between the left rail and the blocks let power through or not;
// blocks and coils at its right end act on that power. Rungs written from a GRAFCET, rungs drawn
// and rungs read back from a student's project are all this form.

enum class VariableId : std::uint32_t {};

enum class Type : std::uint8_t {
    bit,
    integer,
    block,  ///< an instance of a function block; as a contact it is its output Q
};

/// Where a variable's value comes from and goes to.
enum class Role : std::uint8_t { input, output, memory };

/// What is drawn as a box.
enum class BlockType : std::uint8_t {
    on_delay,
    off_delay,
    rise,
    fall,
    count_up,
    count_down,
    set_dominant,
    reset_dominant,
    move,
    add,
    subtract,
    multiply,
    limit,
};

/// One row of the block table. The names of parameters are those of IEC 61131-3.
struct BlockTypeRow {
    BlockType type;
    std::string_view name;
    bool is_function;        ///< without an instance and a memory; does something where EN is 1
    std::string_view power;  ///< the input that the power enters by
    std::array<std::string_view, 3> inputs;  ///< the others, in the order of Block::operands
    std::string_view output;                 ///< Q of a function block, the result of a function
};

inline constexpr std::array<BlockTypeRow, 13> block_table{{
    {BlockType::on_delay, "TON", false, "IN", {"PT"}, "Q"},
    {BlockType::off_delay, "TOF", false, "IN", {"PT"}, "Q"},
    {BlockType::rise, "R_TRIG", false, "CLK", {}, "Q"},
    {BlockType::fall, "F_TRIG", false, "CLK", {}, "Q"},
    {BlockType::count_up, "CTU", false, "CU", {"R", "PV"}, "Q"},
    {BlockType::count_down, "CTD", false, "CD", {"LD", "PV"}, "Q"},
    {BlockType::set_dominant, "SR", false, "S1", {"R"}, "Q1"},
    {BlockType::reset_dominant, "RS", false, "S", {"R1"}, "Q1"},
    {BlockType::move, "MOVE", true, "EN", {"IN"}, "OUT"},
    {BlockType::add, "ADD", true, "EN", {"IN1", "IN2"}, "OUT"},
    {BlockType::subtract, "SUB", true, "EN", {"IN1", "IN2"}, "OUT"},
    {BlockType::multiply, "MUL", true, "EN", {"IN1", "IN2"}, "OUT"},
    {BlockType::limit, "LIMIT", true, "EN", {"MN", "IN", "MX"}, "OUT"},
}};

constexpr const BlockTypeRow& row_of(BlockType type) {
    return block_table[static_cast<std::size_t>(type)];
}

/// The number of its inputs beside the power.
constexpr std::size_t operand_count(const BlockTypeRow& row) {
    std::size_t count = 0;
    while (count < row.inputs.size() && !row.inputs[count].empty()) ++count;
    return count;
}

struct Variable {
    std::string name;  ///< unique in the diagram; any text: `V+`, `↑dcy`
    Type type = Type::bit;
    Role role = Role::memory;
    BlockType block = BlockType::on_delay;  ///< of an instance
    std::int64_t initial = 0;               ///< before the first scan
    std::string comment;
    bool operator==(const Variable&) const = default;
};

/// What a block or a comparison reads.
struct Operand {
    enum class Kind : std::uint8_t { number, time, variable };
    Kind kind = Kind::number;
    std::int64_t value = 0;  ///< of a number; of a time in picoseconds, as text/time.h has it; a
                             ///< bit constant is the number 0 or 1
    VariableId variable{};   ///< of a variable; an instance of a counter stands for its CV
    bool operator==(const Operand&) const = default;
};

enum class ContactKind : std::uint8_t {
    normal,   ///< ─┤ ├─
    negated,  ///< ─┤/├─
    rising,  ///< ─┤P├─ 1 in the scan in which the variable is 1 and was 0 at the last evaluation
    falling,  ///< ─┤N├─
};

/// What lies between the left rail and the right end of a rung: contacts in series and in parallel.
struct Power {
    enum class Kind : std::uint8_t {
        wire,  ///< always lets power through
        contact,
        comparison,  ///< a contact that lets power through where a comparison of integers holds
        series,      ///< parts from left to right
        parallel,    ///< parts from top to bottom
    };
    Kind kind = Kind::wire;
    ContactKind contact = ContactKind::normal;
    VariableId variable{};
    Relation relation = Relation::equal;
    Operand left;
    Operand right;
    std::vector<Power> parts;  ///< at least two, none of them of the kind of the whole
    bool operator==(const Power&) const = default;
};

Power contact(VariableId variable, ContactKind kind = ContactKind::normal);
/// These two merge parts of the same kind; no part at all gives a wire, one part itself. A wire in
/// a series is left out; a wire beside anything in a parallel remains.
Power series(std::vector<Power> parts);
Power parallel(std::vector<Power> parts);

/// The names of the comparison functions: EQ, NE, LT, LE, GT, GE; by Relation.
inline constexpr std::array<std::string_view, 6> comparison_names{"EQ", "NE", "LT",
                                                                  "LE", "GT", "GE"};

struct Block {
    BlockType type = BlockType::move;
    VariableId target{};  ///< the instance; of a function: the integer that takes the result
    std::vector<Operand> operands;  ///< as many as the row has inputs
    bool operator==(const Block&) const = default;
};

enum class CoilKind : std::uint8_t {
    normal,   ///< ─( )─ the variable becomes the power
    negated,  ///< ─(/)─
    set,      ///< ─(S)─ 1 where there is power
    reset,    ///< ─(R)─ 0 where there is power
    rising,   ///< ─(P)─ 1 in the scan in which the power comes, else 0
    falling,  ///< ─(N)─
};

struct Coil {
    CoilKind kind = CoilKind::normal;
    VariableId variable{};
    bool operator==(const Coil&) const = default;
};

/// Power passes the contacts, then the blocks one after the other (the Q of a function block, the
/// ENO of a function), then reaches all coils, which are executed from top to bottom.
struct Rung {
    std::uint32_t number = 0;  ///< of its network, from 1; in programs read, several rungs may be
                               ///< parts of one network
    std::string heading;       ///< of the section that begins with this rung; else empty
    std::string comment;
    Power power;
    std::vector<Block> blocks;
    std::vector<Coil> coils;
    Location origin;  ///< in the chart, or in the file that the rung was read from
};

struct Ladder {
    std::string name;
    std::string title;
    std::vector<std::string> remarks;  ///< how the program is to be used, a line each
    std::vector<Variable> variables;
    /// The first of them, so many, are the chart's: inputs, outputs, steps, vars, counters.
    std::size_t declared = 0;
    std::uint32_t integer_bits = 16;  ///< that hold every integer and every sum: 16, 32 or 64
    std::vector<Rung> rungs;

    const Variable& variable(VariableId id) const {
        return variables[static_cast<std::size_t>(id)];
    }
    VariableId add(Variable variable) {
        variables.push_back(std::move(variable));
        return VariableId{static_cast<std::uint32_t>(variables.size() - 1)};
    }
};

/// What the diagram is headed with: its name and, where it has one, its title.
std::string heading_of(const Ladder& ladder, Language language);

/// What a comparison or block reads, as text: `c`, `-3`, `T#1.5s`, `C1.CV`.
std::string operand_text(const Ladder& ladder, const Operand& operand);

}  // namespace grafwire::ladder
