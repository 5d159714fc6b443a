#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "plain_cells.h"
#include "support/slow_build.h"
#include "waveform_player.h"

using namespace grafwire;
using namespace grafwire::testing;

// Three values against two: whatever an unknown input does, every cell shows at every nanosecond a
// value that the simulation with the unknown input allows. For each type of cell by itself, over
// all waveforms of a few positions in three values, and for each of them all those in two that it
// stands for. Those in two are simulated too, and must show exactly what the plain cell shows.

namespace {

struct Setting {
    PlainCell cell;
    Spread spread;
    bool by_wheel = false;  ///< an idle cell of another delay: simulated as unequal delays are
};

std::vector<std::string> pin_names(CellType type) {
    if (type == CellType::scan_timer_next) return {"a", "t", "c"};
    const CellTypeRow& row = row_of(type);
    const std::array<std::string, 2> names{"a", "c"};
    const auto count = std::clamp<std::size_t>(2, row.min_pins, row.max_pins);
    return {names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count)};
}

Timing timing_of(const PlainCell& cell) {
    if (!is_timer(cell.type)) return {0, cell.width * nanosecond, 0};
    return {cell.on_delay * millisecond, cell.off_delay * millisecond, 0};
}

/// What the look-ahead looks ahead of: a clocked timer of one nanosecond.
PlainCell timer_of(const PlainCell& look_ahead) {
    PlainCell timer = look_ahead;
    timer.type = CellType::scan_timer;
    timer.rise = timer.fall = 1;
    return timer;
}

/// One cell "y" and its inputs.
class Subject {
  public:
    explicit Subject(const Setting& setting)
        : setting_(setting), player_(small_, delays(), {"y"}, setting.spread) {}

    std::size_t inputs() const { return small_.netlist.inputs.size() - 1; }
    Seen simulated(const Waveforms& waveforms) {
        const WaveformPlayer::Played played = player_.play(waveforms);
        if (!played.settled) FAIL("does not settle");
        return played.seen[0];
    }
    Seen plain(const Waveforms& waveforms) const;

  private:
    CellDelays delays() {
        const PlainCell& cell = setting_.cell;
        CellDelays delays;
        const auto add = [&](std::int64_t rise, std::int64_t fall) {
            delays.rise.push_back(rise * nanosecond);
            delays.fall.push_back(fall * nanosecond);
        };
        const auto initial = [](const PlainCell& memory) { return memory.initial ? one : zero; };
        const std::vector<std::string> pins = pin_names(cell.type);
        for (const std::string& pin : pins) {
            if (pin != "t") small_.input(pin);
        }
        if (cell.type == CellType::scan_timer_next) {
            const PlainCell timer = timer_of(cell);
            small_.timed(timer.type, "t", {"a", "c"}, timing_of(timer), initial(timer));
            add(timer.rise, timer.fall);
        }
        small_.timed(cell.type, "y", pins, timing_of(cell), initial(cell));
        add(cell.rise, cell.fall);
        if (setting_.by_wheel) {
            small_.cell(CellType::high, "idle", {});
            delays.rise.push_back(nanosecond / 2);
            delays.fall.push_back(nanosecond / 2);
        }
        return delays;
    }

    Setting setting_;
    SmallNetlist small_;
    WaveformPlayer player_;
};

bool is_one(Logic value) {
    return value == one;
}

/// The pins nanosecond by nanosecond: a moment at rest, then those of each instant.
std::vector<PlainMoment> moments_of(const Waveforms& waveforms, const Spread& spread) {
    const auto moment = [&](std::size_t row, std::size_t instant) {
        std::vector<bool> pins;
        for (const Logic value : waveforms[row]) pins.push_back(is_one(value));
        return PlainMoment{pins, static_cast<std::int64_t>(instant)};
    };
    std::vector<PlainMoment> moments{moment(0, 0)};
    std::size_t first_row = 1;
    for (std::size_t i = 0; i < spread.positions.size(); ++i) {
        for (std::size_t t = 0; t < spread.moments; ++t) {
            moments.push_back(moment(first_row + std::min(t, spread.positions[i] - 1), i + 1));
        }
        first_row += spread.positions[i];
    }
    return moments;
}

