#include "plc/pl7_machine.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace grafwire::testing {

namespace {

struct Rung {
    std::string contacts;
    std::string coil;
    std::size_t line = 0;
};

struct Transition {
    std::vector<std::string> before;
    std::vector<std::string> after;
    Rung rung;
};

struct Timer {
    bool runs = false;
    Time since = 0;
};

class Pl7Machine : public PlcMachine {
  public:
    Pl7Machine(const std::string& text, const Grafcet& grafcet) : grafcet_(grafcet) {
        read(text);
        for (const std::string& step : initial_) bits_[step] = true;
    }

    void set_input(std::uint32_t index, bool value) override {
        bits_[symbol(std::string(input_name(grafcet_, index)), 'I')] = value;
    }
    void scan(Time now) override {
        now_ = now;
        bits_["SY0"] = is_first_scan_;
        is_first_scan_ = false;
        for (const Rung& rung : preliminary_) execute(rung);
        evolve();
        for (const Rung& rung : posterior_) execute(rung);
    }
    bool step(std::uint32_t index) const override {
        return bit(symbol("X" + grafcet_.steps[StepId{index}].name, 'X'));
    }
    bool output(std::uint32_t index) const override {
        return bit(symbol(grafcet_.outputs[OutputId{index}].name, 'O'));
    }
    bool var(std::uint32_t index) const override {
        return bit(symbol(grafcet_.vars[VarId{index}].name, 'B'));
    }
    std::int64_t counter(std::uint32_t index) const override {
        const auto found = words_.find(symbol(grafcet_.counters[CounterId{index}].name, 'W'));
        return found == words_.end() ? 0 : found->second;
    }

  private:
    void read(const std::string& text);
    void read_head_line(const std::string& line);
    void read_transition(const std::string& line);
    Rung read_rung(const std::string& line) const;
    const std::string& symbol(const std::string& name, char letter) const;

    bool bit(const std::string& object) const {
        const auto found = bits_.find(object);
        return found != bits_.end() && found->second;
    }
    void evolve();
    void execute(const Rung& rung);
    void operate(const std::string& block);
    void run_timer(const std::smatch& parts, bool drives);

    // Contacts, by recursive descent over the text of a rung.
    bool contacts(const Rung& rung);
    bool parallel();
    bool series();
    bool contact();
    bool compare(const std::string& block);
    std::int64_t value(const std::string& operand) const;
    bool accept(std::string_view text) {
        if (rung_->contacts.compare(at_, text.size(), text) != 0) return false;
        at_ += text.size();
        return true;
    }
    [[noreturn]] void fail(const std::string& message) const { throw PlcError(line_, message); }

