// What a report for people shows, in which order; the forms for machines are in machine_forms.cpp.
//
// The truth table of a step and its Karnaugh map are those of the course "Mise en œuvre du GRAFCET"
// (section 1.2), which justifies X = CAX + /CDX.X by them: activation wins over deactivation. The
// map has its columns in Gray order, so that the two products are rectangles: the columns 11 and
// 10, and in the row X = 1 the columns 00 and 10.

#include "equations/report/write_equations.h"

#include <fmt/format.h>

#include <array>

#include "equations/report/messages.h"
#include "equations/report/page.h"
#include "equations/report/report_parts.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

namespace say = messages::equation_report;

/// The columns CAX CDX of the map, in Gray order.
struct Column {
    std::string_view label;
    bool cax;
    bool cdx;
};
constexpr std::array<Column, 4> columns{
    {{"00", false, false}, {"01", false, true}, {"11", true, true}, {"10", true, false}}};

/// The memory of a step with priority to activation.
bool next_x(bool x, bool cax, bool cdx) {
    return cax || (!cdx && x);
}

Page::Cell bit(bool value) {
    return Page::words(value ? "1" : "0");
}

void write_truth_table(Language language, Page& page) {
    const std::string x_name = page.quantity("X");
    page.begin_table({Page::formula(x_name + "(t)"), Page::formula(page.quantity("CAX")),
                      Page::formula(page.quantity("CDX")), Page::formula(x_name + "(t+dt)"),
                      Page::words(say::remark.in(language))});
    for (std::size_t i = 0; i < say::remarks.size(); ++i) {
        const bool x = (i & 4U) != 0;
        const bool cax = (i & 2U) != 0;
        const bool cdx = (i & 1U) != 0;
        page.row({bit(x), bit(cax), bit(cdx), bit(next_x(x, cax, cdx)),
                  Page::words(say::remarks[i]->in(language))});
    }
    page.end_table();
}

/// Ones are marked with the groups that cover them: a for CAX, b for /CDX.X.
void write_map(Page& page) {
    std::vector<std::string> labels;
    for (const Column& column : columns) labels.emplace_back(column.label);
    page.begin_map(page.quantity("X"), {page.quantity("CAX"), page.quantity("CDX")}, labels);
    for (const bool x : {false, true}) {
        std::vector<Page::Cell> cells{bit(x)};
        for (const Column& column : columns) {
            std::string text = next_x(x, column.cax, column.cdx) ? "1" : "0";
            if (column.cax) text += " a";
            if (x && !column.cdx) text += column.cax ? "b" : " b";
            cells.push_back(Page::words(text));
        }
        page.row(cells);
    }
    page.end_table();
}

void write_groups(Language language, Page& page) {
    page.begin_table({Page::words(say::group.in(language)), Page::words(say::covers.in(language)),
                      Page::words(say::cells.in(language))});
    page.row({Page::words("a"), Page::formula(page.quantity("CAX")),
              Page::words("0, 11; 0, 10; 1, 11; 1, 10")});
    page.row({Page::words("b"), Page::formula(page.held()), Page::words("1, 00; 1, 10")});
    page.end_table();
    page.begin_equations();
    page.equation(page.quantity("X"), page.quantity("CAX") + " + " + page.held());
    page.end_equations();
}

/// What a step makes of its CAX and CDX, which is the same for all.
void write_karnaugh(Language language, Page& page) {
    page.heading(say::karnaugh.in(language));
    page.paragraph(say::same_for_all.in(language));
    write_truth_table(language, page);
    write_map(page);
    write_groups(language, page);
}

/// Of the steps that have some.
void write_smaller_forms(Reported& reported, Language language, Page& page) {
    bool has_begun = false;
    for (std::size_t i = 0; i < reported.grafcet.steps.size(); ++i) {
        const StepId step = reported.grafcet.steps.id_at(i);
        const SmallerForms smaller = smaller_forms(reported, step);
        if (!smaller.any()) continue;
        if (!has_begun) {
            page.heading(say::smaller.in(language));
            page.begin_equations();
            has_begun = true;
        }
        const auto show = [&](std::string_view quantity, ExprId id) {
            if (id != no_expr) page.equation(page.of_step(quantity, step), page.expression(id));
        };
        show("CAX", smaller.cax);
        show("CDX", smaller.cdx);
        show("X", smaller.x);
    }
    if (has_begun) page.end_equations();
}

