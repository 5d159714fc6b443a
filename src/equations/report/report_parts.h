#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"

namespace grafwire {

// What several forms of the report show, and where no field of the equations holds it.

/// The subject of a report.
struct Reported {
    const Grafcet& grafcet;
    const Equations& equations;
    /// A copy of the equations' expressions, to which right-hand sides and minimised forms are
    /// added as they are needed.
    Expressions pool;
};

/// The edges and the time conditions of the GRAFCET that some equation uses, by ordinal.
struct UsedMemories {
    std::vector<ExprId> edges;
    std::vector<ExprId> time_conditions;
};
UsedMemories used_memories(const Grafcet& grafcet, const Equations& equations);

/// The transition condition as it is written, in the equations' own expressions.
ExprId condition_of(const Equations& equations, const Transition& transition);

/// The name of a variable as expressions show it: quoted where it has to be.
std::string shown_name(const Grafcet& grafcet, Variable variable);

/// `pieces + 1`; `name_of` says how a counter is written.
template <typename NameOf>
std::string sum_text(const Sum& sum, const NameOf& name_of) {
    std::string text;
    for (const SumTerm& term : sum) {
        if (term.negative) text += text.empty() ? "-" : " - ";
        if (!term.negative && !text.empty()) text += " + ";
        text += term.counter == SumTerm::no_counter
                    ? std::to_string(term.value)
                    : name_of(Variable{VariableKind::counter, term.counter});
    }
    return text;
}

/// The same in the notation of the `.grafcet` language.
std::string sum_text(const Grafcet& grafcet, const Sum& sum);

/// What a write does: `pieces := pieces + 1`.
std::string write_text(const Grafcet& grafcet, const Expressions& pool, Variable target,
                       const StoredWrite& write);

/// The form of a part of a step's equation that has fewer operands than the one written, or
/// no_expr.
struct SmallerForms {
    ExprId cax = no_expr;
    ExprId cdx = no_expr;
    ExprId x = no_expr;

    bool any() const { return cax != no_expr || cdx != no_expr || x != no_expr; }
};
SmallerForms smaller_forms(Reported& reported, StepId step);

// The forms for machines: a table, and one object. Their words are not translated.

std::string write_csv_report(Reported& reported);
std::string write_json_report(Reported& reported, bool with_minimised);

}  // namespace grafwire
