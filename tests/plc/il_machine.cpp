// Instruction List: an instruction a line. The current result has the type of what was loaded; an
// open parenthesis puts it aside together with the operator. What matiec is known to refuse or to
// get wrong is refused: arrays, a parenthesis within a parenthesis, a CAL with arguments.

#include "plc/il_machine.h"

#include <map>
#include <optional>
#include <set>

#include "support/iec_block.h"

namespace grafwire::testing {

namespace {

struct Operand {
    enum class Kind { none, literal, boolean, time, variable, field };
    Kind kind = Kind::none;
    std::string name;   ///< of a variable, a timer
    std::string field;  ///< of a timer
    std::int64_t value = 0;
};

struct Instruction {
    std::string operation;  ///< in lower case; "(" belongs to it: `and(`
    Operand operand;
    std::size_t line = 0;
};

class IlMachine : public IecMachine {
  public:
    IlMachine(const std::string& text, const Grafcet& grafcet) : IecMachine(grafcet) {
        IecTokenCursor cursor(iec_tokens(text));
        block_.read_declarations(cursor);
        while (!cursor.accept("end_function_block")) read_line(cursor);
        if (cursor.peek().kind != IecToken::Kind::end) cursor.fail("text after the block");
        for (const Instruction& instruction : instructions_) {
            if (instruction.operation.starts_with("jmp") &&
                labels_.count(instruction.operand.name) == 0) {
                throw PlcError(instruction.line, "no label '" + instruction.operand.name + "'");
            }
        }
    }

    /// The steps are the section after that of vars and counters.
    bool step(std::uint32_t index) const override {
        std::size_t to_skip = grafcet_.vars.size() + grafcet_.counters.size() > 0 ? 1 : 0;
        for (const auto& [kind, names] : block_.sections) {
            if (kind != "var" || to_skip-- > 0) continue;
            return block_.variables.at(names.at(index)).values.front() != 0;
        }
        throw PlcError(0, "no steps");
    }

    void scan(Time now) override {
        now_ = now;
        result_.reset();
        std::size_t executed = 0;
        for (std::size_t at = 0; at < instructions_.size();) {
            if (++executed > 1'000'000) throw PlcError(instructions_[at].line, "an endless loop");
            at = execute(at);
        }
        if (!aside_.empty()) throw PlcError(0, "a parenthesis that is not closed");
    }

  private:
    void read_line(IecTokenCursor& cursor);
    Operand read_operand(IecTokenCursor& cursor, std::size_t line);

    std::size_t execute(std::size_t at);
    void execute_store(const Instruction& instruction);
    IecValue value(const Operand& operand, std::size_t line);
    IecValue result(std::size_t line) const {
        if (!result_) throw PlcError(line, "no current result");
        return *result_;
    }
    bool boolean(IecValue value, std::size_t line) const {
        if (value.type != IecType::boolean) throw PlcError(line, "expected a BOOL");
        return value.value != 0;
    }
    IecValue applied(const std::string& operation, IecValue left, IecValue right,
                     std::size_t line) const;