Seen Subject::plain(const Waveforms& waveforms) const {
    const Spread& spread = setting_.spread;
    std::vector<PlainMoment> moments = moments_of(waveforms, spread);
    if (setting_.cell.type == CellType::scan_timer_next) {
        const std::vector<bool> shown =
            plain_output(timer_of(setting_.cell), moments, spread.delays_end);
        for (std::size_t t = 0; t < moments.size(); ++t) {
            moments[t].pins.insert(moments[t].pins.begin() + 1, shown[t]);
        }
    }
    const std::vector<bool> output = plain_output(setting_.cell, moments, spread.delays_end);
    Seen seen;
    for (std::size_t t = 1; t < output.size(); ++t) {
        (output[t] ? seen.one : seen.zero) |= std::uint64_t{1} << (t - 1);
    }
    return seen;
}

/// Counts in a number of values per input and row; the numbers of waveforms.
Waveforms waveforms_of(std::size_t number, std::size_t values, std::size_t inputs,
                       std::size_t rows) {
    Waveforms waveforms(rows, InputRow(inputs, zero));
    for (InputRow& row : waveforms) {
        for (Logic& value : row) {
            value = all_values[number % values];
            number /= values;
        }
    }
    return waveforms;
}

std::size_t power(std::size_t base, std::size_t exponent) {
    std::size_t result = 1;
    for (; exponent > 0; --exponent) result *= base;
    return result;
}

/// The numbers of all known waveforms that one in three values stands for.
std::vector<std::size_t> numbers_of_fills(const Waveforms& waveforms) {
    std::vector<std::size_t> numbers{0};
    std::size_t place = 1;
    for (const InputRow& row : waveforms) {
        for (const Logic value : row) {
            const std::size_t count = numbers.size();
            for (std::size_t i = 0; i < count; ++i) {
                if (value == unknown) numbers.push_back(numbers[i] + place);
                if (value == one) numbers[i] += place;
            }
            place *= 2;
        }
    }
    return numbers;
}

std::string setting_text(const Setting& setting) {
    const PlainCell& cell = setting.cell;
    std::string text(row_of(cell.type).name);
    for (const std::int64_t number :
         {cell.rise, cell.fall, cell.width, cell.on_delay, cell.off_delay}) {
        text += ' ' + std::to_string(number);
    }
    text += cell.initial ? " from 1, positions" : " from 0, positions";
    for (const std::size_t count : setting.spread.positions) text += ' ' + std::to_string(count);
    if (setting.spread.delays_end) text += ", delays end";
    if (setting.spread.restored) text += ", restored";
    return text;
}

struct Counts {
    std::size_t waveforms = 0;
    std::size_t pairs = 0;
    std::size_t known = 0;     ///< moments known in spite of something unknown in the inputs
    std::size_t needless = 0;  ///< moments unknown though all that is possible agrees
};

void examine(const Setting& setting, Counts& counts) {
    INFO(setting_text(setting));
    Subject subject(setting);
    const std::size_t rows = setting.spread.rows();
    const std::size_t places = subject.inputs() * rows;
    std::vector<Seen> in_two;
    for (std::size_t number = 0; number < power(2, places); ++number) {
        const Waveforms waveforms = waveforms_of(number, 2, subject.inputs(), rows);
        in_two.push_back(subject.simulated(waveforms));
        if (in_two.back() == subject.plain(waveforms)) continue;
        INFO(text_of(waveforms));
        CHECK(in_two.back().one == subject.plain(waveforms).one);
        return;
    }
    for (std::size_t number = 0; number < power(3, places); ++number) {
        const Waveforms waveforms = waveforms_of(number, 3, subject.inputs(), rows);
        const Seen in_three = subject.simulated(waveforms);
        const std::vector<std::size_t> fills = numbers_of_fills(waveforms);
        ++counts.waveforms;
        counts.pairs += fills.size();
        Seen possible;
        for (const std::size_t fill : fills) {
            possible.zero |= in_two[fill].zero;
            possible.one |= in_two[fill].one;
            if (in_three.allows(in_two[fill])) continue;
            INFO(text_of(waveforms));
            INFO(text_of(waveforms_of(fill, 2, subject.inputs(), rows)));
            CHECK(in_three.zero == (in_three.zero | in_two[fill].zero));
            CHECK(in_three.one == (in_three.one | in_two[fill].one));
            return;
        }
        if (fills.size() == 1) continue;
        const std::uint64_t known = in_three.zero ^ in_three.one;
        counts.known += static_cast<std::size_t>(std::popcount(known));
        counts.needless +=
            static_cast<std::size_t>(std::popcount((possible.zero ^ possible.one) & ~known));
    }
}

