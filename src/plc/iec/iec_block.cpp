// The function block that a program in a textual language of IEC 61131-3 is: the names of
// everything in it, and its declarations.
//
// The standard knows no words of bits with names. In Structured Text a table is an array and a step
// its index in it; in Instruction List it is a variable a step, since compilers get subscripts
// wrong there that are no numbers. Small and capital letters are the same, so all names share one
// list.

#include "plc/iec/iec_block.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"
#include "iec/identifiers.h"
#include "plc/iec/messages.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "program/bit_names.h"
#include "program/messages.h"

namespace grafwire {

namespace {

/// The array of a table; empty where the bits have names of their own.
std::string_view array_name(BitKind kind) {
    // Tp would be the standard function block TP.
    return kind == BitKind::previous ? "Tprev" : table_name(kind);
}

}  // namespace

std::string iec_comment(std::string_view text) {
    std::string comment = "(* ";
    for (const char c : comment_text(text)) {
        const char before = comment.back();
        if ((before == '*' && c == ')') || (before == '(' && c == '*')) comment.push_back(' ');
        comment.push_back(c);
    }
    return comment + " *)";
}

IecTimer iec_timer_for(Time on_delay, Time off_delay) {
    if (on_delay == 0) return off_delay == 0 ? IecTimer::copy : IecTimer::tof;
    return off_delay == 0 ? IecTimer::ton : IecTimer::latch;
}

IecNames::IecNames(const Grafcet& grafcet, const ScanProgram& program, IecTables tables,
                   bool (*is_reserved)(std::string_view))
    : grafcet_(grafcet), program_(program), form_(tables), names_(false, is_reserved) {
    claim_interface();
    claim_tables();
    if (form_ == IecTables::bits) claim_bits_of_tables();
    claim_edges();
    claim_times();
    for (std::uint32_t i = 0; i < program.scratch_bits; ++i) {
        names_of(BitKind::scratch).push_back(names_.claim(fmt::format("held_{}", i)));
    }
    for (std::uint32_t i = 0; i < program.scratch_integers; ++i) {
        scratch_integers_.push_back(names_.claim(fmt::format("held_value_{}", i)));
    }
}

std::string IecNames::claim(const std::string& wanted, const std::string& original) {
    const std::string name = names_.claim(wanted);
    if (name != original) changed_.emplace_back(name, original);
    return name;
}

std::string IecNames::claim(const std::string& original) {
    return claim(original, original);
}

void IecNames::claim_interface() {
    for (const Input& input : grafcet_.inputs)
        names_of(BitKind::input).push_back(claim(input.name));
    for (std::size_t c = 0; c < control_input_count; ++c) {
        if (!program_.has_modes) break;
        names_of(BitKind::control)
            .push_back(claim(std::string(input_name(grafcet_, grafcet_.inputs.size() + c))));
    }
    for (const Output& output : grafcet_.outputs)
        names_of(BitKind::output).push_back(claim(output.name));
    for (const Var& var : grafcet_.vars) names_of(BitKind::var).push_back(claim(var.name));
    for (const Counter& counter : grafcet_.counters) counters_.push_back(claim(counter.name));
    block = claim(grafcet_.name);
}

void IecNames::claim_tables() {
    if (form_ == IecTables::arrays) {
        for (std::size_t kind = 0; kind < bit_kind_count; ++kind) {
            const std::string_view word = array_name(static_cast<BitKind>(kind));
            if (!word.empty()) tables_[kind] = names_.claim(word);
        }
        any = names_.claim("i");
    }
    started = names_.claim("started");
    for (const Step& step : grafcet_.steps) {
        steps_.push_back(claim("X" + step.name, "X" + step.name));
    }
    for (const Transition& transition : grafcet_.transitions) {
        const std::string name = names_.claim("T" + transition.name);
        if (name != "T" + transition.name) changed_.emplace_back(name, "(" + transition.name + ")");
        transitions_.push_back(name);
    }
    if (!uses(program_, BitKind::may_evolve)) return;
    for (const Graph& graph : grafcet_.graphs) graphs_.push_back(claim(graph.name));
}

void IecNames::claim_bits_of_tables() {
    names_of(BitKind::step) = steps_;
    names_of(BitKind::transition) = transitions_;
    const auto claim_all = [&](BitKind kind, const std::vector<std::string>& owners) {
        for (const std::string& owner : owners) {
            names_of(kind).push_back(names_.claim(fmt::format("{}_{}", array_name(kind), owner)));
        }
    };
    for (const BitKind kind : {BitKind::previous, BitKind::activate, BitKind::deactivate}) {
        claim_all(kind, steps_);
    }
    if (uses(program_, BitKind::pulse)) claim_all(BitKind::pulse, steps_);
    if (has_forcing(program_)) {
        claim_all(BitKind::forced_on, steps_);
        claim_all(BitKind::forced_off, steps_);
    }
    claim_all(BitKind::may_evolve, graphs_);
}

void IecNames::add_auxiliary() {
    const std::string wanted = fmt::format("part_{}", auxiliary_count());
    names_of(BitKind::auxiliary).push_back(names_.claim(wanted));
}

std::string IecNames::operand_word(ExprId operand, std::size_t number) const {
    const Expressions& pool = grafcet_.expressions;
    if (pool.kind(operand) != ExprKind::variable) return fmt::format("{}", number);
    return variable_name(grafcet_, pool.variable_of(operand));
}

void IecNames::claim_edges() {
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < pool.edges().size(); ++i) {
        const ExprId edge = pool.edges()[i];
        const std::string word = (pool.kind(edge) == ExprKind::rise ? "rise_" : "fall_") +
                                 operand_word(pool.operands(edge).front(), i);
        names_of(BitKind::edge).push_back(names_.claim(word));
        names_of(BitKind::edge_memory).push_back(names_.claim(word + "_memory"));
    }
}

