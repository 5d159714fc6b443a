#include "plc/awl_program.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace grafwire::testing {

namespace {

const std::map<std::string, std::string> simatic_of = {
    {"A", "U"},      {"AN", "UN"},  {"A(", "U("},  {"AN(", "UN("}, {"AW", "UW"}, {"AD", "UD"},
    {"JCN", "SPBN"}, {"JC", "SPB"}, {"JU", "SPA"}, {"SD", "SE"},   {"SF", "SA"}};

const std::set<std::string> bit_operations = {"U", "UN", "O", "ON", "X", "XN", "=", "S", "R"};
const std::set<std::string> plain_operations = {
    "U(",   "UN(",  "O(",  "ON(", "X(",  "XN(", ")",   "O",  "NOT", "SET", "CLR",
    "INVI", "INVD", "UW",  "UD",  "OW",  "OD",  "+I",  "-I", "+D",  "-D",  "==I",
    "<>I",  "<I",   "<=I", ">I",  ">=I", "==D", "<>D", "<D", "<=D", ">D",  ">=D"};

const std::regex label_form("[A-Za-z_][A-Za-z0-9_]{0,3}");
const std::regex call_form("CALL  SFB ([45]), DB (\\d+) \\(");

class AwlReader {
  public:
    AwlReader(const std::string& text, bool international) : international_(international) {
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) lines_.push_back(line);
    }

    AwlProgram read() {
        for (; at_ < lines_.size(); ++at_) {
            const std::string& line = lines_[at_];
            if (line.rfind("//   ", 0) == 0) {
                read_symbol(line.substr(5));
            } else if (line.rfind("DATA_BLOCK DB ", 0) == 0) {
                read_data_block(line);
            } else if (std::regex_match(line, std::regex("FUNCTION FC \\d+ : VOID"))) {
                read_block(line.substr(9, line.find(" :") - 9), "END_FUNCTION");
            } else if (std::regex_match(line, std::regex("ORGANIZATION_BLOCK OB \\d+"))) {
                read_block(line.substr(19), "END_ORGANIZATION_BLOCK");
            } else if (!line.empty() && line.rfind("//", 0) != 0) {
                fail("text outside of a block");
            }
        }
        return std::move(program_);
    }

  private:
    [[noreturn]] void fail(const std::string& message) const {
        throw PlcError(at_ + 1, message + ": " + (at_ < lines_.size() ? lines_[at_] : "the end"));
    }
    const std::string& next() {
        if (++at_ >= lines_.size()) fail("the text ends within a block");
        return lines_[at_];
    }

    void read_symbol(const std::string& text) {
        program_.symbols.emplace(text.substr(11), operand(trimmed(text.substr(0, 10))));
    }

    void read_data_block(const std::string& line) {
        const auto number = static_cast<std::uint32_t>(std::stoul(line.substr(14)));
        const std::string& type = next();
        if (type != "SFB 4" && type != "SFB 5") fail("an instance of what");
        program_.instances[number] = type == "SFB 4" ? 4 : 5;
        if (next() != "BEGIN" || next() != "END_DATA_BLOCK") fail("a data block with contents");
    }

    void read_block(const std::string& name, const std::string& end) {
        while (next() != "BEGIN") {
        }
        AwlBlock block;
        while (next() != end) {
            const std::string line = trimmed(lines_[at_].substr(0, comment_at(lines_[at_])));
            if (line.empty() || line == "NETWORK") continue;
            if (line.rfind("TITLE = ", 0) == 0) {
                if (line.size() > 8 + 64) fail("a title of more than 64 characters");
                continue;
            }
            read_instruction(line, block);
        }
        for (const AwlInstruction& instruction : block.instructions) {
            if (instruction.operand.kind == AwlOperand::Kind::label &&
                block.labels.count(instruction.operand.label) == 0) {
                throw PlcError(instruction.line, "no label " + instruction.operand.label);
            }
        }
        program_.blocks.emplace(name, std::move(block));
    }

    static std::size_t comment_at(const std::string& line) {
        return std::min(line.find("//"), line.size());
    }
    static std::string trimmed(const std::string& text) {
        const std::size_t first = text.find_first_not_of(' ');
        if (first == std::string::npos) return "";
        return text.substr(first, text.find_last_not_of(' ') - first + 1);
    }

    void read_instruction(std::string line, AwlBlock& block) {
        AwlInstruction instruction;
        instruction.line = at_ + 1;
        if (const std::size_t colon = line.find(": "); colon != std::string::npos && colon <= 4) {
            const std::string label = line.substr(0, colon);
            if (!std::regex_match(label, label_form)) fail("a label");
            if (!block.labels.emplace(label, block.instructions.size()).second) fail("label twice");
            line = trimmed(line.substr(colon + 1));
        }
        if (line.rfind("CALL ", 0) == 0) return read_call(line, instruction, block);
        if (line.empty() || line.back() != ';') fail("no semicolon");
        line = trimmed(line.substr(0, line.size() - 1));
        const std::size_t blank = std::min(line.find(' '), line.size());
        instruction.operation = simatic(line.substr(0, blank));
        const std::string rest = trimmed(line.substr(blank));
        if (!rest.empty()) instruction.operand = operand(rest);
        check(instruction);
        block.instructions.push_back(instruction);
    }

    std::string simatic(const std::string& written) const {
        if (!international_) return written;
        const auto found = simatic_of.find(written);
        if (found != simatic_of.end()) return found->second;
        for (const auto& [other, own] : simatic_of) {
            if (own == written) fail("a SIMATIC mnemonic");
        }
        return written;
    }

