// An S7-200 adds words of 16 bits or double words of 32. Whether words are enough follows from the
// ranges of the counters alone, by interval arithmetic over every sum. One width for the whole
// program keeps its listing readable.

#include "s7/generate/integer_width.h"

#include <algorithm>
#include <limits>

#include "grafcet/grafcet.h"
#include "program/messages.h"
#include "s7/generate/messages.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

template <typename Integer>
bool fits(const IntegerRange& range) {
    return range.low >= std::numeric_limits<Integer>::min() &&
           range.high <= std::numeric_limits<Integer>::max();
}

/// Looks at every sum of a program.
class SumSurvey {
  public:
    SumSurvey(const Grafcet& grafcet, const ScanProgram& program, Diagnostics& diagnostics)
        : grafcet_(grafcet), diagnostics_(diagnostics) {
        for (const Counter& counter : grafcet.counters) {
            note({counter.low, counter.high}, say::counter_too_wide,
                 Localized::same_in_both(counter.name), counter.where);
        }
        for (const std::vector<Statement>& section : program.sections) {
            for (const Statement& statement : section) survey(statement);
        }
    }

    bool needs_double_words() const { return wide_; }

  private:
    void survey(const Statement& statement) {
        survey(statement.condition, statement);
        if (statement.kind != Statement::Kind::move || statement.sum.empty()) return;
        survey(statement.sum, statement);
    }

    void survey(const Condition& condition, const Statement& statement) {
        if (condition.kind == Condition::Kind::comparison) {
            survey(condition.comparison.left, statement);
            survey(condition.comparison.right, statement);
        }
        for (const Condition& operand : condition.operands) survey(operand, statement);
    }

    void survey(const Sum& sum, const Statement& statement) {
        const std::optional<IntegerRange> range = range_of(grafcet_, sum);
        if (range) {
            note(*range, say::sum_too_wide, statement.comment, statement.origin);
        } else {
            report(say::sum_too_wide, statement.comment, statement.origin);
        }
    }

    void note(const IntegerRange& range, const Message<Localized>& message, const Localized& what,
              Location where) {
        if (!fits<std::int16_t>(range)) wide_ = true;
        if (!fits<std::int32_t>(range)) report(message, what, where);
    }

    void report(const Message<Localized>& message, const Localized& what, Location where) {
        diagnostics_.error(code::beyond_limit, where, message(what));
    }

    const Grafcet& grafcet_;
    Diagnostics& diagnostics_;
    bool wide_ = false;
};

}  // namespace

std::optional<Width> integer_width(const Grafcet& grafcet, const ScanProgram& program,
                                   const ResolvedAssignment& assignment, Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    bool wide = SumSurvey(grafcet, program, diagnostics).needs_double_words();
    for (const auto& [counter, operand] : assignment.counters) {
        wide = wide || operand.width == Width::dword;
    }
    for (const auto& [index, operand] : assignment.counters) {
        if (!wide || operand.width == Width::dword) continue;
        const Counter& counter = grafcet.counters[CounterId{index}];
        diagnostics.error(code::beyond_limit, counter.where, say::double_word_needed(counter.name));
    }
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return wide ? Width::dword : Width::word;
}

}  // namespace grafwire::s7
