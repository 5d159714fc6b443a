#include "random/plain_chart.h"

#include <vector>

namespace grafwire::testing {

namespace {

class PlainWriter {
  public:
    PlainWriter(RandomSource& random, const Features& features)
        : random_(random), features_(features), steps_left_(features.steps) {}

    std::string write() {
        const std::size_t first = add_step();
        const std::size_t last = sequence(first, 2, 0);
        link(std::to_string(last), std::to_string(first), condition());
        std::string text;
        for (std::size_t i = 0; i < inputs(); ++i) text += "input i" + std::to_string(i) + "\n";
        for (std::size_t i = 0; i < features_.outputs; ++i) {
            text += "output o" + std::to_string(i) + "\n";
        }
        text += "graph G {\n";
        for (std::size_t i = 0; i < next_step_; ++i) {
            text += (i == 0 ? "  initial " : "  step ") + std::to_string(i);
            if (features_.outputs != 0 && random_.flip()) {
                text += " : o" + std::to_string(random_.below(features_.outputs));
                if (random_.one_in(3)) text += " if " + input();
            }
            text += "\n";
        }
        for (const std::string& transition : transitions_) text += "  " + transition + "\n";
        return text + "}\n";
    }

  private:
    std::size_t inputs() const { return features_.inputs < 2 ? 2 : features_.inputs; }
    std::string input() { return "i" + std::to_string(random_.below(inputs())); }
    std::string condition() {
        const bool is_negated = random_.one_in(3);
        return (is_negated ? "/" : "") + input();
    }
    std::size_t add_step() {
        if (steps_left_ != 0) --steps_left_;
        return next_step_++;
    }
    void link(const std::string& before, const std::string& after, const std::string& when) {
        transitions_.push_back(before + " -> " + after + " : " + when);
    }
    std::size_t sequence(std::size_t from, std::size_t least, std::size_t depth);
    std::size_t selection(std::size_t from, std::size_t depth);
    std::size_t simultaneous(std::size_t from, std::size_t depth);

    RandomSource& random_;
    const Features& features_;
    std::size_t steps_left_;
    std::size_t next_step_ = 0;
    std::vector<std::string> transitions_;
};

/// Goes on after a step with at least so many parts; the step it ends in.
std::size_t PlainWriter::sequence(std::size_t from, std::size_t least, std::size_t depth) {
    const std::size_t parts = least + random_.below(3);
    for (std::size_t i = 0; i < parts && (i < least || steps_left_ != 0); ++i) {
        const std::size_t choice = depth < 2 && steps_left_ > 3 ? random_.below(4) : 3;
        if (choice == 0) {
            from = selection(from, depth + 1);
        } else if (choice == 1) {
            from = simultaneous(from, depth + 1);
        } else {
            const std::size_t next = add_step();
            link(std::to_string(from), std::to_string(next), condition());
            from = next;
        }
    }
    return from;
}

std::size_t PlainWriter::selection(std::size_t from, std::size_t depth) {
    const std::size_t chosen = random_.below(inputs());
    const std::string chooser = "i" + std::to_string(chosen);
    const std::string other = "i" + std::to_string((chosen + 1) % inputs());
    std::vector<std::size_t> ends;
    for (const char* sign : {"", "/"}) {
        const std::size_t first = add_step();
        const std::string more = random_.flip() ? "." + other : "";
        link(std::to_string(from), std::to_string(first), sign + chooser + more);
        ends.push_back(sequence(first, 0, depth));
    }
    const std::size_t joint = add_step();
    for (const std::size_t end : ends)
        link(std::to_string(end), std::to_string(joint), condition());
    return joint;
}

std::size_t PlainWriter::simultaneous(std::size_t from, std::size_t depth) {
    std::string firsts;
    std::vector<std::size_t> branches;
    for (std::size_t count = random_.between(2, 3); count != 0; --count) {
        branches.push_back(add_step());
        firsts += (firsts.empty() ? "" : ", ") + std::to_string(branches.back());
    }
    link(std::to_string(from), firsts, condition());
    std::string lasts;
    for (const std::size_t branch : branches) {
        const std::size_t end = sequence(branch, 0, depth);
        lasts += (lasts.empty() ? "" : ", ") + std::to_string(end);
    }
    const std::size_t joint = add_step();
    link(lasts, std::to_string(joint), condition());
    return joint;
}

}  // namespace

std::string plain_chart(RandomSource& random, const Features& features) {
    return PlainWriter(random, features).write();
}

}  // namespace grafwire::testing
