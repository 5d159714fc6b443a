// Lists are cut after a few names and the hierarchy is shown once for each graph, so that the text
// stays readable and of a size proportional to the number of graphs, however large the GRAFCET is.

#include "grafcet/describe_grafcet.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/messages.h"
#include "grafcet/write_grafcet.h"
#include "text/counted.h"

namespace grafwire {

namespace say = messages::grafcet;
namespace counted = messages::counted;

namespace {

/// The text, part by part. Lists are cut where nobody would read on.
class Description {
  public:
    Description(const Grafcet& grafcet, Language language)
        : grafcet_(grafcet), language_(language) {}

    std::string write() {
        write_head();
        write_graphs();
        write_macros();
        write_enclosures();
        write_hierarchy();
        return std::move(out_);
    }

  private:
    static constexpr std::size_t most_listed = 24;

    std::string step_name(StepId step) const {
        return quoted_where_needed(grafcet_.steps[step].name);
    }
    std::string graph_name(GraphId graph) const {
        return quoted_where_needed(grafcet_.graphs[graph].name);
    }

    /// The first of `count` texts, separated by commas.
    template <typename TextAt>
    std::string listed(std::size_t count, const TextAt& text_at) const {
        std::string result;
        for (std::size_t i = 0; i < std::min(count, most_listed); ++i) {
            result += fmt::format("{}{}", i == 0 ? "" : ", ", text_at(i));
        }
        if (count <= most_listed) return result;
        return say::and_more.in(language_, result, count - most_listed);
    }

    /// The name, the title, and how many of everything.
    void write_head() {
        out_ += fmt::format("GRAFCET {}", quoted_where_needed(grafcet_.name));
        if (!grafcet_.title.empty()) out_ += fmt::format(" \"{}\"", grafcet_.title);
        const auto initial =
            static_cast<std::size_t>(std::count_if(grafcet_.steps.begin(), grafcet_.steps.end(),
                                                   [](const Step& step) { return step.initial; }));
        out_ += fmt::format("\n  {}, {}, {}, {}, {}\n",
                            counted::graphs.in(language_, grafcet_.graphs.size()),
                            counted::steps.in(language_, grafcet_.steps.size()),
                            counted::initial_steps.in(language_, initial),
                            counted::transitions.in(language_, grafcet_.transitions.size()),
                            counted::macro_steps.in(language_, grafcet_.macros.size()));
        out_ +=
            fmt::format("  {}, {}, {}, {}\n", counted::inputs.in(language_, grafcet_.inputs.size()),
                        counted::outputs.in(language_, grafcet_.outputs.size()),
                        counted::vars.in(language_, grafcet_.vars.size()),
                        counted::counters.in(language_, grafcet_.counters.size()));
        out_ += fmt::format(
            "  {}, {}\n", counted::edges.in(language_, grafcet_.expressions.edges().size()),
            counted::time_conditions.in(language_, grafcet_.expressions.time_conditions().size()));
    }

    void write_title(const Message<>& title) { out_ += fmt::format("\n{}\n", title.in(language_)); }

    /// Each graph with the names of its steps and transitions.
    void write_graphs() {
        write_title(say::graphs);
        for (const Graph& graph : grafcet_.graphs) {
            out_ += fmt::format(
                "  {}\n",
                say::graph_line.in(language_, quoted_where_needed(graph.name),
                                   counted::steps.in(language_, graph.steps.count),
                                   counted::transitions.in(language_, graph.transitions.count)));
            if (graph.steps.count != 0) {
                const std::string steps = listed(graph.steps.count, [&](std::size_t i) {
                    return step_in_list(graph.steps.first + i);
                });
                out_ += fmt::format("    {}\n", say::steps_line.in(language_, steps));
            }
            if (graph.transitions.count != 0) {
                const std::string transitions = listed(graph.transitions.count, [&](std::size_t i) {
                    return transition_in_list(graph.transitions.first + i);
                });
                out_ += fmt::format("    {}\n", say::transitions_line.in(language_, transitions));
            }
        }
    }

    std::string step_in_list(std::size_t index) const {
        const Step& step = grafcet_.steps.items()[index];
        const std::string name = quoted_where_needed(step.name);
        return step.initial ? say::initial_step.in(language_, name) : name;
    }
    std::string transition_in_list(std::size_t index) const {
        return quoted_where_needed(grafcet_.transitions.items()[index].name);
    }

    void write_macros() {
        if (grafcet_.macros.empty()) return;
        write_title(say::macro_steps);
        for (const Macro& macro : grafcet_.macros) {
            out_ += fmt::format(
                "  {}\n",
                say::macro_step_line.in(language_, quoted_where_needed(macro.name),
                                        quoted_where_needed(grafcet_.blocks[macro.block].name),
                                        quoted_where_needed(grafcet_.blocks[macro.expansion].name),
                                        step_name(macro.entry), step_name(macro.exit),
                                        counted::steps.in(language_, macro.steps.count)));
        }
    }

    void write_enclosures() {
        if (grafcet_.enclosures.empty()) return;
        write_title(say::enclosing_steps);
        for (const Enclosure& enclosure : grafcet_.enclosures) {
            out_ += fmt::format(
                "  {}\n", say::enclosure_line.in(language_, step_name(enclosure.step),
                                                 graph_name(grafcet_.steps[enclosure.step].graph),
                                                 graph_name(enclosure.graph),
                                                 listed(enclosure.links.size(), [&](std::size_t i) {
                                                     return step_name(enclosure.links[i]);
                                                 })));
        }
    }