    std::vector<Instruction> instructions_;
    std::map<std::string, std::size_t> labels_;
    std::optional<IecValue> result_;
    std::vector<std::pair<std::string, IecValue>> aside_;
    std::map<std::string, bool> timer_inputs_;
    std::map<std::string, Time> timer_delays_;
    bool is_open_ = false;  ///< a parenthesis, while the text is read
    Time now_ = 0;
};

const std::set<std::string> with_operand = {
    "ld",  "ldn", "st", "stn", "s",  "r",  "and", "andn", "or",  "orn", "xor",  "xorn", "add",
    "sub", "gt",  "ge", "eq",  "ne", "le", "lt",  "max",  "min", "jmp", "jmpc", "jmpcn"};
const std::set<std::string> with_parenthesis = {"and", "andn", "or", "orn", "xor", "xorn", "add",
                                                "sub", "gt",   "ge", "eq",  "ne",  "le",   "lt"};

void IlMachine::read_line(IecTokenCursor& cursor) {
    Instruction instruction;
    instruction.line = cursor.peek().line;
    const auto ends = [&] { return cursor.peek().line != instruction.line; };
    if (cursor.accept(")")) {
        instruction.operation = ")";
        is_open_ = false;
    } else {
        instruction.operation = cursor.identifier();
        if (!ends() && cursor.accept(":")) {
            if (!labels_.emplace(instruction.operation, instructions_.size()).second) {
                throw PlcError(instruction.line, "a label twice");
            }
            if (block_.variables.count(instruction.operation) != 0) {
                throw PlcError(instruction.line, "a label with the name of a variable");
            }
            return;
        }
        if (instruction.operation == "cal") {
            instruction.operand.name = cursor.identifier();
            block_.timer_output(instruction.operand.name, instruction.line);
        } else if (!ends() && cursor.accept("(")) {
            if (with_parenthesis.count(instruction.operation) == 0)
                cursor.fail("parenthesis after");
            if (is_open_) throw PlcError(instruction.line, "a parenthesis within a parenthesis");
            is_open_ = true;
            instruction.operation += "(";
        } else if (with_operand.count(instruction.operation) != 0) {
            if (ends()) throw PlcError(instruction.line, "an operand is missing");
            instruction.operand = read_operand(cursor, instruction.line);
        } else if (instruction.operation != "not") {
            throw PlcError(instruction.line, "the operator '" + instruction.operation + "'");
        }
    }
    if (!ends()) cursor.fail("more than one instruction in a line");
    instructions_.push_back(instruction);
}

Operand IlMachine::read_operand(IecTokenCursor& cursor, std::size_t line) {
    Operand operand;
    const bool negative = cursor.accept("-");
    if (negative || cursor.peek().kind == IecToken::Kind::integer) {
        operand.kind = Operand::Kind::literal;
        operand.value = negative ? -cursor.integer() : cursor.integer();
        return operand;
    }
    if (cursor.peek().kind == IecToken::Kind::time) {
        operand.kind = Operand::Kind::time;
        operand.value = cursor.take().value;
        return operand;
    }
    operand.name = cursor.identifier();
    operand.kind = Operand::Kind::variable;
    if (operand.name == "true" || operand.name == "false") {
        operand.kind = Operand::Kind::boolean;
        operand.value = operand.name == "true" ? 1 : 0;
    } else if (cursor.peek().line == line && cursor.accept(".")) {
        operand.kind = Operand::Kind::field;
        operand.field = cursor.identifier();
    }
    return operand;
}

IecValue IlMachine::value(const Operand& operand, std::size_t line) {
    switch (operand.kind) {
        case Operand::Kind::literal:
            return {IecType::literal, operand.value};
        case Operand::Kind::boolean:
            return {IecType::boolean, operand.value};
        case Operand::Kind::variable:
            return block_.load(operand.name, nullptr, line);
        case Operand::Kind::time:
            return {IecType::time, operand.value};
        case Operand::Kind::field:
            if (operand.field != "q") throw PlcError(line, "only Q is read");
            return {IecType::boolean, block_.timer_output(operand.name, line) ? 1 : 0};
        case Operand::Kind::none:
            break;
    }
    throw PlcError(line, "an operand is missing");
}

IecValue IlMachine::applied(const std::string& operation, IecValue left, IecValue right,
                            std::size_t line) const {
    if (operation == "add") return add_integers(left, right, false, line);
    if (operation == "sub") return add_integers(left, right, true, line);
    if (operation == "max")
        return compare_values(left, right, line) >= 0 ? left : IecValue{left.type, right.value};
    if (operation == "min")
        return compare_values(left, right, line) <= 0 ? left : IecValue{left.type, right.value};
    static const std::map<std::string, bool (*)(int)> relations = {
        {"eq", [](int order) { return order == 0; }}, {"ne", [](int order) { return order != 0; }},
        {"lt", [](int order) { return order < 0; }},  {"le", [](int order) { return order <= 0; }},
        {"gt", [](int order) { return order > 0; }},  {"ge", [](int order) { return order >= 0; }}};
    if (const auto found = relations.find(operation); found != relations.end()) {
        return {IecType::boolean, found->second(compare_values(left, right, line)) ? 1 : 0};
    }
    const bool a = boolean(left, line);
    bool b = boolean(right, line);
    std::string plain = operation;
    if (plain.back() == 'n') {
        plain.pop_back();
        b = !b;
    }
    const bool answer = plain == "and" ? a && b : plain == "or" ? a || b : a != b;
    return {IecType::boolean, answer ? 1 : 0};
}

/// ST, STN, S, R.
void IlMachine::execute_store(const Instruction& instruction) {
    const std::size_t line = instruction.line;
    const Operand& operand = instruction.operand;
    IecValue stored = result(line);
    if (instruction.operation != "st") {
        const bool holds = boolean(stored, line);
        if (instruction.operation != "stn" && !holds) return;
        stored.value = instruction.operation == "stn" ? !holds : instruction.operation == "s";
    }
    if (operand.kind == Operand::Kind::field) {
        block_.timer_output(operand.name, line);
        if (operand.field == "in") {
            timer_inputs_[operand.name] = boolean(stored, line);
            return;
        }
        if (operand.field != "pt") throw PlcError(line, "only IN and PT are written");
        if (stored.type != IecType::time) throw PlcError(line, "expected a TIME");
        timer_delays_[operand.name] = stored.value;
        return;
    }
    if (operand.kind != Operand::Kind::variable) throw PlcError(line, "a constant is written");
    block_.store(operand.name, nullptr, stored, line);
}

std::size_t IlMachine::execute(std::size_t at) {
    const Instruction& instruction = instructions_[at];
    const std::string& operation = instruction.operation;
    const std::size_t line = instruction.line;
    if (operation == "ld" || operation == "ldn") {
        result_ = value(instruction.operand, line);
        if (operation == "ldn") result_->value = boolean(*result_, line) ? 0 : 1;
    } else if (operation == "st" || operation == "stn" || operation == "s" || operation == "r") {
        execute_store(instruction);
    } else if (operation == "not") {
        result_ = IecValue{IecType::boolean, boolean(result(line), line) ? 0 : 1};
    } else if (operation == "jmp") {
        return labels_.at(instruction.operand.name);
    } else if (operation == "jmpc" || operation == "jmpcn") {
        if (boolean(result(line), line) == (operation == "jmpc")) {
            return labels_.at(instruction.operand.name);
        }
    } else if (operation == "cal") {
        block_.call_timer(instruction.operand.name, timer_inputs_[instruction.operand.name],
                          timer_delays_[instruction.operand.name], now_, line);
    } else if (operation.back() == '(') {
        aside_.emplace_back(operation.substr(0, operation.size() - 1), result(line));
        result_.reset();
    } else if (operation == ")") {
        if (aside_.empty()) throw PlcError(line, "nothing to close");
        result_ = applied(aside_.back().first, aside_.back().second, result(line), line);
        aside_.pop_back();
    } else {
        result_ = applied(operation, result(line), value(instruction.operand, line), line);
    }
    return at + 1;
}

}  // namespace

std::unique_ptr<PlcMachine> il_machine(const std::string& text, const Grafcet& grafcet) {
    return std::make_unique<IlMachine>(text, grafcet);
}

}  // namespace grafwire::testing
