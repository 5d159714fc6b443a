#include "plc/awl_machine.h"

#include <array>

#include "plc/awl_program.h"
#include "plc/awl_timers.h"

namespace grafwire::testing {

namespace {

using Bytes = std::array<std::uint8_t, 8192>;

class AwlMachine : public PlcMachine {
  public:
    AwlMachine(const std::string& text, const Grafcet& grafcet, bool international)
        : program_(read_awl(text, international)), grafcet_(grafcet) {
        memory_.fill(0xA5);
        outputs_.fill(0);
        inputs_.fill(0);
        run("OB 100");
    }

    void set_input(std::uint32_t index, bool value) override {
        const AwlOperand& operand = symbol(std::string(input_name(grafcet_, index)), 'E');
        write(operand, value, 0);
    }
    void scan(Time now) override {
        now_ = now;
        run("OB 1");
    }
    bool step(std::uint32_t index) const override {
        return read(symbol("X" + grafcet_.steps[StepId{index}].name, 'M'));
    }
    bool output(std::uint32_t index) const override {
        return read(symbol(grafcet_.outputs[OutputId{index}].name, 'A'));
    }
    bool var(std::uint32_t index) const override {
        return read(symbol(grafcet_.vars[VarId{index}].name, 'M'));
    }
    std::int64_t counter(std::uint32_t index) const override {
        const AwlOperand& operand = program_.symbols.at(grafcet_.counters[CounterId{index}].name);
        const std::uint32_t value = word(operand.number, operand.bytes);
        return operand.bytes == 2 ? static_cast<std::int16_t>(value)
                                  : static_cast<std::int32_t>(value);
    }

  private:
    const AwlOperand& symbol(const std::string& name, char area) const {
        const auto found = program_.symbols.find(name);
        if (found == program_.symbols.end() || found->second.area != area) {
            throw PlcError(0, "no address for " + name);
        }
        return found->second;
    }

    const Bytes& area(char letter) const {
        return letter == 'E' ? inputs_ : letter == 'A' ? outputs_ : memory_;
    }
    bool read(const AwlOperand& operand) const {
        return (area(operand.area).at(operand.number) >> operand.bit & 1) != 0;
    }
    void write(const AwlOperand& operand, bool value, std::size_t line) {
        if (operand.area == 'E' && line != 0) throw PlcError(line, "an input is written");
        Bytes& bytes = operand.area == 'E' ? inputs_ : operand.area == 'A' ? outputs_ : memory_;
        const auto mask = static_cast<std::uint8_t>(1U << operand.bit);
        std::uint8_t& byte = bytes.at(operand.number);
        byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
    }
    /// Big-endian, as in all S7.
    std::uint32_t word(std::uint32_t first, std::uint32_t count) const {
        std::uint32_t value = 0;
        for (std::uint32_t i = 0; i < count; ++i) value = value << 8 | memory_.at(first + i);
        return value;
    }
    void store(std::uint32_t first, std::uint32_t count, std::uint32_t value) {
        for (std::uint32_t i = count; i-- > 0; value >>= 8) {
            memory_.at(first + i) = static_cast<std::uint8_t>(value);
        }
    }

    void run(const std::string& name);
    std::size_t execute(const AwlBlock& block, std::size_t at);
    bool execute_logic(const AwlInstruction& instruction);
    void combine(const std::string& operation, bool value);
    void open(const std::string& operation, std::size_t line);
    void close(std::size_t line);
    bool execute_words(const AwlInstruction& instruction);
    void execute_assignment(const AwlInstruction& instruction);
    void execute_integers(const AwlInstruction& instruction);
    void execute_timer(const AwlInstruction& instruction);
    void execute_call(const AwlInstruction& instruction);

    AwlProgram program_;
    const Grafcet& grafcet_;
    Bytes inputs_{}, outputs_{}, memory_{};
    std::array<AwlS5Timer, 256> timers_{};
    std::map<std::uint32_t, AwlIecTimer> instances_;
    Time now_ = 0;