    /// What one graph does to another: forcing, freezing, enclosing.
    struct Dominance {
        GraphId over{};
        GraphId under{};
        std::vector<std::string> forced_by, frozen_by, enclosed_by;
    };

    /// Dominances by the graph above, then by the graph below.
    std::vector<Dominance> dominances() const {
        struct Part {
            GraphId over, under;
            const Order* order;
            StepId step;
        };
        std::vector<Part> parts;
        for (const Order& order : grafcet_.orders) {
            parts.push_back({grafcet_.steps[order.step].graph, order.graph, &order, order.step});
        }
        for (const Enclosure& enclosure : grafcet_.enclosures) {
            parts.push_back(
                {grafcet_.steps[enclosure.step].graph, enclosure.graph, nullptr, enclosure.step});
        }
        std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
            return a.over != b.over ? a.over < b.over : a.under < b.under;
        });
        std::vector<Dominance> result;
        for (const Part& part : parts) {
            if (result.empty() || result.back().over != part.over ||
                result.back().under != part.under) {
                result.push_back({part.over, part.under, {}, {}, {}});
            }
            Dominance& dominance = result.back();
            if (part.order == nullptr) {
                dominance.enclosed_by.push_back(step_name(part.step));
            } else if (part.order->kind == OrderKind::freeze) {
                dominance.frozen_by.push_back(step_name(part.step));
            } else {
                dominance.forced_by.push_back(step_name(part.step) + situation_of(*part.order));
            }
        }
        return result;
    }

    std::string situation_of(const Order& order) const {
        if (order.kind == OrderKind::empty) return " {}";
        if (order.kind == OrderKind::initial) return " {INIT}";
        return " {" +
               listed(order.steps.size(),
                      [&](std::size_t i) { return step_name(order.steps[i]); }) +
               "}";
    }

    /// A dominance of freezing alone is shown but not followed: freezing may go in circles.
    static bool is_followed(const Dominance& dominance) {
        return !dominance.forced_by.empty() || !dominance.enclosed_by.empty();
    }

    /// A tree for every graph that dominates others and is under none.
    void write_hierarchy() {
        const std::vector<Dominance> all = dominances();
        if (all.empty()) return;
        write_title(say::hierarchy);
        std::vector<std::size_t> first(grafcet_.graphs.size() + 1, 0);
        std::vector<bool> is_under(grafcet_.graphs.size(), false);
        for (const Dominance& dominance : all) {
            ++first[index_of(dominance.over) + 1];
            if (is_followed(dominance)) is_under[index_of(dominance.under)] = true;
        }
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        std::vector<bool> is_shown(grafcet_.graphs.size(), false);
        for (std::size_t graph = 0; graph < grafcet_.graphs.size(); ++graph) {
            if (is_under[graph] || first[graph] == first[graph + 1]) continue;
            out_ += fmt::format("  {}\n", graph_name(static_cast<GraphId>(graph)));
            write_below(graph, all, first, is_shown);
        }
    }

    /// A graph under several others is shown in full once, and then only named.
    void write_below(std::size_t top, const std::vector<Dominance>& all,
                     const std::vector<std::size_t>& first, std::vector<bool>& is_shown) {
        /// A graph that is open, and the next of its dominances.
        struct Place {
            std::size_t graph, next;
        };
        std::vector<Place> open = {{top, first[top]}};
        while (!open.empty()) {
            Place& place = open.back();
            if (place.next == first[place.graph + 1]) {
                open.pop_back();
                continue;
            }
            const Dominance& dominance = all[place.next++];
            const std::size_t under = index_of(dominance.under);
            const bool has_more = is_followed(dominance) && first[under] != first[under + 1];
            write_dominance(dominance, open.size(), has_more && is_shown[under]);
            if (!has_more || is_shown[under]) continue;
            is_shown[under] = true;
            open.push_back({under, first[under]});
        }
    }

    /// `G2: forced by 10 {INIT}, 20 {}; enclosed by 5`
    void write_dominance(const Dominance& dominance, std::size_t depth, bool is_shown_above) {
        constexpr std::size_t deepest_indent = 20;
        out_.append(2 + 2 * std::min(depth, deepest_indent), ' ');
        std::string line = graph_name(dominance.under);
        bool is_first = true;
        const auto add = [&](const Message<std::string>& phrase,
                             const std::vector<std::string>& steps) {
            if (steps.empty()) return;
            const std::string part =
                phrase.in(language_, listed(steps.size(), [&](std::size_t i) { return steps[i]; }));
            line = (is_first ? say::dominance : say::further_dominance).in(language_, line, part);
            is_first = false;
        };
        add(say::forced_by, dominance.forced_by);
        add(say::frozen_by, dominance.frozen_by);
        add(say::enclosed_by, dominance.enclosed_by);
        if (is_shown_above) line = say::shown_above.in(language_, line);
        out_ += line;
        out_ += '\n';
    }

    const Grafcet& grafcet_;
    Language language_;
    std::string out_;
};

}  // namespace

std::string describe_grafcet(const Grafcet& grafcet, Language language) {
    return Description(grafcet, language).write();
}

}  // namespace grafwire
