// Entry by entry, each address is held against what the chart means by its name: a bit may stand
// anywhere, a step, transition or graph only in its table, since the listing addresses those by
// number. Names are looked up in one map of all there is in the chart, so that an unknown one can
// be answered with the nearest.

#include "s7/generate/assignment.h"

#include <string>
#include <utility>

#include "grafcet/write_grafcet.h"
#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "s7/generate/messages.h"
#include "text/nearest_name.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

/// What a name of the chart is.
struct Meaning {
    enum class Kind : std::uint8_t { bit, counter, step, transition, graph };
    Kind kind = Kind::bit;
    Bit bit;
    std::uint32_t index = 0;  ///< of all others
};

using Meanings = std::map<std::string, Meaning, std::less<>>;

Meanings meanings_of(const Grafcet& grafcet) {
    using Kind = Meaning::Kind;
    Meanings meanings;
    const auto add_bits = [&](BitKind kind, const auto& table) {
        for (std::uint32_t i = 0; i < table.size(); ++i) {
            meanings.emplace(table.items()[i].name, Meaning{Kind::bit, {kind, i}, i});
        }
    };
    add_bits(BitKind::input, grafcet.inputs);
    for (std::uint32_t c = 0; c < control_input_count; ++c) {
        meanings.emplace(input_name(grafcet, grafcet.inputs.size() + c),
                         Meaning{Kind::bit, {BitKind::control, c}, c});
    }
    add_bits(BitKind::output, grafcet.outputs);
    add_bits(BitKind::var, grafcet.vars);
    const auto add = [&](Kind kind, std::string name, std::uint32_t index) {
        meanings.emplace(std::move(name), Meaning{kind, {}, index});
    };
    for (std::uint32_t c = 0; c < grafcet.counters.size(); ++c) {
        add(Kind::counter, grafcet.counters.items()[c].name, c);
    }
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        add(Kind::step, variable_name(grafcet, {VariableKind::step, s}), s);
    }
    for (std::uint32_t t = 0; t < grafcet.transitions.size(); ++t) {
        add(Kind::transition, "(" + grafcet.transitions.items()[t].name + ")", t);
    }
    // A graph may bear the name of a variable, which comes first then.
    for (std::uint32_t g = 0; g < grafcet.graphs.size(); ++g) {
        add(Kind::graph, grafcet.graphs.items()[g].name, g);
    }
    return meanings;
}

void report_unknown(const IoAssignment::Entry& entry, const Meanings& meanings,
                    Diagnostics& diagnostics) {
    std::vector<std::string_view> names;
    if (diagnostics.error_count() < most_suggestions) {
        for (const auto& [name, meaning] : meanings) names.push_back(name);
    }
    const std::string_view nearest = nearest_name(entry.name, names);
    diagnostics.error(code::unknown_name, entry.where,
                      nearest.empty() ? say::not_in_the_chart(entry.name)
                                      : say::not_in_the_chart_near(entry.name, nearest));
}

/// Checks entry after entry; see resolve_assignment.
class Resolver {
  public:
    Resolver(const Grafcet& grafcet, bool wide, Diagnostics& diagnostics)
        : meanings_(meanings_of(grafcet)),
          layout_(wide ? wide_tables(grafcet) : standard_tables()),
          wide_(wide),
          diagnostics_(diagnostics) {
        result_.places.graphs.assign(grafcet.graphs.size(), free_place);
        result_.places.steps.assign(grafcet.steps.size(), free_place);
        result_.places.transitions.assign(grafcet.transitions.size(), free_place);
    }

    void add(const IoAssignment::Entry& entry) {
        const auto found = meanings_.find(entry.name);
        if (found == meanings_.end()) {
            report_unknown(entry, meanings_, diagnostics_);
            return;
        }
        const Meaning& meaning = found->second;
        switch (meaning.kind) {
            case Meaning::Kind::bit:
                add_bit(entry, meaning.bit);
                break;
            case Meaning::Kind::counter:
                add_counter(entry, meaning.index);
                break;
            case Meaning::Kind::step:
                add_place(entry, {say::wide_step, say::place_of_step},
                          layout_.first_byte(BitKind::step), layout_.step_bytes,
                          result_.places.steps[meaning.index]);
                break;
            case Meaning::Kind::transition:
                add_place(entry, {say::wide_transition, say::place_of_transition},
                          layout_.transitions, layout_.transition_bytes,
                          result_.places.transitions[meaning.index]);
                break;
            case Meaning::Kind::graph:
                add_place(entry, {say::wide_graph, say::place_of_graph}, layout_.graphs,
                          layout_.graph_bytes, result_.places.graphs[meaning.index]);
                break;
        }
    }

    ResolvedAssignment finish() { return std::move(result_); }

  private:
    /// What is wrong with the address of a step, a transition or a graph.
    struct PlaceFaults {
        const Message<>& in_wide_tables;
        const Message<std::int32_t, std::int32_t>& beyond_its_table;
    };

    void refuse(const IoAssignment::Entry& entry, const Localized& why) {
        diagnostics_.error(code::bad_address, entry.where,
                           say::wrong_address(text(entry.operand), entry.name, why));
    }

