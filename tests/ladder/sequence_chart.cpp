#include "ladder/sequence_chart.h"

#include <algorithm>
#include <vector>

namespace grafwire::testing {

namespace {

class SequenceWriter {
  public:
    explicit SequenceWriter(RandomSource& random) : random_(random) {
        for (int g = 0; g < 2; ++g) lengths_.push_back(random.between(3, 5));
    }

    std::string write() {
        std::string text = "input i0, i1, i2\n";
        for (const char* g : {"0", "1"}) {
            for (const char* stem : {"plain", "late", "brief", "when", "s"}) {
                text += std::string("output ") + stem + g + "\n";
            }
            text += std::string("var v") + g + "\ncounter c" + g + " : 0..4\n";
        }
        for (std::size_t g = 0; g < lengths_.size(); ++g) text += graph(g);
        return text;
    }

  private:
    std::string graph(std::size_t g);
    std::string actions(std::size_t g, std::size_t step);
    std::string condition(std::size_t g, std::size_t step);
    std::string input() { return "i" + std::to_string(random_.below(3)); }
    static std::string name(std::size_t g, std::size_t step) {
        return std::to_string(10 * (g + 1) + step);
    }
    /// The variable of any step.
    std::string any_x() {
        const std::size_t g = random_.below(lengths_.size());
        return "X" + name(g, random_.below(lengths_[g]));
    }
    std::string bit(std::size_t g);
    std::string duration() { return std::to_string(random_.between(1, 4)) + "ms"; }

    RandomSource& random_;
    std::vector<std::size_t> lengths_;  ///< of the graphs, in steps
};

/// Something that a step or the plant says.
std::string SequenceWriter::bit(std::size_t g) {
    const std::string other = std::to_string(random_.one_in(3) ? g : 1 - g);
    switch (random_.below(8)) {
        case 0:
            return any_x();
        case 1:
            return "v" + other;
        case 2:
            return "s" + other;
        case 3:
            return "[c" + other + " >= " + std::to_string(random_.below(4)) + "]";
        case 4:
            return "XG" + other;
        case 5:
            return "/" + input();
        default:
            return input();
    }
}

std::string SequenceWriter::condition(std::size_t g, std::size_t step) {
    switch (random_.below(8)) {
        case 0:
            return duration() + "/X" + name(g, step);
        case 1:
            return duration() + "/(" + bit(g) + " + " + input() + ")/" + duration();
        case 2:
            return "↑(" + bit(g) + " . " + bit(g) + ")";
        case 3:
            return "↓(" + bit(g) + " + ↑" + input() + ")";
        case 4:
            return "↑(" + duration() + "/" + any_x() + ") + " + input();
        case 5:
            return "↑" + bit(g) + " + " + input() + " . " + bit(g);
        default:
            return input();
    }
}

std::string SequenceWriter::actions(std::size_t g, std::size_t step) {
    const std::string own = std::to_string(g);
    const std::string x = "X" + name(g, step);
    std::vector<std::string> list{"plain" + own, "late" + own + " if " + duration() + "/" + x,
                                  "brief" + own + " if /(" + duration() + "/" + x + ")",
                                  "when" + own + " if " + bit(g)};
    list = random_.pick_some(list, random_.below(4));
    if (step == 1) list.push_back("set s" + own);
    if (step == 2 || (step == 0 && random_.one_in(4))) list.push_back("reset s" + own);
    const std::string c = "c" + own;
    const std::vector<std::string> writes{c + " := " + c + " + 1", c + " := 0",
                                          c + " := c" + std::to_string(1 - g) + " - 1"};
    const std::string write = random_.pick(writes);
    switch (random_.below(4)) {
        case 0:
            list.push_back(write);
            break;
        case 1:
            list.push_back(write + " on ↑" + bit(g) + " . " + bit(g));
            break;
        default:
            break;
    }
    if (random_.one_in(3)) {
        list.push_back("v" + own + " := " + bit(g) + " ⊕ ↑" + bit(g) + " on deactivation");
    }
    std::string text;
    for (const std::string& action : list) text += (text.empty() ? " : " : ", ") + action;
    return text;
}

std::string SequenceWriter::graph(std::size_t g) {
    std::string text = "graph G" + std::to_string(g) + " {\n";
    const std::size_t length = lengths_[g];
    for (std::size_t s = 0; s < length; ++s) {
        text += (s == 0 ? "  initial " : "  step ") + name(g, s) + actions(g, s) + "\n";
    }
    for (std::size_t s = 0; s < length; ++s) {
        const std::string from = "  " + name(g, s) + " -> ";
        const std::string next = name(g, (s + 1) % length);
        if (!random_.one_in(3)) {
            text += from + next + " : " + condition(g, s) + "\n";
            continue;
        }
        const std::string chooser = input();
        const std::string other = name(g, random_.below(length));
        text += from + next + " : " + chooser + " . (" + condition(g, s) + ")\n";
        text += from + other + " : /" + chooser + " . (" + condition(g, s) + ")\n";
    }
    return text + "}\n";
}

}  // namespace

std::string sequence_chart(RandomSource& random) {
    return SequenceWriter(random).write();
}

}  // namespace grafwire::testing
