// The forms of the report that programs read: CSV, a row per variable, and JSON, one object with
// everything. The object is written piece by piece, one line per step, so that no tree of the whole
// report is ever in memory.

#include <nlohmann/json.hpp>

#include "equations/report/report_parts.h"
#include "grafcet/write_grafcet.h"
#include "text/escape.h"

namespace grafwire {

namespace {

/// A text as one field of a row.
std::string field(const std::string& text) {
    std::string quoted;
    append_csv_field(quoted, text);
    return quoted;
}

/// The right-hand side of every output, in the order of declaration.
std::vector<ExprId> output_values(Reported& reported) {
    std::vector<ExprId> values(reported.grafcet.outputs.size(), no_expr);
    for (const OutputEquation& output : reported.equations.outputs) {
        values[index_of(output.output)] = output.value;
    }
    for (const StoredEquation& stored : reported.equations.stored) {
        if (stored.target.kind != VariableKind::output) continue;
        values[stored.target.index] = stored_expression(stored, reported.pool);
    }
    return values;
}

using Json = nlohmann::ordered_json;

/// What makes a write happen, by the name that stands in JSON.
const char* cause_name(StoredWrite::Cause cause) {
    switch (cause) {
        case StoredWrite::Cause::deactivation:
            return "deactivation";
        case StoredWrite::Cause::clearing:
            return "clearing";
        case StoredWrite::Cause::activation:
            return "activation";
        case StoredWrite::Cause::event:
            break;
    }
    return "event";
}

/// Members of the object, one after the other; each list has an item a line.
class JsonReport {
  public:
    JsonReport(Reported& reported, bool with_minimised)
        : reported_(reported),
          equations_(reported.equations),
          grafcet_(reported.grafcet),
          with_minimised_(with_minimised) {}

    std::string write() {
        const EquationOptions& options = equations_.options;
        text_ = "{\n  \"name\": " + Json(grafcet_.name).dump();
        text_ += ",\n  \"title\": " + Json(grafcet_.title).dump();
        text_ += ",\n  \"options\": " +
                 Json({{"cdx", options.cdx == CdxForm::successor ? "successor" : "transition"},
                       {"modes", options.modes}})
                     .dump();
        list("transitions", grafcet_.transitions.size(),
             [&](std::size_t i) { return transition(i); });
        list("steps", grafcet_.steps.size(), [&](std::size_t i) { return step(i); });
        list("outputs", equations_.outputs.size(), [&](std::size_t i) { return output(i); });
        if (!equations_.held.empty()) {
            list("held", equations_.held.size(), [&](std::size_t i) { return held(i); });
        }
        list("stored", equations_.stored.size(), [&](std::size_t i) { return stored(i); });
        const UsedMemories used = used_memories(grafcet_, equations_);
        list("timeConditions", used.time_conditions.size(),
             [&](std::size_t i) { return time_condition(used.time_conditions[i]); });
        list("edges", used.edges.size(), [&](std::size_t i) { return edge(used.edges[i]); });
        return std::move(text_) + "\n}\n";
    }

  private:
    std::string shown(ExprId id) const { return write_expression(grafcet_, reported_.pool, id); }

    template <typename Item>
    /// `"steps": [`, an item a line, `]`.
    void list(const char* name, std::size_t count, Item item) {
        text_ += ",\n  \"";
        text_ += name;
        text_ += "\": [";
        for (std::size_t i = 0; i < count; ++i) {
            text_ += i == 0 ? "\n    " : ",\n    ";
            text_ += item(i).dump();
        }
        text_ += count == 0 ? "]" : "\n  ]";
    }

    void add_if_present(Json& object, const char* key, ExprId id) const {
        if (id != no_expr) object[key] = shown(id);
    }

    Json step_names(std::span<const StepId> steps) const {
        Json names = Json::array();
        for (const StepId step : steps) names.push_back("X" + grafcet_.steps[step].name);
        return names;
    }

    /// `{"name": "3", "from": ["X0"], "to": ["X1"], "condition": "m", "clearing": "X0.m"}`
    Json transition(std::size_t index) const {
        const TransitionId id = grafcet_.transitions.id_at(index);
        const Transition& transition = grafcet_.transitions[id];
        Json object;
        object["name"] = transition.name;
        object["from"] = step_names(grafcet_.preceding(transition));
        object["to"] = step_names(grafcet_.following(transition));
        object["condition"] = shown(condition_of(equations_, transition));
        object["clearing"] = shown(equations_.clearing[id]);
        return object;
    }