    static std::string text(const Operand& operand) {
        return write_operand(operand, Mnemonics::simatic);
    }

    static std::int32_t bytes_of(Width width) {
        return width == Width::word ? 2 : width == Width::dword ? 4 : 1;
    }

    /// Whether an operand lies in the accumulator or in a table; VB6 … VB9 are free for use.
    bool is_of_the_method(const Operand& operand) const {
        if (operand.area != Area::variable) return false;
        const std::int32_t last = operand.address + bytes_of(operand.width) - 1;
        const bool in_free_bits = operand.address >= 6 && last < 10;
        return !in_free_bits && operand.address < static_cast<std::int32_t>(layout_.end());
    }

    void add_bit(const IoAssignment::Entry& entry, Bit bit) {
        const Operand& operand = entry.operand;
        const bool is_read = bit.kind == BitKind::input || bit.kind == BitKind::control;
        if (operand.width != Width::bit) return refuse(entry, say::bit_wanted());
        const bool in_memory = operand.area == Area::variable || operand.area == Area::memento;
        const bool in_image = operand.area == (is_read ? Area::input : Area::output) ||
                              (is_read && operand.area == Area::special);
        if (!in_memory && !in_image) {
            return refuse(entry, is_read ? say::areas_of_inputs() : say::areas_of_outputs());
        }
        if (is_of_the_method(operand)) return refuse(entry, say::used_by_the_method());
        result_.bits.emplace(bit, operand);
    }

    void add_counter(const IoAssignment::Entry& entry, std::uint32_t counter) {
        const Operand& operand = entry.operand;
        const bool in_memory = operand.area == Area::variable || operand.area == Area::memento;
        if (!in_memory || (operand.width != Width::word && operand.width != Width::dword)) {
            return refuse(entry, say::areas_of_counters());
        }
        if (is_of_the_method(operand)) return refuse(entry, say::used_by_the_method());
        result_.counters.emplace(counter, operand);
    }

    void add_place(const IoAssignment::Entry& entry, const PlaceFaults& faults, std::uint32_t first,
                   std::uint32_t bytes, std::uint32_t& place) {
        const Operand& operand = entry.operand;
        if (wide_) return refuse(entry, faults.in_wide_tables());
        const auto from = static_cast<std::int32_t>(first);
        const auto to = static_cast<std::int32_t>(first + bytes);
        if (operand.area != Area::variable || operand.width != Width::bit ||
            operand.address < from || operand.address >= to) {
            return refuse(entry, faults.beyond_its_table(from, to - 1));
        }
        place = static_cast<std::uint32_t>((operand.address - from) * 8 + operand.bit);
    }

    Meanings meanings_;
    TableLayout layout_;
    bool wide_;
    Diagnostics& diagnostics_;
    ResolvedAssignment result_;
};

Condition with_zeros(const Condition& condition, const ResolvedAssignment& assignment) {
    std::vector<Condition> operands;
    for (const Condition& operand : condition.operands) {
        operands.push_back(with_zeros(operand, assignment));
    }
    switch (condition.kind) {
        case Condition::Kind::bit:
            if (condition.bit.kind == BitKind::control &&
                !assignment.bits.contains(condition.bit)) {
                return constant_condition(false);
            }
            return condition;
        case Condition::Kind::negation:
            return not_condition(std::move(operands.front()));
        case Condition::Kind::conjunction:
            return and_condition(std::move(operands));
        case Condition::Kind::disjunction:
            return or_condition(std::move(operands));
        case Condition::Kind::exclusive_or: {
            Condition result = condition;
            result.operands = std::move(operands);
            return result;
        }
        case Condition::Kind::constant:
        case Condition::Kind::comparison:
            break;
    }
    return condition;
}

/// Whether a statement can no longer do anything.
bool is_idle(const Statement& statement) {
    switch (statement.kind) {
        case Statement::Kind::set:
        case Statement::Kind::reset:
        case Statement::Kind::move:
            return statement.condition.is_constant(false);
        case Statement::Kind::assign:
        case Statement::Kind::time:
        case Statement::Kind::table:
            break;
    }
    return false;
}

}  // namespace

void check_assigned_names(const Grafcet& grafcet, const IoAssignment& assignment,
                          Diagnostics& diagnostics) {
    const Meanings meanings = meanings_of(grafcet);
    for (const IoAssignment::Entry& entry : assignment.entries) {
        if (!meanings.contains(entry.name)) report_unknown(entry, meanings, diagnostics);
    }
}

ResolvedAssignment resolve_assignment(const Grafcet& grafcet, const IoAssignment& assignment,
                                      bool wide, Diagnostics& diagnostics) {
    Resolver resolver(grafcet, wide, diagnostics);
    for (const IoAssignment::Entry& entry : assignment.entries) resolver.add(entry);
    return resolver.finish();
}

ScanProgram without_unassigned_controls(ScanProgram program, const ResolvedAssignment& assignment) {
    for (std::vector<Statement>& section : program.sections) {
        for (Statement& statement : section) {
            statement.condition = with_zeros(statement.condition, assignment);
        }
        std::erase_if(section, is_idle);
    }
    return program;
}

}  // namespace grafwire::s7
