#include "random/random_expression.h"

namespace grafwire::testing {

namespace {

const std::vector<std::string> and_signs{".", " . ", "*", " & ", " and "};
const std::vector<std::string> or_signs{" + ", "+", " | ", " or "};
const std::vector<std::string> xor_signs{" ⊕ ", " xor "};
const std::vector<std::string> not_signs{"/", "!", "not "};
const std::vector<std::string> durations{"0s", "1ms", "2ms", "3ms", "5ms", "0.01s", "1500us"};
const std::vector<std::string> relations{"=", "<>", "<", "<=", ">", ">="};

}  // namespace

std::string ExpressionWriter::duration() {
    return random_.pick(durations);
}

std::string ExpressionWriter::negated(const std::string& operand) {
    return random_.pick(not_signs) + operand;
}

std::string ExpressionWriter::joined(const std::string& a, const std::string& b) {
    switch (random_.below(5)) {
        case 0:
            return a + random_.pick(xor_signs) + b;
        case 1:
        case 2:
            return a + random_.pick(or_signs) + b;
        default:
            return both(a, b);
    }
}

std::string ExpressionWriter::both(const std::string& a, const std::string& b) {
    return a + random_.pick(and_signs) + b;
}

std::string ExpressionWriter::edge(const std::string& operand) {
    --edges_left_;
    switch (random_.below(4)) {
        case 0:
            return "rise(" + operand + ")";
        case 1:
            return "fall(" + operand + ")";
        case 2:
            return "↓(" + operand + ")";
        default:
            return "↑(" + operand + ")";
    }
}

std::string ExpressionWriter::time_condition(std::size_t depth) {
    --times_left_;
    // The operand of a delay may hold edges wherever it stands.
    const std::string operand = expression(depth, true, features_.nested_times);
    std::string text = duration() + "/(" + operand + ")";
    if (features_.off_delays && random_.one_in(3)) text += "/" + duration();
    return text;
}

std::string ExpressionWriter::expression(std::size_t depth, bool edges, bool times) {
    if (depth == 0 || random_.one_in(4)) return leaf();
    switch (random_.below(8)) {
        case 0:
            return negated("(" + expression(depth - 1, edges, times) + ")");
        case 1:
            if (times && times_left_ != 0) return time_condition(depth - 1);
            return negated(leaf());
        case 2:
        case 3:
            if (edges && edges_left_ != 0) return edge(expression(depth - 1, edges, times));
            [[fallthrough]];
        case 4: {
            // Without parentheses: the parser has to know the precedences.
            const std::string first = leaf();
            const std::string second = negated(leaf());
            return joined(first, joined(second, leaf()));
        }
        default: {
            const std::string first = expression(depth - 1, edges, times);
            return "(" + joined(first, expression(depth - 1, edges, times)) + ")";
        }
    }
}

std::string ExpressionWriter::leaf() {
    static const std::vector<std::string> controls{"Init", "AUdur", "AUdoux"};
    switch (random_.below(12)) {
        case 0:
            return random_.one_in(4) ? "0" : "1";
        case 1:
            if (!names_.vars.empty() && features_.stored) return random_.pick(names_.vars);
            break;
        case 2:
            if (!names_.stored_outputs.empty()) return random_.pick(names_.stored_outputs);
            break;
        case 3:
            if (!names_.counters.empty()) return comparison();
            break;
        case 4:
            if (features_.reads_controls && random_.one_in(3)) return random_.pick(controls);
            break;
        case 5:
        case 6:
            return random_.pick(names_.x_variables);
        default:
            break;
    }
    return random_.pick(names_.inputs);
}

std::string ExpressionWriter::sum_term() {
    if (random_.one_in(3)) return std::to_string(random_.below(5));
    return random_.pick(names_.counters);
}

std::string ExpressionWriter::sum() {
    std::string text = random_.one_in(5) ? "-" : "";
    text += sum_term();
    for (std::size_t more = random_.below(3); more != 0; --more) {
        text += random_.one_in(3) ? " - " : " + ";
        text += sum_term();
    }
    return text;
}

std::string ExpressionWriter::comparison() {
    std::string text = "[" + sum();
    text += " " + random_.pick(relations) + " ";
    return text + sum() + "]";
}

std::string ExpressionWriter::plant_expression(std::size_t depth) {
    static const std::vector<std::string> controls{"Init", "AUdur", "AUdoux"};
    if (depth == 0) {
        return random_.one_in(6) ? random_.pick(controls) : random_.pick(names_.inputs);
    }
    const std::string a = plant_expression(depth - 1);
    if (random_.one_in(3)) return negated("(" + a + ")");
    return "(" + joined(a, plant_expression(depth - 1)) + ")";
}

std::string ExpressionWriter::receptivity() {
    const std::string input = random_.pick(names_.inputs);
    switch (random_.below(12)) {
        case 0:
            return random_.one_in(4) ? "1" : "0 + " + input;
        case 1:
        case 2:
            return edges_left_ != 0 ? edge(input) : input;
        case 3:
        case 4:
            return negated(input);
        case 5:
        case 6:
            return both(input, "(" + expression() + ")");
        case 7:
            return times_left_ != 0 ? time_condition(1) : input;
        case 8:
        case 9:
            return expression();
        default:
            return input;
    }
}

std::string ExpressionWriter::write() {
    std::vector<std::string> targets = names_.stored_outputs;
    targets.insert(targets.end(), names_.vars.begin(), names_.vars.end());
    if (!names_.counters.empty() && (targets.empty() || random_.one_in(3))) {
        const std::string& counter = random_.pick(names_.counters);
        return counter + " := " + sum();
    }
    return write(random_.pick(targets));
}

std::string ExpressionWriter::write(const std::string& target) {
    switch (random_.below(4)) {
        case 0:
            return "reset " + target;
        case 1:
            return target + " := " + expression();
        default:
            return "set " + target;
    }
}

std::string expression_of(RandomSource& random, const std::vector<std::string>& atoms,
                          std::size_t depth) {
    const std::size_t choice = depth == 0 ? 0 : random.below(6);
    if (choice == 0) return random.pick(atoms);
    if (choice == 1) return "/(" + expression_of(random, atoms, depth - 1) + ")";
    const char* const sign = choice == 2 ? " ⊕ " : choice == 3 ? "." : " + ";
    std::string text = "(" + expression_of(random, atoms, depth - 1);
    for (std::size_t count = random.between(1, 3); count != 0; --count) {
        text += sign + expression_of(random, atoms, depth - 1);
    }
    return text + ")";
}

}  // namespace grafwire::testing