/// Delays of a cell (rise, fall) and whether the wheel is used.
struct Delays {
    std::int64_t rise;
    std::int64_t fall;
    bool by_wheel;
};
constexpr std::array<Delays, 4> all_delays{
    {{1, 1, false}, {1, 1, true}, {2, 4, true}, {3, 1, true}}};

/// Positions within one instant, instants, and both.
std::vector<Spread> spreads_of(CellType type, const Delays& delays) {
    std::vector<std::vector<std::size_t>> positions{{6}, {2, 1, 3}};
    if (type == CellType::timer) positions.push_back({1, 1, 1, 1, 1, 1});
    const bool is_short = delays.by_wheel && delays.rise == delays.fall;
    if (pin_names(type).size() > 1) {
        positions = is_short ? std::vector<std::vector<std::size_t>>{{3}}
                             : std::vector<std::vector<std::size_t>>{{4}, {1, 2}};
    }
    if (counts_scans(type)) {
        positions = delays.by_wheel ? std::vector<std::vector<std::size_t>>{{3}}
                                    : std::vector<std::vector<std::size_t>>{{2, 2}, {1, 1, 1, 1}};
    }
    std::vector<Spread> spreads;
    for (const std::vector<std::size_t>& row : positions) {
        const std::size_t moments = row.size() == 1 ? 40 : 64 / row.size();
        const bool is_restored = row.size() > 1;
        spreads.push_back({row, moments, true, is_restored});
        if (counts_scans(type) && row.size() == 4)
            spreads.push_back({row, moments, false, is_restored});
    }
    return spreads;
}

/// The cells of a type, but for their delays.
std::vector<PlainCell> cells_of(CellType type) {
    const bool is_pulse = type == CellType::rise_pulse || type == CellType::fall_pulse;
    std::vector<PlainCell> cells;
    for (const bool initial : {false, true}) {
        PlainCell cell{type};
        cell.initial = initial;
        if (initial && !row_of(type).has_memory) break;
        if (is_pulse) {
            for (const std::int64_t width : {1, 2, 4, 9}) {
                cell.width = width;
                cells.push_back(cell);
            }
        } else if (is_timer(type)) {
            using OnOff = std::pair<std::int64_t, std::int64_t>;
            for (const auto& [on, off] : {OnOff{0, 0}, {0, 1}, {2, 0}, {1, 1}, {2, 1}, {1, 9}}) {
                cell.on_delay = on;
                cell.off_delay = off;
                cells.push_back(cell);
            }
        } else {
            cells.push_back(cell);
        }
    }
    return cells;
}

/// Every setting in which a type of cell is examined.
std::vector<Setting> settings_of(CellType type) {
    std::vector<Setting> settings;
    for (PlainCell cell : cells_of(type)) {
        for (const Delays& delays : all_delays) {
            if (counts_scans(type) && delays.rise > delays.fall) continue;
            cell.rise = delays.rise;
            cell.fall = delays.fall;
            for (const Spread& spread : spreads_of(type, delays)) {
                settings.push_back({cell, spread, delays.by_wheel});
            }
        }
    }
    return settings;
}

}  // namespace

TEST_CASE("every cell shows what an unknown input allows, and what its definition says") {
    for (const CellTypeRow& row : cell_table) {
        SUBCASE(std::string(row.name).c_str()) {
            Counts counts;
            // All of them, but for builds in which everything takes many times longer.
            const std::vector<Setting> settings = settings_of(row.type);
            CHECK(settings.size() >= all_delays.size());
            std::size_t tried = 0;
            for (std::size_t i = 0; i < settings.size(); i += is_slow_build ? 5 : 1) {
                examine(settings[i], counts);
                ++tried;
            }
            MESSAGE(row.name << ": " << counts.waveforms << " waveforms, " << counts.pairs
                             << " pairs, " << counts.known << " moments known, " << counts.needless
                             << " needlessly unknown");
            CHECK(counts.waveforms >= tried);
            if (!row.has_timing && !row.is_clocked) CHECK(counts.needless == 0);
        }
    }
}
