#include "referee/graft.h"

#include <vector>

#include "referee/foreign_cells.h"

namespace grafwire::testing {

namespace {

class Graft {
  public:
    Graft(Netlist& netlist, RandomSource& random, std::string& told)
        : netlist_(netlist),
          cells_(netlist),
          random_(random),
          told_(told),
          old_nets_(netlist.net_count()) {}

    void make() {
        if (random_.one_in(4) && change_length()) return;
        const NetId foreign = rare_signal();
        std::vector<CellId> gates;
        for (std::size_t i = 0; i < old_cells_; ++i) {
            if (takes_more_pins(netlist_.cells.items()[i].type)) {
                gates.push_back(netlist_.cells.id_at(i));
            }
        }
        if (gates.empty()) return;
        const CellId id = random_.pick(gates);
        const CellType type = netlist_.cells[id].type;
        const bool by_one = type == CellType::or_gate || type == CellType::nor_gate;
        const NetId pin = by_one ? foreign : add(CellType::inverter, {foreign});
        const NetId driven = netlist_.cells[id].output;
        cells_.lead_to(pin, driven);
        told_ += "; one more pin of " + name(driven);
    }

  private:
    static bool takes_more_pins(CellType type) {
        return type >= CellType::and_gate && type <= CellType::nor_gate;
    }

    /// Other delays or another width in a cell that has some.
    bool change_length() {
        std::vector<CellId> timed;
        for (std::size_t i = 0; i < old_cells_; ++i) {
            if (row_of(netlist_.cells.items()[i].type).has_timing) {
                timed.push_back(netlist_.cells.id_at(i));
            }
        }
        if (timed.empty()) return false;
        Cell& cell = netlist_.cells[random_.pick(timed)];
        Timing timing = netlist_.timings[cell.timing];
        if (is_timer(cell.type)) {
            Time& delay = random_.flip() ? timing.rise : timing.fall;
            static constexpr Time steps[] = {500 * microsecond, millisecond, 3 * millisecond};
            const Time step = steps[random_.below(3)];
            delay = random_.flip() || delay <= step ? delay + step : delay - step;
            told_ = "delays of " + name(cell.output) + ": " + format_duration(timing.rise) + ", " +
                    format_duration(timing.fall);
        } else {
            timing.fall = static_cast<Time>(random_.between(1, 6)) * nanosecond;
            told_ = "width of " + name(cell.output) + ": " + format_duration(timing.fall);
        }
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
        netlist_.timings.push_back(timing);
        return true;
    }

    /// Something that depends on this and that; or pulses that meet only if several things happen
    /// at the right distance.
    NetId rare_signal() {
        std::vector<NetId> parts;
        const bool is_meeting = !netlist_.is_clocked() && random_.one_in(3);
        for (std::size_t count = random_.between(is_meeting ? 2 : 1, 3); count != 0; --count) {
            NetId part = is_meeting || random_.flip() ? remembering(any_net()) : any_net();
            if (!is_meeting && random_.one_in(3)) part = add(CellType::inverter, {part});
            for (std::size_t more = random_.flip() ? 0 : random_.below(6); more != 0; --more) {
                part = add(CellType::buffer, {part});
            }
            parts.push_back(part);
        }
        if (is_meeting) parts.push_back(random_.pick(netlist_.outputs).net);
        return parts.size() == 1 ? parts[0] : add(CellType::and_gate, parts);
    }

    NetId remembering(NetId net) {
        if (netlist_.is_clocked()) {
            const NetId stored = add(CellType::flip_flop, {net, netlist_.clock});
            return random_.flip() ? stored : add(CellType::xor_gate, {net, stored});
        }
        switch (random_.below(5)) {
            case 0:
                return add(CellType::latch, {net, any_net()});
            case 1:
                return add(CellType::hold_latch, {net, any_net()});
            case 2:
                return hazard(net);
            default:
                return pulse(random_.one_in(3) ? hazard(net) : net);
        }
    }
    NetId pulse(NetId net) {
        return add(random_.flip() ? CellType::rise_pulse : CellType::fall_pulse, {net});
    }
    /// 1 for a few gate delays after each rise.
    NetId hazard(NetId net) {
        return add(CellType::and_gate, {net, add(CellType::inverter, {delayed(net)})});
    }
    NetId delayed(NetId net) {
        for (std::size_t count = random_.between(1, 4); count != 0; --count) {
            net = add(CellType::buffer, {net});
        }
        return net;
    }

    NetId any_net() {
        for (;;) {
            // Inputs and X are where things begin.
            NetId net = static_cast<NetId>(random_.below(old_nets_));
            if (random_.flip()) {
                const bool is_input = random_.flip() && !netlist_.inputs.empty();
                const auto& ports = is_input ? netlist_.inputs : netlist_.outputs;
                net = random_.pick(ports).net;
            }
            if (net != netlist_.clock) return net;
        }
    }

    NetId add(CellType type, const std::vector<NetId>& pins) {
        const Time width = static_cast<Time>(random_.between(1, 5)) * nanosecond;
        const NetId net = cells_.add(type, pins, width);
        told_ += (told_.empty() ? "" : "; ") + name(net) + " = " + std::string(row_of(type).name);
        if (row_of(type).has_timing) told_ += " of " + format_duration(width);
        for (const NetId pin : pins) told_ += " " + name(pin);
        return net;
    }
    std::string name(NetId net) const { return std::string(netlist_.names[net]); }

    Netlist& netlist_;
    ForeignCells cells_;
    RandomSource& random_;
    std::string& told_;
    std::size_t old_nets_;
    std::size_t old_cells_ = netlist_.cells.size();
};

}  // namespace

Netlist grafted(Netlist netlist, RandomSource& random, std::string& told) {
    told.clear();
    Graft(netlist, random, told).make();
    return netlist;
}

}  // namespace grafwire::testing
