#include "plc/pl7_machine.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <vector>

#include "plc/pl7_listing.h"

namespace grafwire::testing {

namespace {

struct Timer {
    bool runs = false;
    Time since = 0;
};

class Pl7Machine : public PlcMachine {
  public:
    Pl7Machine(const std::string& text, const Grafcet& grafcet)
        : listing_(read_pl7(text)), grafcet_(grafcet) {
        for (const std::string& step : listing_.initial) bits_[step] = true;
    }

    void set_input(std::uint32_t index, bool value) override {
        bits_[symbol(std::string(input_name(grafcet_, index)), 'I')] = value;
    }
    void scan(Time now) override {
        now_ = now;
        bits_["SY0"] = is_first_scan_;
        is_first_scan_ = false;
        in_preliminary_ = true;
        for (const Pl7Rung& rung : listing_.preliminary) execute(rung);
        in_preliminary_ = false;
        evolve();
        for (const Pl7Rung& rung : listing_.posterior) execute(rung);
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
    const std::string& symbol(const std::string& name, char letter) const;

    bool bit(const std::string& object) const {
        const auto found = bits_.find(object);
        return found != bits_.end() && found->second;
    }
    void evolve();
    void clear_transitions();
    void execute(const Pl7Rung& rung);
    void check_coil(const std::string& object, const std::string& kind) const;
    void operate(const std::string& block);
    void run_timer(const std::smatch& parts, bool drives);

    // Contacts, by recursive descent over the text of a rung.
    bool contacts(const Pl7Rung& rung);
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

    Pl7Listing listing_;
    const Grafcet& grafcet_;
    std::map<std::string, bool> bits_;
    std::map<std::string, std::int64_t> words_;
    std::map<std::string, Timer> timers_;
    bool is_first_scan_ = true;
    bool in_preliminary_ = false;
    std::size_t preset_line_ = 0;  ///< of the last rung that preset a step in this scan, or 0
    Time now_ = 0;
    const Pl7Rung* rung_ = nullptr;
    std::size_t at_ = 0;
    std::size_t line_ = 0;
};

const std::string& Pl7Machine::symbol(const std::string& name, char letter) const {
    const auto found = listing_.symbols.find({name, letter});
    if (found == listing_.symbols.end()) throw PlcError(0, "no object for " + name);
    return found->second;
}

/// The system bits are taken into account as the sequential processing begins, the lowest first and
/// one of them a scan; the one that was is 0 afterwards. Steps that were preset and do not count
/// (SY23 is 0, or another comes first) are a mistake.
void Pl7Machine::evolve() {
    if (preset_line_ != 0 && (!bit("SY23") || bit("SY21") || bit("SY22"))) {
        throw PlcError(preset_line_, "a step is preset, and SY23 is not what acts");
    }
    preset_line_ = 0;
    for (const Pl7Transition& transition : listing_.transitions) contacts(transition.rung);
    if (bit("SY21")) {
        for (const std::string& step : listing_.steps) {
            bits_[step] = listing_.initial.count(step) != 0;
        }
        bits_["SY21"] = false;
    } else if (bit("SY22")) {
        for (const std::string& step : listing_.steps) bits_[step] = false;
        bits_["SY22"] = false;
    } else if (bit("SY23")) {
        bits_["SY23"] = false;
    } else {
        clear_transitions();
    }
}

void Pl7Machine::clear_transitions() {
    std::set<std::string> left;
    std::set<std::string> entered;
    for (const Pl7Transition& transition : listing_.transitions) {
        const bool holds = contacts(transition.rung);
        const bool enabled = std::all_of(transition.before.begin(), transition.before.end(),
                                         [&](const std::string& step) { return bit(step); });
        if (!holds || !enabled) continue;
        left.insert(transition.before.begin(), transition.before.end());
        entered.insert(transition.after.begin(), transition.after.end());
    }
    for (const std::string& step : listing_.steps) {
        const bool stays = bit(step) && left.count(step) == 0;
        bits_[step] = stays || entered.count(step) != 0;
    }
}

/// What a coil may stand on: outputs and internal bits anywhere; in the preliminary processing also
/// SY21 to SY23, and steps of the chart, which are set and reset.
void Pl7Machine::check_coil(const std::string& object, const std::string& kind) const {
    const bool anywhere = object.front() == 'O' || object.front() == 'B';
    const bool acts_on_chart = object.rfind("SY2", 0) == 0;
    const bool is_step = listing_.steps.count(object) != 0 && kind != " ";
    if (!is_pl7_bit(object) || !(anywhere || (in_preliminary_ && (acts_on_chart || is_step)))) {
        fail("a coil on " + object);
    }
}

void Pl7Machine::execute(const Pl7Rung& rung) {
    const bool holds = contacts(rung);
    static const std::regex timer_form("(T\\d\\d?) TB=(10ms|100ms|1s|1mn) P=(\\d{1,4})");
    std::smatch parts;
    const std::string form = rung.coil.substr(0, 4);
    if (form == "( ) " || form == "(S) " || form == "(R) ") {
        const std::string object = rung.coil.substr(4);
        const std::string kind = form.substr(1, 1);
        check_coil(object, kind);
        if (holds && object.front() == 'X') preset_line_ = rung.line;
        if (kind == " ") {
            bits_[object] = holds;
        } else if (holds) {
            bits_[object] = kind == "S";
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

bool Pl7Machine::contacts(const Pl7Rung& rung) {
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
    if (!is_pl7_bit(object)) fail("a contact on " + object);
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
