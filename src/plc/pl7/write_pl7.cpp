// PL7-2.
//
// The controller has a GRAFCET of its own: it tests the transitions on the situation the scan
// begins with and clears all that can be cleared, as SBR 4 does. So only the rest of the scan is
// written out: edges before the chart is evolved, in the preliminary processing; stored actions,
// times and outputs after it, in the posterior processing.
//
// PL7-2 is drawn, not written. The listing keeps the heads of rungs that the printouts of its
// programming tool have (`** LABEL 10`, `** X0 --> X1`) and writes a rung on one line; its head
// says how.

#include "plc/pl7/write_pl7.h"

#include <fmt/format.h>

#include <set>

#include "plc/pl7/pl7_head.h"
#include "plc/pl7/pl7_objects.h"
#include "plc/pl7/pl7_rungs.h"
#include "plc/shared/program_needs.h"

namespace grafwire {

namespace {

/// `T3` of `T3,D`.
std::string timer_of(const std::string& done) {
    return done.substr(0, done.find(','));
}

class Pl7Writer {
  public:
    explicit Pl7Writer(const ScanProgram& program)
        : program_(program),
          grafcet_(*program.grafcet),
          objects_(program_),
          preliminary_(objects_),
          posterior_(objects_) {}

    std::string write(Diagnostics& diagnostics);

  private:
    void note_uses();
    void note_uses(const Condition& condition);
    void name_timers();
    void write_start();
    void write_modes();
    void write_previous();
    void write_edges();
    void write_transitions();
    void write_posterior(Diagnostics& diagnostics);
    void write_statement(const Statement& statement, Diagnostics& diagnostics);
    void write_move(const Statement& statement);
    void write_time(const Statement& statement, Diagnostics& diagnostics);
    void run_timer(const std::string& timer, Time duration, const Condition& condition,
                   Location where, Diagnostics& diagnostics);
    std::string steps(std::span<const StepId> ids);