void IecNames::claim_times() {
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < pool.time_conditions().size(); ++i) {
        const TimeCondition& time = pool.time_condition_of(pool.time_conditions()[i]);
        std::string word = operand_word(time.operand, i);
        if (time.on_delay != 0) word = format_duration(time.on_delay) + "_" + word;
        if (time.off_delay != 0) word += "_" + format_duration(time.off_delay);
        const IecTimer timer = iec_timer_for(time.on_delay, time.off_delay);
        const bool on = timer == IecTimer::ton || timer == IecTimer::latch;
        const bool off = timer == IecTimer::tof || timer == IecTimer::latch;
        const bool own = timer == IecTimer::copy || timer == IecTimer::latch;
        on_timers_.push_back(on ? names_.claim("on_" + word) : "");
        off_timers_.push_back(off ? names_.claim("off_" + word) : "");
        names_of(BitKind::time_value)
            .push_back(own  ? names_.claim("time_" + word)
                       : on ? on_timers_.back() + ".Q"
                            : off_timers_.back() + ".Q");
    }
}

const std::string& IecNames::index_of(Bit bit) const {
    if (bit.kind == BitKind::transition) return transitions_[bit.index];
    if (bit.kind == BitKind::may_evolve) return graphs_[bit.index];
    return steps_[bit.index];
}

std::string IecNames::of(Bit bit) const {
    const std::string& array = table(bit.kind);
    if (!array.empty()) return fmt::format("{}[{}]", array, index_of(bit));
    return bits_[static_cast<std::size_t>(bit.kind)][bit.index];
}

std::string IecNames::of(IntegerCell cell) const {
    return cell.is_scratch ? scratch_integers_[cell.index] : counters_[cell.index];
}

namespace {

namespace say = messages::plc_iec;

class IecDeclarations {
  public:
    IecDeclarations(const Grafcet& grafcet, const ScanProgram& program, const IecNames& names,
                    unsigned bits, const PlcOptions& options)
        : grafcet_(grafcet),
          program_(program),
          names_(names),
          integer_(bits == 16   ? "INT"
                   : bits == 32 ? "DINT"
                                : "LINT"),
          index_(std::max(grafcet_.steps.size(), grafcet_.transitions.size()) < INT16_MAX ? "INT"
                                                                                          : "DINT"),
          options_(options),
          language_(options.language) {}