/// A report for people, part by part; how it looks is the affair of the page.
class Report {
  public:
    Report(Reported& reported, const EquationReport& report, Page& page)
        : reported_(reported),
          equations_(reported.equations),
          grafcet_(reported.grafcet),
          karnaugh_(report.karnaugh),
          language_(report.language),
          page_(page) {}

    void write() {
        opening();
        transitions();
        conditions();
        steps();
        outputs();
        held();
        stored();
        counters();
        memories();
        if (!karnaugh_) return;
        write_karnaugh(language_, page_);
        write_smaller_forms(reported_, language_, page_);
    }

  private:
    Page::Cell shown(ExprId id) const { return page_.cell(id); }
    Page::Cell shown(Variable variable) const { return Page::formula(page_.name(variable)); }

    Page::Cell word(const Message<>& message) const { return Page::words(message.in(language_)); }

    static Variable step_of(std::size_t index) {
        return {VariableKind::step, static_cast<std::uint32_t>(index)};
    }

    /// The title, and how the equations were derived.
    void opening() {
        const std::string& title = grafcet_.title;
        page_.title(title.empty() ? say::title.in(language_, grafcet_.name)
                                  : say::title_in_full.in(language_, grafcet_.name, title));
        const bool with_modes = equations_.options.modes;
        const Message<>& basis =
            equations_.options.cdx == CdxForm::successor
                ? (with_modes ? say::successor_form_with_modes : say::successor_form_without_modes)
                : (with_modes ? say::transition_form_with_modes
                              : say::transition_form_without_modes);
        page_.paragraph(basis.in(language_));
    }