    const Grafcet& grafcet_;
    std::map<std::pair<std::string, char>, std::string> symbols_;
    std::vector<Rung> preliminary_, posterior_;
    std::vector<Transition> transitions_;
    std::set<std::string> steps_, initial_;
    std::map<std::string, bool> bits_;
    std::map<std::string, std::int64_t> words_;
    std::map<std::string, Timer> timers_;
    bool is_first_scan_ = true;
    Time now_ = 0;
    const Rung* rung_ = nullptr;
    std::size_t at_ = 0;
    std::size_t line_ = 0;
};

const std::regex bit_form("(I|O)[0-3],(\\d|1\\d|2[0-3])|B\\d{1,3}|X\\d\\d?|T\\d\\d?,D|SY(0|21|22)");

void Pl7Machine::read(const std::string& text) {
    std::istringstream lines(text);
    std::string part = "HEAD";
    bool has_label = false;
    for (std::string line; std::getline(lines, line);) {
        ++line_;
        if (line == "ASSIGNMENT" || line == "PRELIMINARY PROCESSING" ||
            line == "SEQUENTIAL PROCESSING" || line == "POSTERIOR PROCESSING") {
            part = line;
            has_label = false;
        } else if (line.empty() || part == "HEAD") {
            continue;
        } else if (part == "ASSIGNMENT") {
            if (line.size() < 12) fail("an assignment");
            const std::string object = line.substr(3, line.find(' ', 3) - 3);
            symbols_.emplace(std::make_pair(line.substr(12), object.front()), object);
        } else if (line.rfind("** LABEL ", 0) == 0 && part != "SEQUENTIAL PROCESSING") {
            has_label = true;
        } else if (part != "SEQUENTIAL PROCESSING") {
            if (!has_label) fail("a rung without a label");
            (part == "PRELIMINARY PROCESSING" ? preliminary_ : posterior_)
                .push_back(read_rung(line));
        } else if (line.rfind("** ", 0) == 0) {
            read_transition(line);
        } else if (transitions_.empty()) {
            static const std::regex step_form("   ([ #]) (X\\d\\d?) .*");
            std::smatch parts;
            if (!std::regex_match(line, parts, step_form)) fail("a step");
            if (!steps_.insert(parts[2]).second) fail("a step twice");
            if (parts[1] == "#") initial_.insert(parts[2]);
        } else {
            if (!transitions_.back().rung.coil.empty()) fail("two rungs for a transition");
            transitions_.back().rung = read_rung(line);
            if (transitions_.back().rung.coil != "(#)") fail("not the coil of a transition");
        }
    }
    for (const Transition& transition : transitions_) {
        if (transition.rung.coil.empty()) fail("a transition without a rung");
    }
}

void Pl7Machine::read_transition(const std::string& line) {
    static const std::regex form("\\*\\* (X[X\\d ]*) --> (X[X\\d ]*)   .*");
    std::smatch parts;
    if (!std::regex_match(line, parts, form)) fail("a transition");
    Transition transition;
    const auto names = [&](const std::string& text) {
        std::istringstream words(text);
        std::vector<std::string> result;
        for (std::string word; words >> word;) {
            if (steps_.count(word) == 0) fail("the step " + word);
            result.push_back(word);
        }
        return result;
    };
    transition.before = names(parts[1]);
    transition.after = names(parts[2]);
    transitions_.push_back(transition);
}

Rung Pl7Machine::read_rung(const std::string& line) const {
    const std::size_t wire = line.find(" --");
    if (line.rfind("   ", 0) != 0 || wire == std::string::npos) fail("a rung");
    return {line.substr(3, wire - 3), line.substr(wire + 3), line_};
}

const std::string& Pl7Machine::symbol(const std::string& name, char letter) const {
    const auto found = symbols_.find({name, letter});
    if (found == symbols_.end()) throw PlcError(0, "no object for " + name);
    return found->second;
}

void Pl7Machine::evolve() {
    std::set<std::string> left;
    std::set<std::string> entered;
    for (const Transition& transition : transitions_) {
        const bool holds = contacts(transition.rung);
        const bool enabled = std::all_of(transition.before.begin(), transition.before.end(),
                                         [&](const std::string& step) { return bit(step); });
        if (!holds || !enabled) continue;
        left.insert(transition.before.begin(), transition.before.end());
        entered.insert(transition.after.begin(), transition.after.end());
    }
    for (const std::string& step : steps_) {
        const bool stays = bit(step) && left.count(step) == 0;
        bits_[step] = stays || entered.count(step) != 0;
        if (bit("SY21")) bits_[step] = initial_.count(step) != 0;
        if (bit("SY22")) bits_[step] = false;
    }
}

void Pl7Machine::execute(const Rung& rung) {
    const bool holds = contacts(rung);
    static const std::regex coil_form("\\(([ SR])\\) (.*)");
    static const std::regex timer_form("(T\\d\\d?) TB=(10ms|100ms|1s|1mn) P=(\\d{1,4})");
    std::smatch parts;
    if (std::regex_match(rung.coil, parts, coil_form)) {
        const std::string object = parts[2];
        const bool is_written =
            object.front() == 'O' || object.front() == 'B' || object == "SY21" || object == "SY22";
        if (!is_written || !std::regex_match(object, bit_form)) fail("a coil on " + object);
        if (parts[1] == " ") {
            bits_[object] = holds;
        } else if (holds) {
            bits_[object] = parts[1] == "S";
        }
    } else if (std::regex_match(rung.coil, parts, timer_form)) {
        run_timer(parts, holds);
    } else if (rung.coil.front() == '[' && rung.coil.back() == ']') {
        if (holds) operate(rung.coil.substr(1, rung.coil.size() - 2));
    } else {
        fail("a coil");
    }
}

/// `W0 + 1 -> W2`, `5 -> W0`.
void Pl7Machine::operate(const std::string& block) {
    static const std::regex form("(-?\\w+)(?: ([+-]) (-?\\w+))? -> (W\\d{1,3})");
    std::smatch parts;
    if (!std::regex_match(block, parts, form)) fail("an OPERATE block");
    std::int64_t result = value(parts[1]);
    if (parts[2].matched) result += parts[2] == "+" ? value(parts[3]) : -value(parts[3]);
    if (result > INT16_MAX || result < INT16_MIN) fail("a word overflows");
    words_[parts[4]] = result;
}

void Pl7Machine::run_timer(const std::smatch& parts, bool drives) {
    const Time base = parts[2] == "10ms"    ? 10 * millisecond
                      : parts[2] == "100ms" ? 100 * millisecond
                      : parts[2] == "1s"    ? second
                                            : minute;
    Timer& timer = timers_[parts[1]];
    if (drives && !timer.runs) timer.since = now_;
    timer.runs = drives;
    bits_[parts[1].str() + ",D"] = drives && now_ - timer.since >= std::stoll(parts[3]) * base;
}

bool Pl7Machine::contacts(const Rung& rung) {
    rung_ = &rung;
    line_ = rung.line;
    at_ = 0;
    const bool holds = parallel();
    if (at_ != rung.contacts.size()) fail("contacts");
    return holds;
}

bool Pl7Machine::parallel() {
    bool holds = series();
    while (accept(" + ")) {
        const bool other = series();
        holds = holds || other;
    }
    return holds;
}

bool Pl7Machine::series() {
    bool holds = contact();
    while (accept(" . ")) {
        const bool other = contact();
        holds = holds && other;
    }
    return holds;
}

bool Pl7Machine::contact() {
    if (accept("=1")) return true;
    if (accept("=0")) return false;
    if (accept("(")) {
        const bool holds = parallel();
        if (!accept(")")) fail("a branch without an end");
        return holds;
    }
    if (accept("[")) {
        const std::size_t end = rung_->contacts.find(']', at_);
        if (end == std::string::npos) fail("a block without an end");
        const std::string block = rung_->contacts.substr(at_, end - at_);
        at_ = end + 1;
        return compare(block);
    }
    const bool negated = accept("/");
    const std::size_t end =
        std::min(rung_->contacts.find_first_of(" )", at_), rung_->contacts.size());
    const std::string object = rung_->contacts.substr(at_, end - at_);
    if (!std::regex_match(object, bit_form)) fail("a contact on " + object);
    at_ = end;
    return bit(object) != negated;
}

/// `W0 <= 5`.
bool Pl7Machine::compare(const std::string& block) {
    static const std::regex form("(-?\\w+) (=|<>|<|<=|>|>=) (-?\\w+)");
    std::smatch parts;
    if (!std::regex_match(block, parts, form)) fail("a COMPAR block");
    const std::int64_t left = value(parts[1]);
    const std::int64_t right = value(parts[3]);
    const std::string relation = parts[2];
    if (relation == "=") return left == right;
    if (relation == "<>") return left != right;
    if (relation == "<") return left < right;
    if (relation == "<=") return left <= right;
    return relation == ">" ? left > right : left >= right;
}

std::int64_t Pl7Machine::value(const std::string& operand) const {
    static const std::regex word("W\\d{1,3}");
    static const std::regex number("-?\\d{1,5}");
    if (std::regex_match(operand, word)) {
        const auto found = words_.find(operand);
        return found == words_.end() ? 0 : found->second;
    }
    if (!std::regex_match(operand, number)) fail("the operand " + operand);
    return std::stoll(operand);
}

}  // namespace

std::unique_ptr<PlcMachine> pl7_machine(const std::string& text, const Grafcet& grafcet) {
    return std::make_unique<Pl7Machine>(text, grafcet);
}

}  // namespace grafwire::testing
