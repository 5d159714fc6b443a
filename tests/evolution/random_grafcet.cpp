#include "evolution/random_grafcet.h"

#include <vector>

namespace grafwire {

namespace {

struct Graph {
    std::vector<int> steps;
    std::vector<bool> initial;
};

std::string named(std::string prefix, std::size_t number) {
    prefix += std::to_string(number);
    return prefix;
}

class Generator {
  public:
    explicit Generator(Random& random) : random_(random) {}

    std::string grafcet() {
        const std::size_t count = 1 + random_.below(4);
        for (std::size_t g = 0; g < count; ++g) {
            Graph graph;
            const std::size_t size = 1 + random_.below(4);
            for (std::size_t s = 0; s < size; ++s) {
                graph.steps.push_back(static_cast<int>(10 * g + s));
                graph.initial.push_back(s == 0 || random_.one_in(5));
            }
            graphs_.push_back(graph);
        }
        std::string text =
            "input a, b, c\noutput o, p, s\nvar v, w\ncounter k : 0..3\ncounter m : -1..2\n";
        choose_enclosures();
        for (std::size_t g = 0; g < count; ++g) text += graph_text(g);
        return text;
    }

  private:
    void choose_enclosures() {
        encloses_.assign(graphs_.size(), std::vector<int>(4, -1));
        for (std::size_t g = 1; g < graphs_.size(); ++g) {
            if (!random_.one_in(3)) continue;
            const std::size_t outer = random_.below(static_cast<std::uint32_t>(g));
            const std::size_t s =
                random_.below(static_cast<std::uint32_t>(graphs_[outer].steps.size()));
            if (encloses_[outer][s] >= 0) continue;
            encloses_[outer][s] = static_cast<int>(g);
            // A graph is initial just as its enclosing step is.
            if (!graphs_[outer].initial[s])
                graphs_[g].initial.assign(graphs_[g].steps.size(), false);
        }
    }

    std::string graph_text(std::size_t g) {
        const Graph& graph = graphs_[g];
        std::string text = "graph G" + std::to_string(g) + " {\n";
        for (std::size_t s = 0; s < graph.steps.size(); ++s) {
            text += graph.initial[s] ? "  initial " : "  step ";
            text += std::to_string(graph.steps[s]);
            if (encloses_[g][s] >= 0) {
                const auto inner = static_cast<std::size_t>(encloses_[g][s]);
                text += " encloses G" + std::to_string(inner) + "{" + some_steps(inner) + "}";
            }
            text += actions(g, g == 0 && s == 0) + "\n";
        }
        const std::uint32_t count = 1 + random_.below(6);
        for (std::uint32_t t = 0; t < count; ++t) text += "  " + transition(g) + "\n";
        return text + "}\n";
    }

    std::string step(std::size_t g) {
        const Graph& graph = graphs_[g];
        return std::to_string(
            graph.steps[random_.below(static_cast<std::uint32_t>(graph.steps.size()))]);
    }
    std::string any_step() {
        return step(random_.below(static_cast<std::uint32_t>(graphs_.size())));
    }

    std::string some_steps(std::size_t g) {
        std::string first = step(g);
        if (!random_.one_in(3)) return first;
        const std::string second = step(g);
        return second == first ? first : first + ", " + second;
    }

    std::string actions(std::size_t g, bool first) {
        // The output s is driven at least once, so that it can be read.
        std::string text = first ? " : reset s on ↑c" : "";
        for (std::uint32_t count = random_.below(4); count > 0; --count) {
            text += text.empty() ? " : " : ", ";
            text += action(g);
        }
        return text;
    }

    std::string action(std::size_t g) {
        if (g + 1 < graphs_.size() && random_.one_in(3)) {
            const std::size_t target =
                g + 1 + random_.below(static_cast<std::uint32_t>(graphs_.size() - g - 1));
            const std::string name = named("G", target);
            switch (random_.below(5)) {
                case 0:
                    return name + "{}";
                case 1:
                    return name + "{INIT}";
                case 2:
                    return name + "{" + some_steps(target) + "}";
                default:
                    return name + "{*}";
            }
        }
        if (random_.one_in(2)) {
            const std::string output = random_.one_in(2) ? "o" : "p";
            return random_.one_in(3) ? output : output + " if " + expression(2, false);
        }
        switch (random_.below(4)) {
            case 0:
                return stored() + " on deactivation";
            case 1:
                return stored() + " on " + expression(2, true);
            default:
                return stored();
        }
    }

    std::string stored() {
        static const char* const targets[] = {"v", "w", "s"};
        const std::string target = targets[random_.below(3)];
        switch (random_.below(5)) {
            case 0:
                return "set " + target;
            case 1:
                return "reset " + target;
            case 2:
                return target + " := " + expression(2, true);
            default:
                return std::string(random_.one_in(2) ? "k" : "m") + " := " + sum();
        }
    }

    std::string sum() {
        static const char* const sums[] = {"k + 1", "m + 1", "k - 1", "0",     "m - k",
                                           "-m",    "k - 2", "m + 2", "1 - m", "k + m"};
        return sums[random_.below(10)];
    }

    std::string transition(std::size_t g) {
        std::string before = random_.one_in(10) ? "" : some_steps(g);
        std::string after = random_.one_in(10) ? "" : some_steps(g);
        if (before.empty() && after.empty()) after = step(g);
        std::string text = before + " -> " + after + " : " + expression(3, true);
        if (random_.one_in(3)) text += " do " + stored();
        return text;
    }

    std::string expression(int depth, bool edges) {
        if (depth == 0 || random_.one_in(4)) return leaf();
        const std::string x = expression(depth - 1, edges);
        switch (random_.below(edges ? 9 : 6)) {
            case 0:
                return "/(" + x + ")";
            case 1:
                return "(" + x + " . " + expression(depth - 1, edges) + ")";
            case 2:
                return "(" + x + " + " + expression(depth - 1, edges) + ")";
            case 3:
                return "(" + x + " ⊕ " + expression(depth - 1, edges) + ")";
            case 4:
                return duration() + "/(" + expression(depth - 1, true) + ")";
            case 5:
                return duration() + "/(" + expression(depth - 1, true) + ")/" + duration();
            case 6:
                return "↓(" + x + ")";
            default:
                return "↑(" + x + ")";
        }
    }

    std::string duration() {
        static const char* const durations[] = {"0s", "1ms", "2ms", "3ms", "5ms"};
        return durations[random_.below(5)];
    }

    std::string leaf() {
        switch (random_.below(14)) {
            case 0:
                return "1";
            case 1:
                return "v";
            case 2:
                return "w";
            case 3:
                return "s";
            case 4:
                return random_.one_in(2) ? "[k > m]" : "[k + m <> 2]";
            case 5:
                return named("XG", random_.below(static_cast<std::uint32_t>(graphs_.size())));
            case 6:
            case 7:
                return "X" + any_step();
            case 8:
                return random_.one_in(3) ? "Init" : random_.one_in(2) ? "AUdur" : "AUdoux";
            case 9:
            case 10:
                return "a";
            case 11:
                return "b";
            default:
                return "c";
        }
    }

    Random& random_;
    std::vector<Graph> graphs_;
    std::vector<std::vector<int>> encloses_;  ///< by graph and place of the step: a graph, or -1
};

}  // namespace

std::string random_grafcet(Random& random) {
    return Generator(random).grafcet();
}

}  // namespace grafwire