    /// The transition condition as it is written, and with it what clears the transition: the
    /// steps before it, and that nothing freezes it.
    void transitions() {
        if (grafcet_.transitions.empty()) return;
        page_.heading(say::transitions.in(language_));
        page_.begin_table({word(say::transition), word(say::passage),
                           word(say::transition_condition), word(say::clearing_condition)});
        for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
            const TransitionId id = grafcet_.transitions.id_at(i);
            const Transition& transition = grafcet_.transitions[id];
            page_.row({Page::words("(" + transition.name + ")"),
                       Page::formula(page_.passage(grafcet_.preceding(transition),
                                                   grafcet_.following(transition))),
                       shown(condition_of(equations_, transition)),
                       shown(equations_.clearing[id])});
        }
        page_.end_table();
    }

    /// CAX and CDX as the course tabulates them.
    void conditions() {
        page_.heading(say::conditions.in(language_));
        page_.begin_table({word(say::step), Page::words("CAX"), Page::words("CDX")});
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId id = grafcet_.steps.id_at(i);
            const TableConditions step = table_conditions(equations_, id, reported_.pool);
            page_.row({shown(step_of(i)), shown(step.cax), shown(step.cdx)});
        }
        page_.end_table();
    }

    void steps() {
        page_.heading(say::steps.in(language_));
        page_.begin_equations();
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId id = grafcet_.steps.id_at(i);
            const ExprId x = step_expression(equations_, id, reported_.pool);
            page_.equation(page_.name(step_of(i)), page_.expression(x));
        }
        page_.end_equations();
    }

    void outputs() {
        if (equations_.outputs.empty()) return;
        page_.heading(say::outputs.in(language_));
        page_.begin_equations();
        for (const OutputEquation& output : equations_.outputs) {
            page_.equation(
                page_.name({VariableKind::output, static_cast<std::uint32_t>(output.output)}),
                page_.expression(output.value));
        }
        page_.end_equations();
    }

    void held() {
        if (equations_.held.empty()) return;
        page_.heading(say::held.in(language_));
        page_.begin_equations();
        for (const HeldEquation& equation : equations_.held) {
            page_.equation(page_.name(equation.var), page_.expression(equation.value));
        }
        page_.end_equations();
    }

    /// Set and reset of each variable, then its equation.
    void stored() {
        std::vector<const StoredEquation*> shown_ones;
        for (const StoredEquation& stored : equations_.stored) {
            if (stored.target.kind != VariableKind::counter) shown_ones.push_back(&stored);
        }
        if (shown_ones.empty()) return;

        page_.heading(say::stored.in(language_));
        page_.begin_table({word(say::variable), word(say::set), word(say::reset)});
        for (const StoredEquation* stored : shown_ones) {
            page_.row({shown(stored->target), shown(stored->set), shown(stored->reset)});
        }
        page_.end_table();
        page_.begin_equations();
        for (const StoredEquation* stored : shown_ones) {
            page_.equation(page_.name(stored->target),
                           page_.expression(stored_expression(*stored, reported_.pool)));
        }
        page_.end_equations();
    }

    /// A row per write: counters have no Boolean equation.
    void counters() {
        bool begun = false;
        for (const StoredEquation& stored : equations_.stored) {
            if (stored.target.kind != VariableKind::counter) continue;
            if (!begun) {
                page_.heading(say::counters.in(language_));
                page_.begin_table(
                    {word(say::counter), word(say::range), word(say::when), word(say::write)});
                begun = true;
            }
            const Counter& counter = grafcet_.counters[static_cast<CounterId>(stored.target.index)];
            const std::string range = fmt::format("{}..{}", counter.low, counter.high);
            for (const StoredWrite& write : stored.writes) {
                page_.row({shown(stored.target), Page::words(range), shown(write.trigger),
                           Page::formula(page_.write(stored.target, write))});
            }
        }
        if (begun) page_.end_table();
    }

    /// What has to be remembered from scan to scan beside the steps.
    void memories() {
        const Expressions& pool = reported_.pool;
        const UsedMemories used = used_memories(grafcet_, equations_);
        if (!used.time_conditions.empty()) {
            page_.heading(say::time_conditions.in(language_));
            page_.begin_table({word(say::time_condition), word(say::operand), word(say::on_after),
                               word(say::off_after)});
            for (const ExprId id : used.time_conditions) {
                const TimeCondition& condition = pool.time_condition_of(id);
                page_.row({shown(id), shown(condition.operand),
                           Page::words(shown_duration(condition.on_delay).in(language_)),
                           Page::words(shown_duration(condition.off_delay).in(language_))});
            }
            page_.end_table();
        }
        if (!used.edges.empty()) {
            page_.heading(say::edges.in(language_));
            page_.begin_table({word(say::edge), word(say::operand)});
            for (const ExprId id : used.edges) {
                page_.row({shown(id), shown(pool.operands(id).front())});
            }
            page_.end_table();
        }
    }

    Reported& reported_;
    const Equations& equations_;
    const Grafcet& grafcet_;
    bool karnaugh_;
    Language language_;
    Page& page_;
};

}  // namespace

/// Right-hand sides are built in a copy of the pool, which the page reads from while it grows.
std::string write_equations(const Grafcet& grafcet, const Equations& equations,
                            const EquationReport& report) {
    Reported reported{grafcet, equations, equations.expressions};
    std::unique_ptr<Page> page;
    switch (report.format) {
        case EquationFormat::csv:
            return write_csv_report(reported);
        case EquationFormat::json:
            return write_json_report(reported, report.karnaugh);
        case EquationFormat::text:
            page = text_page(grafcet, reported.pool);
            break;
        case EquationFormat::markdown:
            page = markdown_page(grafcet, reported.pool);
            break;
        case EquationFormat::latex:
            page = latex_page(grafcet, reported.pool, report.language, report.standalone);
            break;
        case EquationFormat::html:
            page = html_page(grafcet, reported.pool);
            break;
    }
    Report(reported, report, *page).write();
    return page->finish();
}

}  // namespace grafwire