    /// `{"name": "X0", "initial": true, "cax": "…", …}`; parts that the step has not are left out.
    Json step(std::size_t index) {
        const StepId id = grafcet_.steps.id_at(index);
        const ExprId x = step_expression(equations_, id, reported_.pool);
        const TableConditions table = table_conditions(equations_, id, reported_.pool);
        const StepEquation& step = equations_.steps[id];
        Json object;
        object["name"] = "X" + grafcet_.steps[id].name;
        object["initial"] = grafcet_.steps[id].initial;
        object["cax"] = shown(table.cax);
        object["cdx"] = shown(table.cdx);
        object["x"] = shown(x);
        add_if_present(object, "forcedOff", step.forced_off);
        add_if_present(object, "forcedOn", step.forced_on);
        add_if_present(object, "enclosing", step.enclosing);
        add_if_present(object, "link", step.link);
        if (!with_minimised_) return object;
        const SmallerForms smaller = smaller_forms(reported_, id);
        if (!smaller.any()) return object;
        Json& minimised = object["minimised"];
        add_if_present(minimised, "cax", smaller.cax);
        add_if_present(minimised, "cdx", smaller.cdx);
        add_if_present(minimised, "x", smaller.x);
        return object;
    }

    Json output(std::size_t index) const {
        const OutputEquation& output = equations_.outputs[index];
        Json object;
        object["name"] = grafcet_.outputs[output.output].name;
        object["equation"] = shown(output.value);
        return object;
    }

    Json held(std::size_t index) const {
        const HeldEquation& equation = equations_.held[index];
        Json object;
        object["name"] = grafcet_.vars[equation.var].name;
        object["equation"] = shown(equation.value);
        return object;
    }

    /// A stored output, var or counter with its writes in the order of execution.
    Json stored(std::size_t index) {
        const StoredEquation& stored = equations_.stored[index];
        Json object;
        object["name"] = variable_name(grafcet_, stored.target);
        if (stored.target.kind == VariableKind::counter) {
            const Counter& counter = grafcet_.counters[static_cast<CounterId>(stored.target.index)];
            object["kind"] = "counter";
            object["low"] = counter.low;
            object["high"] = counter.high;
        } else {
            object["kind"] = stored.target.kind == VariableKind::output ? "output" : "var";
            object["set"] = shown(stored.set);
            object["reset"] = shown(stored.reset);
            object["equation"] = shown(stored_expression(stored, reported_.pool));
        }
        object["writes"] = Json::array();
        for (const StoredWrite& write : stored.writes) {
            object["writes"].push_back(
                {{"cause", cause_name(write.cause)},
                 {"trigger", shown(write.trigger)},
                 {"value",
                  write.sum.empty() ? shown(write.value) : sum_text(grafcet_, write.sum)}});
        }
        return object;
    }

    Json time_condition(ExprId id) const {
        const TimeCondition& condition = reported_.pool.time_condition_of(id);
        Json object;
        object["condition"] = shown(id);
        object["operand"] = shown(condition.operand);
        object["onDelay"] = format_duration(condition.on_delay);
        object["offDelay"] = format_duration(condition.off_delay);
        return object;
    }

    Json edge(ExprId id) const {
        Json object;
        object["edge"] = shown(id);
        object["operand"] = shown(reported_.pool.operands(id).front());
        return object;
    }

    Reported& reported_;
    const Equations& equations_;
    const Grafcet& grafcet_;
    bool with_minimised_;
    std::string text_;
};

}  // namespace

std::string write_csv_report(Reported& reported) {
    const Grafcet& grafcet = reported.grafcet;
    const auto formula = [&](ExprId id) {
        return field(write_expression(grafcet, reported.pool, id));
    };
    std::string csv = "variable,CAX,CDX,X\n";
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId id = grafcet.steps.id_at(i);
        const ExprId x = step_expression(reported.equations, id, reported.pool);
        const TableConditions step = table_conditions(reported.equations, id, reported.pool);
        csv += field("X" + grafcet.steps[id].name);
        for (const ExprId part : {step.cax, step.cdx, x}) csv += "," + formula(part);
        csv += '\n';
    }
    const std::vector<ExprId> values = output_values(reported);
    for (std::size_t i = 0; i < values.size(); ++i) {
        csv += field(grafcet.outputs[grafcet.outputs.id_at(i)].name) + ",,," + formula(values[i]) +
               "\n";
    }
    return csv;
}

std::string write_json_report(Reported& reported, bool with_minimised) {
    return JsonReport(reported, with_minimised).write();
}

}  // namespace grafwire