    ScanProgram program_;
    const Grafcet& grafcet_;
    Pl7Objects objects_;
    Pl7Rungs preliminary_;
    Pl7Rungs posterior_;
    std::string transitions_;
    std::set<std::uint32_t> previous_;  ///< steps whose Tp is read
    std::set<std::uint32_t> tested_;    ///< transitions whose Tt is read after the evolution
};

/// What of the tables is read outside the evolution, which is the controller's own.
void Pl7Writer::note_uses(const Condition& condition) {
    if (condition.kind == Condition::Kind::bit) {
        const Bit bit = condition.bit;
        if (bit.kind == BitKind::previous || bit.kind == BitKind::pulse)
            previous_.insert(bit.index);
        if (bit.kind == BitKind::transition) tested_.insert(bit.index);
    }
    for (const Condition& operand : condition.operands) note_uses(operand);
}

void Pl7Writer::note_uses() {
    for (const SectionKind kind : {SectionKind::stored, SectionKind::times, SectionKind::outputs}) {
        for (const Statement& statement : program_.section(kind)) note_uses(statement.condition);
    }
}

/// The value of a condition with an on-delay only is D of its timer.
void Pl7Writer::name_timers() {
    for (const Statement& statement : program_.section(SectionKind::times)) {
        if (statement.on_delay == 0 || statement.off_delay != 0) continue;
        objects_.name(statement.targets.front(), objects_.new_timer() + ",D");
    }
}

/// Internal bits are 0 after a cold start, so only what is 1 is set.
void Pl7Writer::write_start() {
    for (const Statement& statement : program_.section(SectionKind::start)) {
        const Bit target = statement.targets.empty() ? Bit{} : statement.targets.front();
        if (target.kind == BitKind::step || target.kind == BitKind::previous) continue;
        preliminary_.label("cold start: " + statement.comment);
        if (statement.kind == Statement::Kind::move) {
            const std::string value = preliminary_.value(statement.sum);
            preliminary_.line("SY0",
                              fmt::format("[{} -> {}]", value, objects_.of(statement.integer)));
            continue;
        }
        const Bit first_scan{BitKind::scratch, program_.scratch_bits};
        objects_.name(first_scan, "SY0");
        const Condition condition = and_condition({bit_condition(first_scan), statement.condition});
        for (const Bit bit : statement.targets) {
            preliminary_.rung(condition, "(S) " + objects_.of(bit));
        }
    }
}

void Pl7Writer::write_modes() {
    if (!program_.has_modes) return;
    const auto control = [](ControlInput input) {
        return bit_condition({BitKind::control, static_cast<std::uint32_t>(input)});
    };
    const Condition au_dur = control(ControlInput::au_dur);
    preliminary_.label("Init: initial situation");
    preliminary_.rung(and_condition({control(ControlInput::init), not_condition(au_dur)}),
                      "( ) SY21");
    preliminary_.label("AUdur: no step active");
    preliminary_.rung(au_dur, "( ) SY22");
}

void Pl7Writer::write_previous() {
    for (const std::uint32_t step : previous_) {
        preliminary_.label(
            fmt::format("X{} as the scan begins", grafcet_.steps[StepId{step}].name));
        preliminary_.rung(bit_condition({BitKind::step, step}),
                          "( ) " + objects_.of(Bit{BitKind::previous, step}));
    }
}

void Pl7Writer::write_edges() {
    for (const Statement& statement : program_.section(SectionKind::edges)) {
        preliminary_.label(statement.comment);
        preliminary_.rung(statement.condition, "( ) " + objects_.of(statement.targets.front()));
    }
}

/// A receptivity that is read again after the evolution has a bit of its own.
void Pl7Writer::write_transitions() {
    for (const Statement& statement : program_.section(SectionKind::receptivities)) {
        const Bit bit = statement.targets.front();
        const Transition& transition = grafcet_.transitions[TransitionId{bit.index}];
        transitions_ += fmt::format("\n** {} --> {}   {}\n", steps(grafcet_.preceding(transition)),
                                    steps(grafcet_.following(transition)), statement.comment);
        Condition condition = statement.condition;
        if (tested_.count(bit.index) != 0) {
            preliminary_.label("receptivity of " + statement.comment);
            preliminary_.rung(condition, "( ) " + objects_.of(bit));
            condition = bit_condition(bit);
        } else if (Pl7Rungs::has_sums(condition)) {
            preliminary_.label("sums of " + statement.comment);
        }
        transitions_ += fmt::format("   {} --(#)\n", preliminary_.contacts(condition));
    }
}

std::string Pl7Writer::steps(std::span<const StepId> ids) {
    std::string text;
    for (const StepId id : ids) {
        if (!text.empty()) text += " ";
        text += objects_.of(Bit{BitKind::step, static_cast<std::uint32_t>(index_of(id))});
    }
    return text;
}

void Pl7Writer::write_posterior(Diagnostics& diagnostics) {
    for (const SectionKind kind : {SectionKind::stored, SectionKind::times, SectionKind::outputs}) {
        for (const Statement& statement : program_.section(kind)) {
            posterior_.label(statement.comment);
            write_statement(statement, diagnostics);
        }
    }
}

void Pl7Writer::write_statement(const Statement& statement, Diagnostics& diagnostics) {
    const char* coil = "( ) ";
    switch (statement.kind) {
        case Statement::Kind::move:
            return write_move(statement);
        case Statement::Kind::time:
            return write_time(statement, diagnostics);
        case Statement::Kind::set:
            coil = "(S) ";
            break;
        case Statement::Kind::reset:
            coil = "(R) ";
            break;
        default:
            break;
    }
    for (const Bit bit : statement.targets) {
        posterior_.rung(statement.condition, coil + objects_.of(bit));
    }
}

/// The value is worked out first, for the condition may read the counter that is written.
void Pl7Writer::write_move(const Statement& statement) {
    std::string value;
    if (statement.sum.empty()) {
        value = objects_.of(statement.source);
    } else {
        const IntegerRange range = value_range(grafcet_, statement.sum);
        std::optional<std::int64_t> low;
        std::optional<std::int64_t> high;
        if (range.low < statement.low) low = statement.low;
        if (range.high > statement.high) high = statement.high;
        value = posterior_.limited(posterior_.value(statement.sum), low, high);
    }
    posterior_.rung(statement.condition,
                    fmt::format("[{} -> {}]", value, objects_.of(statement.integer)));
}

/// A timer block that a condition drives.
void Pl7Writer::run_timer(const std::string& timer, Time duration, const Condition& condition,
                          Location where, Diagnostics& diagnostics) {
    const auto preset = pl7_preset(duration);
    if (preset) {
        return posterior_.rung(condition,
                               fmt::format("{} TB={} P={}", timer, preset->base, preset->count));
    }
    diagnostics.error(Code::unsupported_by_style, where,
                      fmt::format("no timer of PL7-2 holds {}: it counts up to 9999 times 10 ms, "
                                  "100 ms, 1 s or 1 min; choose another time",
                                  format_duration(duration)));
}

/// With an on-delay only, D of the timer is the value (name_timers); else two rungs set and reset
/// it.
void Pl7Writer::write_time(const Statement& statement, Diagnostics& diagnostics) {
    const Bit bit = statement.targets.front();
    const Condition held = bit_condition(bit);
    const Condition& operand = statement.condition;
    if (statement.off_delay == 0) {
        if (statement.on_delay == 0) {
            return posterior_.rung(operand, "( ) " + objects_.of(bit));
        }
        return run_timer(timer_of(objects_.of(bit)), statement.on_delay, operand, statement.origin,
                         diagnostics);
    }
    if (statement.on_delay == 0) {
        posterior_.rung(operand, "(S) " + objects_.of(bit));
    } else {
        const std::string timer = objects_.new_timer();
        run_timer(timer, statement.on_delay, and_condition({operand, not_condition(held)}),
                  statement.origin, diagnostics);
        posterior_.line(timer + ",D", "(S) " + objects_.of(bit));
    }
    const std::string timer = objects_.new_timer();
    run_timer(timer, statement.off_delay, and_condition({not_condition(operand), held}),
              statement.origin, diagnostics);
    posterior_.line(timer + ",D", "(R) " + objects_.of(bit));
}

std::string Pl7Writer::write(Diagnostics& diagnostics) {
    note_uses();
    name_timers();
    write_start();
    write_modes();
    write_previous();
    write_edges();
    write_transitions();
    write_posterior(diagnostics);
    objects_.check_limits(diagnostics);
    if (diagnostics.has_errors()) return {};
    return pl7_head(program_, objects_) + "\nPRELIMINARY PROCESSING\n" + preliminary_.text() +
           "\nSEQUENTIAL PROCESSING\n\n" + pl7_steps(program_, objects_) + transitions_ +
           "\nPOSTERIOR PROCESSING\n" + posterior_.text();
}

}  // namespace

std::string write_pl7(const ScanProgram& program, const PlcOptions&, Diagnostics& diagnostics) {
    const ScanProgram needed = without_idle_tables(program);
    check_pl7_chart(*needed.grafcet, diagnostics);
    if (integer_bits(needed) != 16U) {
        diagnostics.error(Code::unsupported_by_style, wide_integer(needed, 16),
                          "an integer needs more than the 16 bits of a word of PL7-2; make the "
                          "range of the counter smaller");
    }
    if (diagnostics.has_errors()) return {};
    return Pl7Writer(needed).write(diagnostics);
}

}  // namespace grafwire
