#include "equations/report/reports.h"
#include "grafcet/write_grafcet.h"
#include "text/csv.h"

namespace grafwire {

namespace {

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

}  // namespace grafwire