    std::string write(const Localized& textual_language) {
        write_head(textual_language);
        text_ += fmt::format("FUNCTION_BLOCK {}\n", names_.block);
        write_interface();
        write_chart_variables();
        if (names_.tables() == IecTables::arrays) {
            write_indices();
            write_tables();
        } else {
            write_bits_of_tables();
        }
        write_edges_and_times();
        return std::move(text_);
    }

  private:
    void write_head(const Localized& textual_language);
    void write_interface();
    void write_chart_variables();
    void write_indices();
    void write_tables();
    void write_bits_of_tables();
    void write_edges_and_times();

    /// A block of declarations is written when it has any.
    void begin(std::string_view kind) { block_ = fmt::format("{}\n", kind); }
    void begin(std::string_view kind, const Message<>& comment) {
        block_ = fmt::format("{}  {}\n", kind, iec_comment(comment.in(language_)));
    }
    void declare(std::string_view name, std::string_view type, std::string_view comment = {}) {
        block_ += fmt::format("    {} : {};", name, type);
        if (!comment.empty()) block_ += "  " + iec_comment(comment);
        block_ += '\n';
        declared_ = true;
    }
    void declare(std::string_view name, std::string_view type, const Message<>& comment) {
        declare(name, type, comment.in(language_));
    }
    void end() {
        if (declared_) text_ += block_ + "END_VAR\n";
        declared_ = false;
    }
    /// The tables that the program needs: what for, how long, and how they are called.
    template <typename Visit>
    void for_each_table(const Visit& visit) const;

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    const IecNames& names_;
    std::string integer_;  ///< the type of counters
    std::string index_;    ///< the type of places in tables
    const PlcOptions& options_;
    Language language_;
    std::string text_;
    std::string block_;
    bool declared_ = false;
};

void IecDeclarations::write_head(const Localized& textual_language) {
    const auto comment = [&](const std::string& text) { text_ += iec_comment(text) + "\n"; };
    comment(titled_name(grafcet_.name, grafcet_.title, language_));
    if (!options_.made_by.empty()) comment(options_.made_by);
    comment(say::what_it_is.in(language_, textual_language));
    comment(say::how_to_call.in(language_));
    if (program_.has_modes) comment(say::modes.in(language_));
    if (!names_.changed().empty()) comment(say::changed_names.in(language_));
    for (const auto& [name, original] : names_.changed()) {
        comment(say::changed_name.in(language_, name, original));
    }
    text_ += '\n';
}

void IecDeclarations::write_interface() {
    begin("VAR_INPUT");
    for (std::uint32_t i = 0; i < grafcet_.inputs.size(); ++i) {
        declare(names_.of({BitKind::input, i}), "BOOL");
    }
    for (std::uint32_t c = 0; c < control_input_count && program_.has_modes; ++c) {
        declare(names_.of({BitKind::control, c}), "BOOL");
    }
    end();
    begin("VAR_OUTPUT");
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        declare(names_.of({BitKind::output, o}), "BOOL");
    }
    end();
}

void IecDeclarations::write_chart_variables() {
    begin("VAR");
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) {
        declare(names_.of({BitKind::var, v}), "BOOL");
    }
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const Counter& counter = grafcet_.counters[CounterId{c}];
        declare(names_.of(IntegerCell{false, c}), integer_,
                fmt::format("{}..{}", counter.low, counter.high));
    }
    end();
}

void IecDeclarations::write_indices() {
    const auto declare_indices = [&](BitKind kind, std::size_t size) {
        for (std::uint32_t i = 0; i < size; ++i) {
            declare(names_.index_of({kind, i}), fmt::format("{} := {}", index_, i));
        }
    };
    begin("VAR CONSTANT", say::places_in_tables);
    declare_indices(BitKind::step, grafcet_.steps.size());
    declare_indices(BitKind::transition, grafcet_.transitions.size());
    if (uses(program_, BitKind::may_evolve)) {
        declare_indices(BitKind::may_evolve, grafcet_.graphs.size());
    }
    end();
}

