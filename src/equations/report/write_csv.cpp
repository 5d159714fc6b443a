#include "equations/equation_text.h"
#include "equations/report/report_parts.h"
#include "equations/report/reports.h"

namespace grafwire {

namespace {

// A field of RFC 4180: quoted only where it has to be.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

// The right-hand side of every output, in the order of declaration.
std::vector<ExprId> output_values(Equations& equations) {
    std::vector<ExprId> values(equations.grafcet->outputs.size(), no_expr);
    for (const OutputEquation& output : equations.outputs)
        values[index_of(output.output)] = output.value;
    for (const StoredEquation& stored : equations.stored)
        if (stored.target.kind == VariableKind::output)
            values[stored.target.index] = stored_expression(equations, stored);
    return values;
}

}  // namespace

std::string write_csv_report(Equations& equations) {
    const Grafcet& grafcet = *equations.grafcet;
    std::string csv = "variable,CAX,CDX,X\n";
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId id = grafcet.steps.id_at(i);
        const ExprId x = step_expression(equations, id);
        const TableConditions step = table_conditions(equations, id);
        csv += field("X" + grafcet.steps[id].name);
        for (const ExprId part : {step.cax, step.cdx, x})
            csv += "," + field(equation_text(equations, part));
        csv += '\n';
    }
    const std::vector<ExprId> values = output_values(equations);
    for (std::size_t i = 0; i < values.size(); ++i)
        csv += field(grafcet.outputs[grafcet.outputs.id_at(i)].name) + ",,," +
               field(equation_text(equations, values[i])) + "\n";
    return csv;
}

}  // namespace grafwire
