#include "plain_cells.h"

#include <algorithm>
#include <optional>

namespace grafwire::testing {

namespace {

using Moments = std::vector<PlainMoment>;

bool gate_value(CellType type, const std::vector<bool>& pins) {
    const auto ones = std::count(pins.begin(), pins.end(), true);
    const bool all = ones == static_cast<std::ptrdiff_t>(pins.size());
    switch (type) {
        case CellType::low:
            return false;
        case CellType::high:
            return true;
        case CellType::inverter:
        case CellType::nor_gate:
            return ones == 0;
        case CellType::and_gate:
            return all;
        case CellType::nand_gate:
            return !all;
        case CellType::xor_gate:
            return ones % 2 == 1;
        default:  // buffer, OR
            return ones > 0;
    }
}

/// Inertial: the output is what the function of the cell has been throughout a delay. Memories are
/// functions of the output too.
class PlainGate {
  public:
    PlainGate(const PlainCell& cell, bool at_rest) : cell_(cell), output_(at_rest) {
        // At rest for longer than any delay.
        since_ = -1'000'000;
        function_ = at_rest;
    }
    bool output() const { return output_; }
    /// Brings the output to a moment, then the function of that moment is known.
    void begin_moment(std::int64_t now) {
        if (now - since_ >= (function_ ? cell_.rise : cell_.fall)) output_ = function_;
    }
    void end_moment(std::int64_t now, bool function) {
        if (function == function_) return;
        function_ = function;
        since_ = now;
    }
    void jump(bool value) { output_ = function_ = value; }

  private:
    const PlainCell& cell_;
    bool output_;
    bool function_;
    std::int64_t since_;
};

/// The delay of a timer: of an operand that has differed from what the timer takes.
struct PlainDelay {
    std::optional<std::int64_t> begun;
    bool towards = false;
    bool has_ended(const PlainCell& cell, std::int64_t instant) const {
        return begun && instant >= *begun + (towards ? cell.on_delay : cell.off_delay);
    }
    /// What a timer that has taken `taken` takes of its operand.
    bool look(const PlainCell& cell, bool operand, bool taken, std::int64_t instant) {
        if (begun && towards != operand) begun.reset();
        if (operand == taken) {
            begun.reset();
            return taken;
        }
        if (!begun) begun = instant;
        towards = operand;
        if ((operand ? cell.on_delay : cell.off_delay) != 0) return taken;
        begun.reset();
        return operand;
    }
};

/// Moment by moment: what a cell does between the change of its pins and that of its output.
class Plain {
  public:
    Plain(const PlainCell& cell, const Moments& moments, bool delays_end)
        : cell_(cell),
          moments_(moments),
          delays_end_(delays_end),
          taken_(row_of(cell.type).has_memory ? cell.initial
                                              : gate_value(cell.type, moments.front().pins)),
          gate_(cell, taken_) {}

    std::vector<bool> run() {
        // Long enough before the first moment for a latch to have come to rest.
        for (std::int64_t t = -50; t < static_cast<std::int64_t>(moments_.size()); ++t) {
            const bool is_new = t > 0 && at(t).instant != at(t - 1).instant;
            if (is_new) begin_instant(at(t));
            gate_.begin_moment(t);
            gate_.end_moment(t, function(t));
            if (t >= 0) output_.push_back(gate_.output());
        }
        return output_;
    }

  private:
    const PlainMoment& at(std::int64_t t) const {
        return moments_[static_cast<std::size_t>(std::max<std::int64_t>(t, 0))];
    }
    bool clock_rises(std::int64_t t) const {
        return t > 0 && at(t).pins.back() && !at(t - 1).pins.back();
    }

    /// A delay that ends now, if the operand still asks for it.
    void begin_instant(const PlainMoment& moment) {
        const bool by_itself = cell_.type == CellType::timer || delays_end_;
        if (!by_itself || !delay_.has_ended(cell_, moment.instant)) return;
        const bool is_look_ahead = cell_.type == CellType::scan_timer_next;
        if (moment.pins[0] == (is_look_ahead ? moment.pins[1] : taken_)) return;
        delay_.begun.reset();
        if (is_look_ahead) return;
        taken_ = delay_.towards;
        gate_.jump(taken_);
    }

    bool function(std::int64_t t) {
        const std::vector<bool>& pins = at(t).pins;
        switch (cell_.type) {
            case CellType::latch:
                return pins[0] || (!pins[1] && gate_.output());
            case CellType::hold_latch:
                return pins[1] ? pins[0] : gate_.output();
            case CellType::flip_flop:
                if (clock_rises(t)) taken_ = at(t - 1).pins[0];
                return taken_;
            case CellType::timer:
                taken_ = delay_.look(cell_, pins[0], taken_, at(t).instant);
                return taken_;
            case CellType::scan_timer:
                if (clock_rises(t)) take_scan(at(t - 1).pins[0], at(t).instant);
                return taken_;
            case CellType::scan_timer_next:
                return look_ahead(t);
            default:
                return gate_value(cell_.type, pins);
        }
    }

    void take_scan(bool operand, std::int64_t instant) {
        taken_ = delay_.look(cell_, operand, taken_, instant);
        if (!delay_.has_ended(cell_, instant)) return;
        taken_ = delay_.towards;
        delay_.begun.reset();
    }

    /// Pins: operand, what the timer shows, clock.
    bool look_ahead(std::int64_t t) {
        const std::int64_t instant = at(t).instant;
        if (clock_rises(t)) {
            delay_.look(cell_, at(t - 1).pins[0], at(t - 1).pins[1], instant);
            if (delay_.has_ended(cell_, instant)) delay_.begun.reset();
        }
        PlainDelay next = delay_;
        const bool shown = at(t).pins[1];
        const bool taken = next.look(cell_, at(t).pins[0], shown, instant);
        return next.has_ended(cell_, instant) ? next.towards : taken;
    }

    const PlainCell& cell_;
    const Moments& moments_;
    bool delays_end_;
    bool taken_;  ///< by a memory, whatever its output still shows
    PlainDelay delay_;
    PlainGate gate_;
    std::vector<bool> output_;
};

/// 1 from a delay after each edge on, for the width.
std::vector<bool> plain_pulses(const PlainCell& cell, const Moments& moments) {
    const bool after = cell.type == CellType::rise_pulse;
    std::vector<bool> output(moments.size(), false);
    const auto count = static_cast<std::int64_t>(moments.size());
    for (std::int64_t t = 1; t < count; ++t) {
        const auto place = static_cast<std::size_t>(t);
        if (moments[place].pins[0] != after || moments[place - 1].pins[0] == after) continue;
        const std::int64_t from = t + cell.rise;
        for (std::int64_t p = from; p < std::min(from + cell.width, count); ++p) {
            output[static_cast<std::size_t>(p)] = true;
        }
    }
    return output;
}

}  // namespace

std::vector<bool> plain_output(const PlainCell& cell, const std::vector<PlainMoment>& moments,
                               bool delays_end) {
    const bool is_pulse = cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse;
    return is_pulse ? plain_pulses(cell, moments) : Plain(cell, moments, delays_end).run();
}

}  // namespace grafwire::testing
