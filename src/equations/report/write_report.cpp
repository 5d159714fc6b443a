// What a report for people shows, in which order; how it looks is the page's affair.

#include <fmt/format.h>

#include "equations/report/reports.h"

namespace grafwire {

namespace {

class Report {
  public:
    Report(Reported& reported, const EquationReport& report, Page& page)
        : reported_(reported),
          equations_(reported.equations),
          grafcet_(reported.grafcet),
          karnaugh_(report.karnaugh),
          words_(words(report.language)),
          page_(page) {}

    void write() {
        opening();
        conditions();
        steps();
        outputs();
        stored();
        counters();
        memories();
        if (!karnaugh_) return;
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            write_karnaugh(reported_, grafcet_.steps.id_at(i), words_, page_);
        }
    }

  private:
    Page::Cell shown(ExprId id) const { return Page::formula(page_.expression(id)); }
    Page::Cell shown(Variable variable) const { return Page::formula(page_.name(variable)); }

    static Variable step_of(std::size_t index) {
        return {VariableKind::step, static_cast<std::uint32_t>(index)};
    }

    void opening() {
        std::string title = fmt::format("{} {}", words_.title, grafcet_.name);
        if (!grafcet_.title.empty()) title += fmt::format(" ({})", grafcet_.title);
        page_.title(title);
        const EquationOptions& options = equations_.options;
        page_.paragraph(fmt::format(
            "{}, {}.",
            options.cdx == CdxForm::successor ? words_.successor_form : words_.transition_form,
            options.modes ? words_.with_modes : words_.without_modes));
    }

    void conditions() {
        page_.heading(words_.conditions);
        page_.begin_table({Page::words(words_.step), Page::words("CAX"), Page::words("CDX")});
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId id = grafcet_.steps.id_at(i);
            const TableConditions step = table_conditions(equations_, id, reported_.pool);
            page_.row({shown(step_of(i)), shown(step.cax), shown(step.cdx)});
        }
        page_.end_table();
    }

    void steps() {
        page_.heading(words_.steps);
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
        page_.heading(words_.outputs);
        page_.begin_equations();
        for (const OutputEquation& output : equations_.outputs) {
            page_.equation(
                page_.name({VariableKind::output, static_cast<std::uint32_t>(output.output)}),
                page_.expression(output.value));
        }
        page_.end_equations();
    }

    void stored() {
        std::vector<const StoredEquation*> shown_ones;
        for (const StoredEquation& stored : equations_.stored) {
            if (stored.target.kind != VariableKind::counter) shown_ones.push_back(&stored);
        }
        if (shown_ones.empty()) return;

        page_.heading(words_.stored);
        page_.begin_table(
            {Page::words(words_.variable), Page::words(words_.set), Page::words(words_.reset)});
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

    void counters() {
        bool begun = false;
        for (const StoredEquation& stored : equations_.stored) {
            if (stored.target.kind != VariableKind::counter) continue;
            if (!begun) {
                page_.heading(words_.counters);
                page_.begin_table({Page::words(words_.counter), Page::words(words_.range),
                                   Page::words(words_.when), Page::words(words_.write)});
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

    void memories() {
        const Expressions& pool = reported_.pool;
        const UsedMemories used = used_memories(grafcet_, equations_);
        if (!used.time_conditions.empty()) {
            page_.heading(words_.time_conditions);
            page_.begin_table({Page::words(words_.time_condition), Page::words(words_.operand),
                               Page::words(words_.on_after), Page::words(words_.off_after)});
            for (const ExprId id : used.time_conditions) {
                const TimeCondition& condition = pool.time_condition_of(id);
                page_.row({shown(id), shown(condition.operand),
                           Page::words(format_duration(condition.on_delay)),
                           Page::words(format_duration(condition.off_delay))});
            }
            page_.end_table();
        }
        if (!used.edges.empty()) {
            page_.heading(words_.edges);
            page_.begin_table({Page::words(words_.edge), Page::words(words_.operand)});
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
    const Words& words_;
    Page& page_;
};

}  // namespace

void write_report(Reported& reported, const EquationReport& report, Page& page) {
    Report(reported, report, page).write();
}

}  // namespace grafwire
