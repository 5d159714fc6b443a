#pragma once

#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// So that a failed comparison shows values.
std::ostream& operator<<(std::ostream& out, Logic value);

}  // namespace grafwire

namespace grafwire::testing {

inline constexpr Logic zero = Logic::zero;
inline constexpr Logic one = Logic::one;
inline constexpr Logic unknown = Logic::unknown;
inline constexpr Logic all_values[] = {zero, one, unknown};

/// A netlist written by hand, nets by their names; a name stands for its net from its first use.
class SmallNetlist {
  public:
    SmallNetlist();

    NetId net(std::string_view name);
    void input(std::string_view name);
    void output(std::string_view name);
    CellId cell(CellType type, std::string_view name, const std::vector<std::string>& pins,
                Logic initial = Logic::unknown);
    CellId timed(CellType type, std::string_view name, const std::vector<std::string>& pins,
                 Timing timing, Logic initial = Logic::unknown);
    void clock(std::string_view name);
    void starts_at(std::string_view name, bool value);

    Netlist netlist;

  private:
    std::unordered_map<std::string, NetId> nets_;
};

/// A simulator over a small netlist that speaks of nets by name.
class Bench {
  public:
    explicit Bench(SmallNetlist& small) : Bench(small, cell_delays(small.netlist, {})) {}
    Bench(SmallNetlist& small, const CellDelays& delays, const DelaySchedule& schedule = {})
        : small_(small), simulator(small.netlist, delays, schedule) {}

    void set(std::string_view net, Logic value) { simulator.set_input(small_.net(net), value); }
    Logic get(std::string_view net) { return simulator.value(small_.net(net)); }
    /// Lets time pass to a moment, given in nanoseconds.
    void at(Time nanoseconds) { simulator.begin_instant(nanoseconds * nanosecond); }
    /// Sets one input and settles.
    void step(std::string_view net, Logic value) {
        set(net, value);
        simulator.settle();
    }
    /// Notes all changes of a net from now on as "1@5 0@7", in nanoseconds from `origin`.
    void record(std::string_view net);
    std::string changes;
    Time origin = 0;

  private:
    SmallNetlist& small_;

  public:
    Simulator simulator;
};

}  // namespace grafwire::testing