    void check(const AwlInstruction& instruction) {
        using Kind = AwlOperand::Kind;
        const std::string& operation = instruction.operation;
        const Kind kind = instruction.operand.kind;
        bool good = false;
        if (kind == Kind::none) good = plain_operations.count(operation) != 0;
        if (kind == Kind::bit) good = bit_operations.count(operation) != 0;
        if (kind == Kind::timer) {
            good = operation == "SE" || operation == "SA" || operation == "R" || operation == "U";
        }
        if (kind == Kind::word) good = operation == "L" || operation == "T";
        if (kind == Kind::constant) {
            good = operation == "L" || (operation == "NOP" && instruction.operand.value == 0);
        }
        if (kind == Kind::s5_time) good = operation == "L";
        if (kind == Kind::label)
            good = operation == "SPB" || operation == "SPBN" || operation == "SPA";
        if (kind == Kind::block) good = operation == "UC";
        if (!good) fail("no such instruction");
        if (kind == Kind::block && program_.blocks.count(instruction.operand.label) == 0) {
            fail("a block that comes later");
        }
    }

    /// CALL SFB 4, DB 1 ( IN := bit, PT := T#…, Q := bit);
    void read_call(const std::string& line, AwlInstruction& instruction, AwlBlock& block) {
        std::smatch head;
        if (!std::regex_match(line, head, call_form)) fail("a call");
        instruction.operation = "CALL";
        instruction.operand.number = static_cast<std::uint32_t>(std::stoul(head[1]));
        instruction.data_block = static_cast<std::uint32_t>(std::stoul(head[2]));
        const auto instance = program_.instances.find(instruction.data_block);
        if (instance == program_.instances.end() ||
            instance->second != instruction.operand.number) {
            fail("a data block of another type");
        }
        const auto parameter = [&](const char* name, char end) {
            const std::string written = trimmed(next());
            const std::string begin = std::string(name) + ":= ";
            if (written.rfind(begin, 0) != 0 || written.back() != end) fail("a parameter");
            return written.substr(begin.size(), written.find_first_of(",)") - begin.size());
        };
        instruction.in = operand(parameter("IN ", ','));
        instruction.operand.value = duration(parameter("PT ", ','), "T#");
        instruction.out = operand(parameter("Q  ", ';'));
        if (instruction.operand.value > INT32_MAX * millisecond) fail("a time beyond 24 days");
        block.instructions.push_back(instruction);
    }

    /// `2H46M30S`, whole milliseconds.
    Time duration(const std::string& text, const std::string& prefix) {
        static const std::regex form("(?:(\\d+)H)?(?:(\\d+)M)?(?:(\\d+)S)?(?:(\\d+)MS)?");
        std::smatch parts;
        const std::string digits = text.substr(std::min(prefix.size(), text.size()));
        if (text.rfind(prefix, 0) != 0 || digits.empty() ||
            !std::regex_match(digits, parts, form)) {
            fail("a time");
        }
        const Time lengths[] = {hour, minute, second, millisecond};
        Time total = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (parts[i + 1].matched) total += std::stoll(parts[i + 1]) * lengths[i];
        }
        return total;
    }

    AwlOperand operand(const std::string& text) {
        AwlOperand result;
        std::smatch parts;
        const auto number = [&](std::size_t part) {
            return static_cast<std::uint32_t>(std::stoul(parts[part]));
        };
        static const std::regex simatic_bit("([EAM]) (\\d+)\\.([0-7])");
        static const std::regex international_bit("([IQM]) (\\d+)\\.([0-7])");
        static const std::regex memory_word("M([BWD]) (\\d+)");
        static const std::regex timer("T (\\d+)");
        static const std::regex constant("(L#)?(-?\\d+)");
        static const std::regex function("FC \\d+");
        if (std::regex_match(text, parts, international_ ? international_bit : simatic_bit)) {
            const char area = parts[1].str()[0];
            result.kind = AwlOperand::Kind::bit;
            result.area = area == 'I' ? 'E' : area == 'Q' ? 'A' : area;
            result.number = number(2);
            result.bit = number(3);
        } else if (std::regex_match(text, parts, memory_word)) {
            result.kind = AwlOperand::Kind::word;
            result.number = number(2);
            result.bytes = parts[1] == "B" ? 1 : parts[1] == "W" ? 2 : 4;
        } else if (std::regex_match(text, parts, timer)) {
            result.kind = AwlOperand::Kind::timer;
            result.number = number(1);
            if (result.number > 255) fail("a timer beyond T 255");
        } else if (std::regex_match(text, parts, constant)) {
            result.kind = AwlOperand::Kind::constant;
            result.is_wide = parts[1].matched;
            result.value = std::stoll(parts[2]);
            const std::int64_t limit = result.is_wide ? INT32_MAX : INT16_MAX;
            if (result.value > limit || result.value < -limit - 1) fail("a constant too large");
        } else if (text.rfind("S5T#", 0) == 0) {
            result.kind = AwlOperand::Kind::s5_time;
            result.value = duration(text, "S5T#");
            check_s5_time(result.value);
        } else if (std::regex_match(text, function)) {
            result.kind = AwlOperand::Kind::block;
            result.label = text;
        } else if (std::regex_match(text, label_form)) {
            result.kind = AwlOperand::Kind::label;
            result.label = text;
        } else {
            fail("an operand");
        }
        return result;
    }

    /// Three decimal digits in steps of 10 ms, 100 ms, 1 s or 10 s.
    void check_s5_time(Time time) {
        for (Time step = 10 * millisecond; step <= 10 * second; step *= 10) {
            if (time > 0 && time % step == 0 && time / step <= 999) return;
        }
        fail("an S5 timer would round it");
    }

    bool international_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    AwlProgram program_;
};

}  // namespace

AwlProgram read_awl(const std::string& text, bool international) {
    return AwlReader(text, international).read();
}

}  // namespace grafwire::testing
