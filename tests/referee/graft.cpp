#include "referee/graft.h"

#include <algorithm>
#include <vector>

namespace grafwire::testing {

namespace {

class Graft {
  public:
    Graft(Netlist& netlist, RandomSource& random, std::string& told)
        : netlist_(netlist), random_(random), told_(told), old_nets_(netlist.net_count()) {}

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
        Cell& gate = netlist_.cells[id];
        told_ += "; one more pin of " + name(gate.output);
        const auto old = netlist_.pins_of(gate);
        std::vector<NetId> pins(old.begin(), old.end());
        pins.push_back(pin);
        set_pins(gate, pins);
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

    /// Something that depends on this and that.
    NetId rare_signal() {
        std::vector<NetId> parts;
        for (std::size_t count = random_.between(1, 3); count != 0; --count) {
            NetId part = random_.flip() ? remembering(any_net()) : any_net();
            if (random_.one_in(3)) part = add(CellType::inverter, {part});
            for (std::size_t more = random_.flip() ? 0 : random_.below(6); more != 0; --more) {
                part = add(CellType::buffer, {part});
            }
            parts.push_back(part);
        }
        return parts.size() == 1 ? parts[0] : add(CellType::and_gate, parts);
    }

    NetId remembering(NetId net) {
        if (netlist_.is_clocked()) {
            const NetId stored = add(CellType::flip_flop, {net, netlist_.clock}, Logic::zero);
            return random_.flip() ? stored : add(CellType::xor_gate, {net, stored});
        }
        switch (random_.below(5)) {
            case 0:
                return add(CellType::latch, {net, any_net()}, Logic::zero);
            case 1:
                return add(CellType::hold_latch, {net, any_net()}, Logic::zero);
            case 2:
                return add(CellType::and_gate, {net, add(CellType::inverter, {delayed(net)})});
            default:
                return add(random_.flip() ? CellType::rise_pulse : CellType::fall_pulse, {net});
        }
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
                const auto& ports = random_.flip() ? netlist_.inputs : netlist_.outputs;
                net = random_.pick(ports).net;
            }
            if (net != netlist_.clock) return net;
        }
    }

    NetId add(CellType type, const std::vector<NetId>& pins, Logic initial = Logic::unknown) {
        Cell cell;
        cell.type = type;
        cell.initial = initial;
        cell.output = netlist_.names.add("graft$" + std::to_string(netlist_.net_count()));
        if (row_of(type).has_timing) {
            cell.timing = static_cast<std::uint32_t>(netlist_.timings.size());
            netlist_.timings.push_back({0, static_cast<Time>(random_.between(1, 5)) * nanosecond});
        }
        set_pins(cell, pins);
        netlist_.cells.add(cell);
        ++netlist_.modules.back().cell_count;
        told_ += (told_.empty() ? "" : "; ") + name(cell.output) + " = " +
                 std::string(row_of(type).name);
        for (const NetId pin : pins) told_ += " " + name(pin);
        return cell.output;
    }
    void set_pins(Cell& cell, const std::vector<NetId>& pins) {
        cell.first_pin = static_cast<std::uint32_t>(netlist_.pins.size());
        cell.pin_count = static_cast<std::uint32_t>(pins.size());
        netlist_.pins.insert(netlist_.pins.end(), pins.begin(), pins.end());
    }
    std::string name(NetId net) const { return std::string(netlist_.names[net]); }

    Netlist& netlist_;
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