template <typename Visit>
void IecDeclarations::for_each_table(const Visit& visit) const {
    const std::size_t steps = grafcet_.steps.size();
    visit(BitKind::step, steps, say::steps);
    visit(BitKind::previous, steps, say::steps_before);
    visit(BitKind::activate, steps, say::to_activate);
    visit(BitKind::deactivate, steps, say::to_deactivate);
    if (uses(program_, BitKind::pulse)) visit(BitKind::pulse, steps, say::just_activated);
    if (has_forcing(program_)) {
        visit(BitKind::forced_on, steps, say::forced_on);
        visit(BitKind::forced_off, steps, say::forced_off);
    }
    visit(BitKind::transition, grafcet_.transitions.size(), say::transition_conditions);
    if (uses(program_, BitKind::may_evolve)) {
        visit(BitKind::may_evolve, grafcet_.graphs.size(), say::graphs);
    }
}

void IecDeclarations::write_tables() {
    begin("VAR", say::tables);
    for_each_table([&](BitKind kind, std::size_t size, const Message<>& comment) {
        if (size == 0) return;
        declare(names_.table(kind), fmt::format("ARRAY[0..{}] OF BOOL", size - 1), comment);
    });
    declare(names_.started, "BOOL", say::started);
    if (grafcet_.steps.size() != 0) declare(names_.any, index_, say::runs_through);
    end();
}

void IecDeclarations::write_bits_of_tables() {
    for_each_table([&](BitKind kind, std::size_t size, const Message<>& comment) {
        begin("VAR", comment);
        for (std::uint32_t i = 0; i < size; ++i) declare(names_.of({kind, i}), "BOOL");
        end();
    });
    begin("VAR");
    declare(names_.started, "BOOL", say::started);
    end();
}

void IecDeclarations::write_edges_and_times() {
    const Expressions& pool = grafcet_.expressions;
    const auto written = [&](ExprId id) { return write_expression(grafcet_, pool, id); };
    begin("VAR", say::held_values);
    for (std::uint32_t i = 0; i < pool.edges().size(); ++i) {
        declare(names_.of({BitKind::edge, i}), "BOOL", written(pool.edges()[i]));
        declare(names_.of({BitKind::edge_memory, i}), "BOOL");
    }
    for (std::uint32_t i = 0; i < pool.time_conditions().size(); ++i) {
        const ExprId id = pool.time_conditions()[i];
        const TimeCondition& time = pool.time_condition_of(id);
        const IecTimer timer = iec_timer_for(time.on_delay, time.off_delay);
        if (timer == IecTimer::copy || timer == IecTimer::latch) {
            declare(names_.of({BitKind::time_value, i}), "BOOL", written(id));
        }
        if (timer == IecTimer::ton || timer == IecTimer::latch) {
            declare(names_.on_timer(i), "TON", written(id));
        }
        if (timer == IecTimer::tof || timer == IecTimer::latch) {
            declare(names_.off_timer(i), timer == IecTimer::tof ? "TOF" : "TON", written(id));
        }
    }
    for (std::uint32_t i = 0; i < program_.scratch_bits; ++i) {
        declare(names_.of({BitKind::scratch, i}), "BOOL");
    }
    for (std::uint32_t i = 0; i < names_.auxiliary_count(); ++i) {
        declare(names_.of({BitKind::auxiliary, i}), "BOOL");
    }
    for (std::uint32_t i = 0; i < program_.scratch_integers; ++i) {
        declare(names_.of(IntegerCell{true, i}), integer_);
    }
    end();
}

}  // namespace

std::string iec_declarations(const Grafcet& grafcet, const ScanProgram& program,
                             const IecNames& names, const Localized& textual_language,
                             const PlcOptions& options, Diagnostics& diagnostics) {
    const std::optional<unsigned> bits = integer_bits(grafcet, program);
    if (!bits) {
        diagnostics.error(code::unsupported_by_language, wide_integer(grafcet, program, 64),
                          say::sum_too_wide());
        return {};
    }
    return IecDeclarations(grafcet, program, names, *bits, options).write(textual_language);
}

}  // namespace grafwire
