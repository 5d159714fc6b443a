#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "text/message.h"

namespace grafwire {

// The scan of a GRAFCET as a program: the table method of Cordier, "Méthode d'implémentation du
// GRAFCET" (1998), sections 3.2 and 5.0 to 5.9, written down as statements that name bits, before
// any choice of where those bits live or in which language they are written. Every PLC and
// programming language is written from this form.
//
// A program is executed statement by statement, section by section, once a scan; it keeps all its
// bits and integers from one scan to the next. All are 0 before the first scan.

/// The tables of the method (Cordier, section 3.2), and what surrounds them.
enum class BitKind : std::uint8_t {
    input,       ///< index: Grafcet::inputs
    control,     ///< index: ControlInput; only in programs with modes, or where expressions read it
    output,      ///< index: Grafcet::outputs
    var,         ///< index: Grafcet::vars
    step,        ///< Ts, index: Grafcet::steps; the X of the step
    previous,    ///< Tp, per step
    pulse,       ///< Tpulse = Ts . /Tp, per step
    activate,    ///< Ta, per step
    deactivate,  ///< Td, per step
    forced_on,   ///< Tf1, per step
    forced_off,  ///< Tf0, per step
    transition,  ///< Tt, per transition: its condition . Tfig
    may_evolve,  ///< Tfig, per graph: 0 frozen
    edge,        ///< per edge (Expressions::edges): 1 in a scan in which it occurs
    edge_memory,  ///< per edge: its operand at the last evaluation
    time_value,   ///< per time condition (Expressions::time_conditions)
    scratch,      ///< holds a value within one scan
    auxiliary,    ///< in no program; a writer that works out part of a condition beforehand keeps
                  ///< it there, under a number of its own
};
inline constexpr std::size_t bit_kind_count = 18;

struct Bit {
    BitKind kind = BitKind::input;
    std::uint32_t index = 0;
    auto operator<=>(const Bit&) const = default;
};

/// A Boolean expression over bits and counters, as a tree; operands in the order written. A chart's
/// macro-step and graph variables are written out as the OR of their steps.
struct Condition {
    enum class Kind : std::uint8_t {
        constant,
        bit,
        negation,     ///< one operand
        conjunction,  ///< two operands or more, like the next two
        disjunction,
        exclusive_or,
        comparison,  ///< of sums of counters
    };
    Kind kind = Kind::constant;
    bool value = false;  ///< of a constant
    Bit bit;
    std::vector<Condition> operands;
    Comparison comparison;

    bool is_constant(bool wanted) const { return kind == Kind::constant && value == wanted; }
    bool operator==(const Condition&) const = default;
};

Condition constant_condition(bool value);
Condition bit_condition(Bit bit);
/// These three fold constants, merge nested operands of the same kind and drop a double negation.
Condition not_condition(Condition operand);
Condition and_condition(std::vector<Condition> operands);
Condition or_condition(std::vector<Condition> operands);

/// A counter, or an integer that holds a value within one scan.
struct IntegerCell {
    bool is_scratch = false;
    std::uint32_t index = 0;
    auto operator<=>(const IntegerCell&) const = default;
};

/// An operation on whole tables, done word by word where the language has words, else bit by bit
/// (expand_tables).
enum class TableOperation : std::uint8_t {
    remember,  ///< Tp = Ts
    clear,     ///< Ta = Td = Tf1 = Tf0 = 0
    evolve,    ///< Ts = Tp . /Td + Ta (rule 5: activation wins)
    force,     ///< Ts = Ts . /Tf0 + Tf1
    pulse,     ///< Tpulse = Ts . /Tp
};

struct Statement {
    enum class Kind : std::uint8_t {
        assign,  ///< targets[0] := condition
        set,     ///< where condition is 1: all targets := 1
        reset,   ///< where condition is 1: all targets := 0
        move,    ///< where condition is 1: integer := sum or source, held within low..high
        time,    ///< the time condition that is targets[0] (a time_value) observes `condition`
        table,   ///< an operation on whole tables
    };
    Kind kind = Kind::assign;
    TableOperation operation = TableOperation::remember;
    Condition condition;
    std::vector<Bit> targets;
    /// move: where not scratch, a counter; its value is `sum`, or another integer where that is
    /// empty.
    IntegerCell integer;
    Sum sum;
    IntegerCell source;
    std::int64_t low = 0;
    std::int64_t high = 0;
    /// time: 1 once the condition has been 1 for on_delay, 0 once it has been 0 for off_delay (at
    /// once where off_delay is 0). A return before that restarts the delay.
    Time on_delay = 0;
    Time off_delay = 0;
    /// What it is for, in words of the GRAFCET: `(0) 0 -> 1`, `X13`, `"H+"`. Never empty.
    Localized comment;
    Location origin;
};

/// The sections of a scan, in the order of their execution; each names the subroutine of the
/// method.
enum class SectionKind : std::uint8_t {
    start,  ///< SBR 0, before the first scan only: initial steps, Tfig, edge memories, counters
    begin,  ///< SBR 1: Tp = Ts, work tables cleared
    edges,  ///< SBR 2
    conditions,  ///< SBR 3: transition conditions, Tt
    evolution,   ///< SBR 4: Ta, Td, then Ts; Init
    orders,      ///< SBR 5: forcing, enclosures, AUdur
    stored,      ///< SBR 5, end: stored actions and actions on clearing
    times,       ///< SBR 6: time conditions
    outputs,     ///< SBR 8: continuous outputs, Tfig for the next scan
};
inline constexpr std::size_t section_count = 9;

/// It names bits and counters by their places in the chart, which is handed on beside it.
struct ScanProgram {
    bool has_modes = true;  ///< Init, AUdur and AUdoux act
    std::array<std::vector<Statement>, section_count> sections;
    std::uint32_t scratch_bits = 0;
    std::uint32_t scratch_integers = 0;

    const std::vector<Statement>& section(SectionKind kind) const {
        return sections[static_cast<std::size_t>(kind)];
    }
};

struct ProgramOptions {
    /// With Init, AUdur and AUdoux. Where off, an expression that reads one of them reads 0.
    bool modes = true;
};

ScanProgram program_from(const Grafcet& grafcet, const ProgramOptions& options);

/// The statement with an operation on whole tables written out as one assignment per step (clear:
/// one reset); any other statement as it is.
std::vector<Statement> expand_tables(const Grafcet& grafcet, const Statement& statement);

/// Whether the program uses a control input, as a mode or in an expression.
bool reads_control(const ScanProgram& program, ControlInput control);

/// The program as text, one statement a line, for tests and people; comments are in the language:
///   start: X10 X20 := 1  # initial step 10
std::string write_program_text(const Grafcet& grafcet, const ScanProgram& program,
                               Language language = Language::english);

}  // namespace grafwire