    // The status word, and what a parenthesis puts aside.
    bool first_check_ = true;  ///< /FC = 0: the next check begins a string of logic
    bool rlo_ = false;
    bool or_ = false;
    struct Nested {
        std::string operation;
        bool rlo = false;
        bool or_flag = false;
        bool first_check = true;
    };
    std::vector<Nested> nested_;
    std::uint32_t accumulator_1_ = 0;
    std::uint32_t accumulator_2_ = 0;
    Time loaded_time_ = 0;
};

void AwlMachine::run(const std::string& name) {
    const auto found = program_.blocks.find(name);
    if (found == program_.blocks.end()) throw PlcError(0, "no block " + name);
    const AwlBlock& block = found->second;
    first_check_ = true;
    or_ = false;
    std::size_t executed = 0;
    for (std::size_t at = 0; at < block.instructions.size(); at = execute(block, at)) {
        if (++executed > 1'000'000) throw PlcError(block.instructions[at].line, "an endless loop");
    }
    if (!nested_.empty()) throw PlcError(0, "a parenthesis that is not closed");
}

/// A check of a value: the first of a string is loaded; after `O` alone the products are joined.
void AwlMachine::combine(const std::string& operation, bool value) {
    const bool checked = operation.back() == 'N' ? !value : value;
    const char kind = operation.front();
    if (kind == 'U') {
        rlo_ = (first_check_ ? checked : rlo_ && checked) || or_;
    } else {
        const bool before = first_check_ ? false : rlo_;
        rlo_ = kind == 'O' ? before || or_ || checked : before != checked;
        or_ = false;
    }
    first_check_ = false;
}

void AwlMachine::open(const std::string& operation, std::size_t line) {
    if (nested_.size() == 7) throw PlcError(line, "more than seven parentheses");
    nested_.push_back({operation.substr(0, operation.size() - 1), rlo_, or_, first_check_});
    first_check_ = true;
    or_ = false;
}

void AwlMachine::close(std::size_t line) {
    if (nested_.empty()) throw PlcError(line, "nothing to close");
    const Nested outer = nested_.back();
    nested_.pop_back();
    const bool value = rlo_;
    rlo_ = outer.rlo;
    or_ = outer.or_flag;
    first_check_ = outer.first_check;
    combine(outer.operation, value);
}

/// Bit logic; whether the instruction was one.
bool AwlMachine::execute_logic(const AwlInstruction& instruction) {
    const std::string& operation = instruction.operation;
    const AwlOperand& operand = instruction.operand;
    if (operation == "SET" || operation == "CLR") {
        rlo_ = operation == "SET";
        first_check_ = true;
        or_ = false;
    } else if (operation == "NOT") {
        rlo_ = !rlo_;
    } else if (operation.back() == '(') {
        open(operation, instruction.line);
    } else if (operation == ")") {
        close(instruction.line);
    } else if (operation == "O" && operand.kind == AwlOperand::Kind::none) {
        or_ = rlo_ || or_;
        first_check_ = true;
    } else if (std::string("UOX").find(operation.front()) != std::string::npos &&
               (operand.kind == AwlOperand::Kind::bit || operand.kind == AwlOperand::Kind::timer)) {
        combine(operation, operand.kind == AwlOperand::Kind::bit
                               ? read(operand)
                               : timers_[operand.number].status(now_));
    } else {
        return false;
    }
    return true;
}

/// `=`, S, R: they end a string of logic and leave the RLO.
void AwlMachine::execute_assignment(const AwlInstruction& instruction) {
    const AwlOperand& operand = instruction.operand;
    if (operand.kind == AwlOperand::Kind::timer) {
        if (rlo_) timers_[operand.number].reset();
    } else if (instruction.operation == "=") {
        write(operand, rlo_, instruction.line);
    } else if (rlo_) {
        write(operand, instruction.operation == "S", instruction.line);
    }
    first_check_ = true;
    or_ = false;
}

void AwlMachine::execute_timer(const AwlInstruction& instruction) {
    timers_[instruction.operand.number].run(instruction.operation == "SA", rlo_, loaded_time_,
                                            now_);
    first_check_ = true;
    or_ = false;
}

void AwlMachine::execute_call(const AwlInstruction& instruction) {
    AwlIecTimer& timer = instances_[instruction.data_block];
    timer.call(instruction.operand.number == 4, read(instruction.in), instruction.operand.value,
               now_);
    write(instruction.out, timer.q, instruction.line);
    first_check_ = true;
    or_ = false;
}

/// Loads, transfers and operations on words; whether the instruction was one.
bool AwlMachine::execute_words(const AwlInstruction& instruction) {
    const std::string& operation = instruction.operation;
    const AwlOperand& operand = instruction.operand;
    if (operation == "L") {
        accumulator_2_ = accumulator_1_;
        if (operand.kind == AwlOperand::Kind::s5_time) {
            loaded_time_ = operand.value;
        } else if (operand.kind == AwlOperand::Kind::word) {
            accumulator_1_ = word(operand.number, operand.bytes);
        } else {
            accumulator_1_ = operand.is_wide ? static_cast<std::uint32_t>(operand.value)
                                             : static_cast<std::uint16_t>(operand.value);
        }
    } else if (operation == "T") {
        store(operand.number, operand.bytes, accumulator_1_);
    } else if (operation == "INVI") {
        accumulator_1_ ^= 0xFFFFU;
    } else if (operation == "INVD") {
        accumulator_1_ = ~accumulator_1_;
    } else if (operation == "UW" || operation == "OW") {
        const std::uint32_t low =
            operation == "UW" ? accumulator_1_ & accumulator_2_ : accumulator_1_ | accumulator_2_;
        accumulator_1_ = (accumulator_1_ & 0xFFFF'0000U) | (low & 0xFFFFU);
    } else if (operation == "UD") {
        accumulator_1_ &= accumulator_2_;
    } else if (operation == "OD") {
        accumulator_1_ |= accumulator_2_;
    } else {
        return false;
    }
    return true;
}

/// Sums and comparisons of accumulator 2 with accumulator 1, of 16 or 32 bits.
void AwlMachine::execute_integers(const AwlInstruction& instruction) {
    const std::string& operation = instruction.operation;
    const bool wide = operation.back() == 'D';
    const auto number = [&](std::uint32_t bits) -> std::int64_t {
        return wide ? static_cast<std::int32_t>(bits) : static_cast<std::int16_t>(bits);
    };
    const std::int64_t left = number(accumulator_2_);
    const std::int64_t right = number(accumulator_1_);
    const std::string sign = operation.substr(0, operation.size() - 1);
    if (sign == "+" || sign == "-") {
        const std::int64_t sum = sign == "+" ? left + right : left - right;
        const std::int64_t limit = wide ? INT32_MAX : INT16_MAX;
        if (sum > limit || sum < -limit - 1) throw PlcError(instruction.line, "an overflow");
        accumulator_1_ = wide ? static_cast<std::uint32_t>(sum)
                              : (accumulator_1_ & 0xFFFF'0000U) | static_cast<std::uint16_t>(sum);
        return;
    }
    rlo_ = sign == "=="   ? left == right
           : sign == "<>" ? left != right
           : sign == "<"  ? left < right
           : sign == "<=" ? left <= right
           : sign == ">"  ? left > right
                          : left >= right;
    first_check_ = false;
    or_ = false;
}

std::size_t AwlMachine::execute(const AwlBlock& block, std::size_t at) {
    const AwlInstruction& instruction = block.instructions[at];
    const std::string& operation = instruction.operation;
    if (operation == "NOP") return at + 1;
    if (operation == "UC") {
        run(instruction.operand.label);
    } else if (operation == "CALL") {
        execute_call(instruction);
    } else if (operation == "SPB" || operation == "SPBN" || operation == "SPA") {
        const bool jumps = operation == "SPA" || rlo_ == (operation == "SPB");
        first_check_ = true;
        or_ = false;
        rlo_ = true;  // S7-300 instruction list: a conditional jump leaves the RLO at 1
        if (jumps) return block.labels.at(instruction.operand.label);
    } else if (operation == "SE" || operation == "SA") {
        execute_timer(instruction);
    } else if (operation == "=" || operation == "S" || operation == "R") {
        execute_assignment(instruction);
    } else if (!execute_logic(instruction) && !execute_words(instruction)) {
        execute_integers(instruction);
    }
    return at + 1;
}

}  // namespace

std::unique_ptr<PlcMachine> awl_machine(const std::string& text, const Grafcet& grafcet) {
    return std::make_unique<AwlMachine>(text, grafcet, false);
}

std::unique_ptr<PlcMachine> awl_machine_international(const std::string& text,
                                                      const Grafcet& grafcet) {
    return std::make_unique<AwlMachine>(text, grafcet, true);
}

}  // namespace grafwire::testing
