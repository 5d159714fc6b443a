#include "charts.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <vector>

namespace bench {

namespace {

/// The structures nested in each other, written without recursion: a block still to be written lies
/// between a first and a last step that exist already or stand for one step.
class TreeWriter {
  public:
    explicit TreeWriter(std::size_t steps) : steps_(steps) {}

    std::string write() {
        fmt::format_to(
            std::back_inserter(text_),
            "grafcet tree\ninput a, b, c, d\noutput p, q\n\ngraph G {{\n  initial 0 : p\n");
        const std::size_t last = write_blocks();
        add_transition(fmt::format("{}", last), "0");
        text_ += transitions_;
        text_ += "}\n";
        return std::move(text_);
    }

  private:
    static constexpr std::size_t branches = 4;
    static constexpr std::size_t sequence = 6;

    struct Block {
        std::size_t first;
        std::size_t last;
        std::size_t inner;  ///< steps to be written between the two
        bool parallel;
    };

    /// Returns the last step of the outermost block.
    std::size_t write_blocks() {
        const std::size_t last = add_step();
        std::vector<Block> open{{0, last, steps_ - 2, false}};
        while (!open.empty()) {
            const Block block = open.back();
            open.pop_back();
            if (block.inner < branches * (sequence + 2)) {
                write_sequence(block);
            } else {
                write_branches(block, open);
            }
        }
        return last;
    }

    void write_sequence(const Block& block) {
        std::size_t from = block.first;
        for (std::size_t i = 0; i < block.inner; ++i) {
            const std::size_t to = add_step();
            add_transition(fmt::format("{}", from), fmt::format("{}", to));
            from = to;
        }
        add_transition(fmt::format("{}", from), fmt::format("{}", block.last));
    }

    void write_branches(const Block& block, std::vector<Block>& open) {
        std::string firsts;
        std::string lasts;
        for (std::size_t i = 0; i < branches; ++i) {
            const std::size_t share = (block.inner + i) / branches;
            const Block branch{add_step(), add_step(), share - 2, !block.parallel};
            if (block.parallel) {
                fmt::format_to(std::back_inserter(firsts), "{}{}", i == 0 ? "" : ", ",
                               branch.first);
                fmt::format_to(std::back_inserter(lasts), "{}{}", i == 0 ? "" : ", ", branch.last);
            } else {
                add_transition(fmt::format("{}", block.first), fmt::format("{}", branch.first));
                add_transition(fmt::format("{}", branch.last), fmt::format("{}", block.last));
            }
            open.push_back(branch);
        }
        if (block.parallel) {
            add_transition(fmt::format("{}", block.first), firsts);
            add_transition(lasts, fmt::format("{}", block.last));
        }
    }

    std::size_t add_step() {
        const std::size_t step = ++written_;
        fmt::format_to(std::back_inserter(text_), "  step {}{}\n", step,
                       step % 100 == 0 ? " : q if a" : "");
        return step;
    }

    void add_transition(const std::string& from, const std::string& to) {
        static constexpr std::array<const char*, 4> receptivities{"a . /b", "b + c", "d", "c . d"};
        fmt::format_to(std::back_inserter(transitions_), "  {} -> {} : {}\n", from, to,
                       receptivities[transition_count_++ % receptivities.size()]);
    }

    std::size_t steps_;
    std::size_t written_ = 0;
    std::size_t transition_count_ = 0;
    std::string text_;
    std::string transitions_;
};

}  // namespace

std::string ring_chart(std::size_t steps) {
    std::string text = "grafcet ring\ninput a, b\n\ngraph G {\n";
    for (std::size_t i = 0; i < steps; ++i) {
        fmt::format_to(std::back_inserter(text), "  {} {}\n", i % 8 == 0 ? "initial" : "step", i);
    }
    for (std::size_t i = 0; i < steps; ++i) {
        fmt::format_to(std::back_inserter(text), "  {} -> {} : {}\n", i, (i + 1) % steps,
                       i % 2 == 0 ? 'a' : 'b');
    }
    text += "}\n";
    return text;
}

std::string tree_chart(std::size_t steps) {
    return TreeWriter(steps).write();
}

std::string nine_steps_chart(std::size_t sequences) {
    std::string inputs = "m, a, b, c, d1, d2, e, f";
    std::string steps = "  initial 1\n  step 2\n  step 3 : A\n";
    for (const int step : {4, 5, 6, 7, 8, 9}) steps += fmt::format("  step {}\n", step);
    std::string transitions =
        "  2 -> 3 : b\n  3 -> 4 : c\n  5 -> 6 : a\n  6 -> 7 : d1\n  7 -> 8 : e\n  6 -> 9 : d2\n"
        "  9 -> 8 : f\n";
    std::string first = "2, 5";
    std::string last = "4, 8";
    for (std::size_t more = 2; more < sequences; ++more) {
        inputs += fmt::format(", b{0}, c{0}", more);
        for (const int step : {2, 3, 4}) steps += fmt::format("  step {}{}\n", more * 10, step);
        transitions +=
            fmt::format("  {0}2 -> {0}3 : b{1}\n  {0}3 -> {0}4 : c{1}\n", more * 10, more);
        first += fmt::format(", {}2", more * 10);
        last += fmt::format(", {}4", more * 10);
    }
    return fmt::format(
        "input {}\noutput A\nassume /(d1 . d2)\ngraph G1 {{\n{}  1 -> {} : m\n{}  {} -> 1 : "
        "=1\n}}\n",
        inputs, steps, first, transitions, last);
}

}  // namespace bench
