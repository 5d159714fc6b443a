// A timer of operand a and output q counts the scans in which they differ. Its delays are N and M
// scans; `up` is 1 once the count has reached N, `down` once it has reached M:
//
//     next  = a.(q + up) + /a.q./down     what q takes at the rise of the clock
//     run   = a./q./up + /a.q./down       else the count goes back to 0
//     count = run ? count + 1 : 0         a ripple-carry incrementer
//
// As the count goes up one by one, N is the first number with all the ones that N has in binary: so
// `up` is an AND of those bits alone, and no comparator is needed. The count of a begun delay never
// passes N, for when a changes within the delay it equals q, and the count goes back to 0.
//
// A look-ahead is the same without the flip-flop of q: its output is `next`.

#include "netlist/passes/counted_timers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_set>
#include <vector>

namespace grafwire {

namespace {

Time scans_of(Time delay, Time scan_period) {
    return delay / scan_period + (delay % scan_period != 0 ? 1 : 0);
}

class TimerCounters {
  public:
    TimerCounters(const Netlist& netlist, Time scan_period)
        : source_(netlist), scan_period_(scan_period) {
        result_.netlist = netlist;
        result_.netlist.cells = {};
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            taken_.emplace(netlist.names[static_cast<NetId>(i)]);
        }
    }

    CountedTimers make();

  private:
    void write_timer(const Cell& cell);
    void add_bits(Time longest);
    NetId reached(Time scans);
    void add_rise(NetId up);
    void add_fall(NetId down);
    void count();
    NetId any_of(const std::vector<NetId>& terms, const std::string& role) {
        return terms.size() == 1 ? terms[0] : gate(CellType::or_gate, terms, role);
    }

    NetId add_net(const std::string& role);
    void add_cell(CellType type, NetId output, const std::vector<NetId>& pins,
                  Logic initial = Logic::unknown);
    NetId gate(CellType type, const std::vector<NetId>& pins, const std::string& role) {
        const NetId output = add_net(role);
        add_cell(type, output, pins);
        return output;
    }

