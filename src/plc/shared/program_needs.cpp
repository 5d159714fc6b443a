// What a program uses of the method: whatever a chart has no use for is left out, so that a program
// for beginners shows no table that is never read.

#include "plc/shared/program_needs.h"

#include <algorithm>
#include <functional>

#include "grafcet/grafcet.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

bool reads(const Condition& condition, BitKind kind) {
    if (condition.kind == Condition::Kind::bit) return condition.bit.kind == kind;
    return std::any_of(condition.operands.begin(), condition.operands.end(),
                       [&](const Condition& operand) { return reads(operand, kind); });
}

bool writes(const Statement& statement, BitKind kind) {
    return std::any_of(statement.targets.begin(), statement.targets.end(),
                       [&](Bit bit) { return bit.kind == kind; });
}

bool any_statement(const ScanProgram& program,
                   const std::function<bool(SectionKind, const Statement&)>& holds) {
    for (std::size_t s = 0; s < section_count; ++s) {
        for (const Statement& statement : program.sections[s]) {
            if (holds(static_cast<SectionKind>(s), statement)) return true;
        }
    }
    return false;
}

/// The condition with every bit of a kind replaced by 1, folded.
Condition with_ones(const Condition& condition, BitKind kind) {
    std::vector<Condition> operands;
    for (const Condition& operand : condition.operands) {
        operands.push_back(with_ones(operand, kind));
    }
    switch (condition.kind) {
        case Condition::Kind::bit:
            return condition.bit.kind == kind ? constant_condition(true) : condition;
        case Condition::Kind::negation:
            return not_condition(std::move(operands.front()));
        case Condition::Kind::conjunction:
            return and_condition(std::move(operands));
        case Condition::Kind::disjunction:
            return or_condition(std::move(operands));
        default:
            break;
    }
    Condition same = condition;
    same.operands = std::move(operands);
    return same;
}

unsigned bits_for(std::int64_t low, std::int64_t high) {
    const auto within = [&](std::int64_t limit) { return low >= -limit && high <= limit; };
    if (within(INT16_MAX)) return 16;
    return within(INT32_MAX) ? 32 : 64;
}

/// 65 where 64 are not enough.
unsigned bits_of(const Grafcet& grafcet, const Sum& sum) {
    const std::optional<IntegerRange> range = range_of(grafcet, sum);
    return range ? bits_for(range->low, range->high) : 65;
}

unsigned bits_of(const Grafcet& grafcet, const Condition& condition) {
    unsigned bits = 16;
    if (condition.kind == Condition::Kind::comparison) {
        bits = std::max(bits_of(grafcet, condition.comparison.left),
                        bits_of(grafcet, condition.comparison.right));
    }
    for (const Condition& operand : condition.operands) {
        bits = std::max(bits, bits_of(grafcet, operand));
    }
    return bits;
}

unsigned bits_of(const Grafcet& grafcet, const Statement& statement) {
    unsigned bits = bits_of(grafcet, statement.condition);
    if (statement.kind != Statement::Kind::move) return bits;
    bits = std::max(bits, bits_for(statement.low, statement.high));
    return std::max(bits, bits_of(grafcet, statement.sum));
}

}  // namespace

bool uses(const ScanProgram& program, BitKind kind) {
    return any_statement(program, [&](SectionKind, const Statement& statement) {
        return reads(statement.condition, kind) || writes(statement, kind);
    });
}

bool has_statements(const ScanProgram& program, Statement::Kind kind) {
    return any_statement(
        program, [&](SectionKind, const Statement& statement) { return statement.kind == kind; });
}

bool has_forcing(const ScanProgram& program) {
    return uses(program, BitKind::forced_off);
}

ScanProgram without_idle_tables(const ScanProgram& program) {
    ScanProgram result = program;
    const bool freezes =
        any_statement(program, [](SectionKind section, const Statement& statement) {
            return section != SectionKind::start && writes(statement, BitKind::may_evolve);
        });
    const bool pulses = uses(program, BitKind::pulse);
    for (std::vector<Statement>& section : result.sections) {
        std::erase_if(section, [&](const Statement& statement) {
            if (statement.kind == Statement::Kind::table) {
                return statement.operation == TableOperation::pulse && !pulses;
            }
            return !freezes && writes(statement, BitKind::may_evolve);
        });
        if (freezes) continue;
        for (Statement& statement : section) {
            statement.condition = with_ones(statement.condition, BitKind::may_evolve);
        }
    }
    return result;
}

std::optional<unsigned> integer_bits(const Grafcet& grafcet, const ScanProgram& program) {
    unsigned bits = 16;
    for (const std::vector<Statement>& section : program.sections) {
        for (const Statement& statement : section) {
            bits = std::max(bits, bits_of(grafcet, statement));
        }
    }
    if (bits > 64) return std::nullopt;
    return bits;
}

Location wide_integer(const Grafcet& grafcet, const ScanProgram& program, unsigned bits) {
    for (const std::vector<Statement>& section : program.sections) {
        for (const Statement& statement : section) {
            if (bits_of(grafcet, statement) > bits) return statement.origin;
        }
    }
    return {};
}

std::vector<StepRange> step_ranges(std::span<const Bit> targets) {
    std::vector<Bit> bits;
    for (const Bit bit : targets) {
        if (is_step_table(bit.kind)) bits.push_back(bit);
    }
    std::sort(bits.begin(), bits.end());
    std::vector<StepRange> ranges;
    for (const Bit bit : bits) {
        if (!ranges.empty() && ranges.back().table == bit.kind &&
            bit.index <= ranges.back().last + 1) {
            ranges.back().last = bit.index;
        } else {
            ranges.push_back({bit.kind, bit.index, bit.index});
        }
    }
    return ranges;
}

std::vector<Bit> single_bits(std::span<const Bit> targets) {
    std::vector<Bit> bits;
    for (const Bit bit : targets) {
        if (!is_step_table(bit.kind)) bits.push_back(bit);
    }
    return bits;
}

}  // namespace grafwire
