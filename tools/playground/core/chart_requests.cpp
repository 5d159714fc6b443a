// The chart itself: what is wrong with it, what it consists of, its text laid out, its equations.

#include "core/asked_chart.h"
#include "core/messages.h"
#include "core/places.h"
#include "core/requests.h"
#include "grafcet/describe_grafcet.h"
#include "grafcet/write_grafcet.h"
#include "text/version.h"

namespace grafwire::playground {

namespace {

/// Writes down what a chart consists of.
class ChartParts {
  public:
    ChartParts(const Chart& chart, const Places& places)
        : grafcet_(chart.grafcet), places_(places) {}

    Json all(Language language) const {
        Json parts{{"name", grafcet_.name}, {"title", grafcet_.title}};
        parts["inputs"] = each(grafcet_.inputs, [](const Input&, Json&) {});
        parts["controls"] = controls();
        parts["outputs"] = each(grafcet_.outputs, [](const Output& output, Json& part) {
            part["stored"] = output.stored;
        });
        parts["vars"] = each(grafcet_.vars, [](const Var&, Json&) {});
        parts["counters"] = each(grafcet_.counters, [](const Counter& counter, Json& part) {
            part["low"] = counter.low;
            part["high"] = counter.high;
        });
        parts["steps"] = each(grafcet_.steps, [this](const Step& step, Json& part) {
            part["variable"] = "X" + step.name;
            part["graph"] = grafcet_.graphs[step.graph].name;
            part["initial"] = step.initial;
        });
        parts["transitions"] = transitions();
        parts["actions"] = actions();
        Json graphs = Json::array();
        for (const Graph& graph : grafcet_.graphs) graphs.push_back(graph.name);
        parts["graphs"] = std::move(graphs);
        parts["macros"] = each(grafcet_.macros, [this](const Macro& macro, Json& part) {
            part["graph"] = grafcet_.graphs[macro.graph].name;
        });
        Json assumptions = Json::array();
        for (const Assumption& item : grafcet_.assumptions) {
            assumptions.push_back(text_of(item.expression));
        }
        parts["assumptions"] = std::move(assumptions);
        parts["names"] = names();
        parts["description"] = describe_grafcet(grafcet_, language);
        return parts;
    }

  private:
    std::string text_of(ExprId expression) const {
        return write_expression(grafcet_, grafcet_.expressions, expression);
    }
    void add_place(Json& part, Location where) const {
        const Span span = places_.at(where);
        part["from"] = span.from;
        part["to"] = span.to;
    }

    template <typename Parts, typename Add>
    Json each(const Parts& parts, const Add& add) const {
        Json list = Json::array();
        for (const auto& item : parts) {
            Json part{{"name", item.name}};
            add(item, part);
            add_place(part, item.where);
            list.push_back(std::move(part));
        }
        return list;
    }

    Json controls() const {
        Json list = Json::array();
        for (std::size_t i = grafcet_.inputs.size(); i < grafcet_.all_input_count(); ++i) {
            list.push_back(input_name(grafcet_, i));
        }
        return list;
    }

    Json steps_of(std::span<const StepId> ids) const {
        Json list = Json::array();
        for (const StepId id : ids) list.push_back(grafcet_.steps[id].name);
        return list;
    }

    Json transitions() const {
        Json list = Json::array();
        for (const Transition& transition : grafcet_.transitions) {
            Json part{{"name", '(' + transition.name + ')'},
                      {"graph", grafcet_.graphs[transition.graph].name},
                      {"from_steps", steps_of(grafcet_.preceding(transition))},
                      {"to_steps", steps_of(grafcet_.following(transition))},
                      {"condition", text_of(transition.condition)}};
            add_place(part, transition.where);
            list.push_back(std::move(part));
        }
        return list;
    }

    std::string text_of(const Action& action) const {
        switch (action.kind) {
            case ActionKind::continuous:
                return grafcet_.outputs[action.output].name;
            case ActionKind::held:
                return grafcet_.vars[action.var].name;
            case ActionKind::stored:
                return write_write(grafcet_, action.write);
            case ActionKind::order:
                return write_order(grafcet_, grafcet_.orders[action.order]);
        }
        return {};
    }
    Json actions() const {
        Json list = Json::array();
        for (const Action& action : grafcet_.actions) {
            Json part{{"step", grafcet_.steps[action.step].name}, {"text", text_of(action)}};
            add_place(part, action.where);
            list.push_back(std::move(part));
        }
        return list;
    }

    /// What an editor may propose.
    Json names() const {
        Json list = Json::array();
        const auto add = [&](const std::string& name, std::string_view kind) {
            std::string text;
            append_variable_name(text, name);
            list.push_back({{"name", name}, {"kind", kind}, {"text", text}});
        };
        for (const Input& input : grafcet_.inputs) add(input.name, "input");
        for (std::size_t i = grafcet_.inputs.size(); i < grafcet_.all_input_count(); ++i) {
            add(std::string(input_name(grafcet_, i)), "control");
        }
        for (const Output& output : grafcet_.outputs) add(output.name, "output");
        for (const Var& var : grafcet_.vars) add(var.name, "var");
        for (const Counter& counter : grafcet_.counters) add(counter.name, "counter");
        for (const Step& step : grafcet_.steps) add("X" + step.name, "step");
        for (const Graph& graph : grafcet_.graphs) add(graph.name, "graph");
        for (const Macro& macro : grafcet_.macros) add(macro.name, "macro");
        return list;
    }

    const Grafcet& grafcet_;
    const Places& places_;
};

}  // namespace

Json answer_version(const Arguments&, const Asked&) {
    return Json{{"version", version()}};
}

Json answer_chart(const Arguments& arguments, const Asked&) {
    const Language language = arguments.language();
    const SourceFile source{arguments.text("file", "chart.grafcet"), arguments.text("text")};
    Json answer = Json::object();
    const CdxRow* cdx = asked_row(arguments, "cdx", cdx_table, answer);
    if (cdx == nullptr) return answer;
    Diagnostics diagnostics;
    const auto chart = read_chart(source, diagnostics);
    answer["diagnostics"] = diagnostics_answer(diagnostics, source.text, language);
    if (!chart) return answer;
    const Diagnostics of_wiring = wiring_warnings(*chart, cdx->form);
    for (Json& item : diagnostics_answer(of_wiring, source.text, language)) {
        answer["diagnostics"].push_back(std::move(item));
    }
    answer["chart"] = ChartParts(*chart, Places(source.text)).all(language);
    return answer;
}

Json answer_format(const Arguments& arguments, const Asked&) {
    const Language language = arguments.language();
    const SourceFile source{arguments.text("file", "chart.grafcet"), arguments.text("text")};
    Diagnostics diagnostics;
    const auto text = format_chart(source, language, diagnostics);
    if (text) return Json{{"text", *text}};
    Json answer = error_answer(say::bad_chart(), language);
    answer["diagnostics"] = diagnostics_answer(diagnostics, source.text, language);
    return answer;
}

Json answer_equations(const Arguments& arguments, const Asked&) {
    Json answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const CdxRow* cdx = asked_row(arguments, "cdx", cdx_table, answer);
    if (cdx == nullptr) return answer;
    const EquationFormatRow* format = asked_row(arguments, "to", equation_format_table, answer);
    if (format == nullptr) return answer;
    return Json{
        {"text", equation_report(*chart, {cdx->form, arguments.flag("modes", true)},
                                 {format->format, arguments.flag("karnaugh", false),
                                  arguments.language(), arguments.flag("standalone", false)})}};
}

}  // namespace grafwire::playground
