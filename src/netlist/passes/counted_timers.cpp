// Clocked timers as counters of gates and flip-flops.
//
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
// The cost is that of the numbers: a delay of 5 s at a scan period of 10 ms is
// counted in 9 flip-flops.
//
// A look-ahead is the same without the flip-flop of q: its output is `next`.

#include "netlist/passes/counted_timers.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "netlist/netlist_builder.h"

namespace grafwire {

namespace {

Time scans_of(Time delay, Time scan_period) {
    return delay / scan_period + (delay % scan_period != 0 ? 1 : 0);
}

/// The gates and flip-flops in the place of one clocked timer or look-ahead.
class CountedTimer {
  public:
    CountedTimer(NetlistBuilder& builder, CellPlace place, const Netlist& source, const Cell& cell)
        : builder_(builder),
          place_(place),
          cell_(cell),
          is_timer_(cell.type == CellType::scan_timer),
          owner_(source.names[cell.output]) {
        const auto pins = source.pins_of(cell);
        operand_ = pins[0];
        held_ = is_timer_ ? cell.output : pins[1];
        clock_ = pins.back();
    }

    /// The delays are in scans.
    void make(Time rise, Time fall);
    std::size_t flip_flops() const { return flip_flops_; }

  private:
    void add_bits(Time longest);
    NetId reached(Time scans);
    void add_rise(NetId up);
    void add_fall(NetId down);
    void count();
    NetId any_of(const std::vector<NetId>& terms, const std::string& role) {
        return terms.size() == 1 ? terms[0] : gate(CellType::or_gate, terms, role);
    }
    void add_flip_flop(NetId output, NetId next, Logic initial) {
        const NetId pins[] = {next, clock_};
        builder_.add_cell(place_, CellType::flip_flop, output, pins, {initial, {}});
        ++flip_flops_;
    }
    NetId gate(CellType type, const std::vector<NetId>& pins, const std::string& role) {
        return builder_.gate(place_, type, pins, owner_, role);
    }

    NetlistBuilder& builder_;
    CellPlace place_;
    const Cell& cell_;
    bool is_timer_;
    std::string owner_;
    NetId operand_ = no_net;
    NetId held_ = no_net;
    NetId clock_ = no_net;
    std::vector<NetId> bits_;  ///< of the count, the lowest first
    std::vector<NetId> next_terms_;
    std::vector<NetId> run_terms_;
    std::size_t flip_flops_ = 0;
};

void CountedTimer::make(Time rise, Time fall) {
    add_bits(std::max(rise, fall));
    const NetId up = reached(rise);
    const NetId down = fall == rise ? up : reached(fall);
    add_rise(up);
    add_fall(down);
    if (!bits_.empty()) count();
    if (is_timer_) {
        add_flip_flop(held_, any_of(next_terms_, "next"), cell_.initial);
    } else {
        builder_.drive(place_, cell_.output, CellType::or_gate, next_terms_);
    }
}

void CountedTimer::add_bits(Time longest) {
    for (Time rest = longest; rest != 0; rest /= 2) {
        bits_.push_back(builder_.add_inner_net(owner_, fmt::format("count{}", bits_.size())));
    }
}

/// What an operand of 1 does: `up` is no_net where it acts at once.
void CountedTimer::add_rise(NetId up) {
    if (up == no_net) return next_terms_.push_back(operand_);
    const NetId risen = gate(CellType::or_gate, {held_, up}, "risen");
    const NetId not_risen = gate(CellType::inverter, {risen}, "not_risen");
    next_terms_.push_back(gate(CellType::and_gate, {operand_, risen}, "on"));
    run_terms_.push_back(gate(CellType::and_gate, {operand_, not_risen}, "rising"));
}

/// What an operand of 0 does, likewise.
void CountedTimer::add_fall(NetId down) {
    if (down == no_net) return;
    const NetId off = gate(CellType::inverter, {operand_}, "off");
    const NetId not_fallen = gate(CellType::inverter, {down}, "not_fallen");
    const NetId falling = gate(CellType::and_gate, {off, held_, not_fallen}, "falling");
    next_terms_.push_back(falling);
    run_terms_.push_back(falling);
}

/// Whether the count has come to a number of scans; no_net for none.
NetId CountedTimer::reached(Time scans) {
    if (scans == 0) return no_net;
    std::vector<NetId> ones;
    for (std::size_t bit = 0; bit < bits_.size(); ++bit) {
        if ((static_cast<std::uint64_t>(scans) >> bit & 1U) != 0) ones.push_back(bits_[bit]);
    }
    return ones.size() == 1 ? ones[0]
                            : gate(CellType::and_gate, ones, fmt::format("after{}", scans));
}

void CountedTimer::count() {
    const NetId run = any_of(run_terms_, "run");
    NetId carry = no_net;  // into bit 0 comes a 1
    for (std::size_t bit = 0; bit < bits_.size(); ++bit) {
        const NetId here = bits_[bit];
        const CellType adder = carry == no_net ? CellType::inverter : CellType::xor_gate;
        std::vector<NetId> pins{here};
        if (carry != no_net) pins.push_back(carry);
        const NetId sum = gate(adder, pins, fmt::format("sum{}", bit));
        const NetId next = gate(CellType::and_gate, {run, sum}, fmt::format("count{}$next", bit));
        add_flip_flop(here, next, Logic::zero);
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
    NetlistBuilder builder = NetlistBuilder::without_cells_of(netlist);
    CountedTimers result;
    for (const Module& module : netlist.modules) {
        const ModuleId id = builder.add_module(module.name, module.comment);
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            const Cell& cell = netlist.cells.items()[module.first_cell + i];
            if (!counts_scans(cell.type)) {
                builder.copy_cell(id, netlist, cell);
                continue;
            }
            const Timing& timing = netlist.timings[cell.timing];
            const Time rise = scans_of(timing.rise, scan_period);
            const Time fall = scans_of(timing.fall, scan_period);
            CountedTimer counted(builder, {id, cell.origin}, netlist, cell);
            counted.make(rise, fall);
            result.flip_flops += counted.flip_flops();
            result.longest = std::max({result.longest, rise, fall});
        }
    }
    result.netlist = builder.finish();
    return result;
}

}  // namespace grafwire