    const Netlist& source_;
    Time scan_period_;
    CountedTimers result_;
    std::unordered_set<std::string> taken_;
    // Of the timer in hand.
    std::string owner_;
    std::uint32_t origin_ = 0;
    NetId operand_ = no_net;
    NetId held_ = no_net;
    NetId clock_ = no_net;
    std::vector<NetId> bits_;  ///< of the count, the lowest first
    std::vector<NetId> next_terms_;
    std::vector<NetId> run_terms_;
};

CountedTimers TimerCounters::make() {
    for (Module& module : result_.netlist.modules) {
        const std::uint32_t first = module.first_cell;
        const std::uint32_t count = module.cell_count;
        module.first_cell = static_cast<std::uint32_t>(result_.netlist.cells.size());
        for (std::uint32_t i = first; i < first + count; ++i) {
            const Cell& cell = source_.cells.items()[i];
            if (counts_scans(cell.type)) {
                write_timer(cell);
            } else {
                result_.netlist.cells.add(cell);
            }
        }
        module.cell_count =
            static_cast<std::uint32_t>(result_.netlist.cells.size()) - module.first_cell;
    }
    return std::move(result_);
}

NetId TimerCounters::add_net(const std::string& role) {
    std::string name = owner_ + '$' + role;
    while (!taken_.insert(name).second) name += '$';
    return result_.netlist.names.add(name);
}

void TimerCounters::add_cell(CellType type, NetId output, const std::vector<NetId>& pins,
                             Logic initial) {
    Netlist& netlist = result_.netlist;
    const auto first_pin = static_cast<std::uint32_t>(netlist.pins.size());
    netlist.pins.insert(netlist.pins.end(), pins.begin(), pins.end());
    netlist.cells.add(
        {type, initial, first_pin, static_cast<std::uint32_t>(pins.size()), output, origin_, 0});
    if (type == CellType::flip_flop) ++result_.flip_flops;
}

void TimerCounters::write_timer(const Cell& cell) {
    const auto pins = source_.pins_of(cell);
    const bool is_timer = cell.type == CellType::scan_timer;
    const Timing& timing = source_.timings[cell.timing];
    owner_ = source_.names[cell.output];
    origin_ = cell.origin;
    operand_ = pins[0];
    held_ = is_timer ? cell.output : pins[1];
    clock_ = pins.back();
    next_terms_.clear();
    run_terms_.clear();
    const Time rise = scans_of(timing.rise, scan_period_);
    const Time fall = scans_of(timing.fall, scan_period_);
    add_bits(std::max(rise, fall));
    const NetId up = reached(rise);
    const NetId down = fall == rise ? up : reached(fall);
    add_rise(up);
    add_fall(down);
    if (!bits_.empty()) count();
    if (is_timer) {
        const NetId next = any_of(next_terms_, "next");
        add_cell(CellType::flip_flop, held_, {next, clock_}, cell.initial);
    } else {
        const bool single = next_terms_.size() == 1;
        add_cell(single ? CellType::buffer : CellType::or_gate, cell.output, next_terms_);
    }
}

void TimerCounters::add_bits(Time longest) {
    result_.longest = std::max(result_.longest, longest);
    bits_.clear();
    for (Time rest = longest; rest != 0; rest /= 2) {
        bits_.push_back(add_net(fmt::format("count{}", bits_.size())));
    }
}

/// What an operand of 1 does: `up` is no_net where it acts at once.
void TimerCounters::add_rise(NetId up) {
    if (up == no_net) return next_terms_.push_back(operand_);
    const NetId risen = gate(CellType::or_gate, {held_, up}, "risen");
    const NetId not_risen = gate(CellType::inverter, {risen}, "not_risen");
    next_terms_.push_back(gate(CellType::and_gate, {operand_, risen}, "on"));
    run_terms_.push_back(gate(CellType::and_gate, {operand_, not_risen}, "rising"));
}

/// What an operand of 0 does, likewise.
void TimerCounters::add_fall(NetId down) {
    if (down == no_net) return;
    const NetId off = gate(CellType::inverter, {operand_}, "off");
    const NetId not_fallen = gate(CellType::inverter, {down}, "not_fallen");
    const NetId falling = gate(CellType::and_gate, {off, held_, not_fallen}, "falling");
    next_terms_.push_back(falling);
    run_terms_.push_back(falling);
}

/// Whether the count has come to a number of scans; no_net for none.
NetId TimerCounters::reached(Time scans) {
    if (scans == 0) return no_net;
    std::vector<NetId> ones;
    for (std::size_t bit = 0; bit < bits_.size(); ++bit) {
        if ((static_cast<std::uint64_t>(scans) >> bit & 1U) != 0) ones.push_back(bits_[bit]);
    }
    return ones.size() == 1 ? ones[0]
                            : gate(CellType::and_gate, ones, fmt::format("after{}", scans));
}

void TimerCounters::count() {
    const NetId run = any_of(run_terms_, "run");
    NetId carry = no_net;  // into bit 0 comes a 1
    for (std::size_t bit = 0; bit < bits_.size(); ++bit) {
        const NetId here = bits_[bit];
        const CellType adder = carry == no_net ? CellType::inverter : CellType::xor_gate;
        std::vector<NetId> pins{here};
        if (carry != no_net) pins.push_back(carry);
        const NetId sum = gate(adder, pins, fmt::format("sum{}", bit));
        const NetId next = gate(CellType::and_gate, {run, sum}, fmt::format("count{}$next", bit));
        add_cell(CellType::flip_flop, here, {next, clock_}, Logic::zero);
        if (bit + 1 == bits_.size()) break;
        carry =
            carry == no_net ? here : gate(CellType::and_gate, pins, fmt::format("carry{}", bit));
    }
}

}  // namespace

bool has_scan_timers(const Netlist& netlist) {
    return std::any_of(netlist.cells.begin(), netlist.cells.end(),
                       [](const Cell& cell) { return counts_scans(cell.type); });
}

CountedTimers with_counted_timers(const Netlist& netlist, Time scan_period) {
    return TimerCounters(netlist, scan_period).make();
}

}  // namespace grafwire
