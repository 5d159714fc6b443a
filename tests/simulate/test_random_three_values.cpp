#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "waveform_player.h"

using namespace grafwire;
using namespace grafwire::testing;

// As test_three_values.cpp, for small random netlists of all types of cells, with feedback: every
// net, at every nanosecond, when the inputs are known, against the simulation in which some of them
// are unknown now and then.

namespace {

struct RandomNetlist {
    SmallNetlist small;
    CellDelays delays;
    std::vector<std::string> cells;
};

class Maker {
  public:
    explicit Maker(std::mt19937& random) : random_(random) {}

    RandomNetlist make() {
        const std::size_t inputs = 1 + below(3);
        const std::size_t cells = 2 + below(9);
        const bool uniform = below(2) == 0;
        for (std::size_t i = 0; i < inputs; ++i) {
            nets_.push_back("i" + std::to_string(i));
            made_.small.input(nets_.back());
        }
        for (std::size_t i = 0; i < cells; ++i) {
            made_.cells.push_back("g" + std::to_string(i));
            nets_.push_back(made_.cells.back());
        }
        for (std::size_t i = 0; i < cells; ++i) {
            add_cell(made_.cells[i], inputs + i);
            for (std::vector<Time>* delays : {&made_.delays.rise, &made_.delays.fall}) {
                delays->push_back(uniform ? nanosecond : some(4) * nanosecond);
            }
        }
        return std::move(made_);
    }

  private:
    std::size_t below(std::size_t bound) { return random_() % bound; }
    Time some(std::size_t most) { return static_cast<Time>(1 + below(most)); }

    void add_cell(const std::string& name, std::size_t before) {
        const CellTypeRow& row = cell_table[below(cell_table.size())];
        const std::size_t count = std::clamp<std::size_t>(1 + below(3), row.min_pins, row.max_pins);
        std::vector<std::string> pins;
        for (std::size_t i = 0; i < count; ++i) {
            // Mostly forward, so that many netlists settle.
            pins.push_back(nets_[below(below(3) == 0 ? nets_.size() : before)]);
        }
        Timing timing{0, some(8) * nanosecond, 0};
        if (is_timer(row.type)) {
            timing.rise = static_cast<Time>(below(3)) * millisecond;
            timing.fall = static_cast<Time>(below(3)) * millisecond;
        }
        const bool initial = below(2) == 0;
        made_.small.timed(row.type, name, pins, timing, initial ? one : zero);
        const bool is_pulse = row.type == CellType::rise_pulse || row.type == CellType::fall_pulse;
        if (!row.has_memory && !is_pulse) made_.small.starts_at(name, initial);
    }

    std::mt19937& random_;
    RandomNetlist made_;
    std::vector<std::string> nets_;
};

Waveforms random_waveforms(std::mt19937& random, std::size_t inputs, std::size_t rows) {
    Waveforms waveforms(rows, InputRow(inputs));
    for (std::size_t i = 0; i < inputs; ++i) {
        Logic value = all_values[random() % 3];
        for (InputRow& row : waveforms) {
            if (random() % 2 == 0) value = all_values[random() % 3];
            row[i] = value;
        }
    }
    return waveforms;
}

Waveforms random_fill(std::mt19937& random, Waveforms waveforms) {
    for (InputRow& row : waveforms) {
        for (Logic& value : row) {
            if (value == unknown) value = random() % 2 == 0 ? zero : one;
        }
    }
    return waveforms;
}

Spread random_spread(std::mt19937& random) {
    static const std::vector<std::size_t> choices[] = {{6}, {2, 4}, {1, 3, 2}, {1, 1, 1, 1}};
    Spread spread;
    spread.positions = choices[random() % std::size(choices)];
    spread.moments = 64 / std::max<std::size_t>(2, spread.positions.size());
    spread.delays_end = random() % 2 == 0;
    spread.restored = random() % 2 == 0;
    return spread;
}

std::uint64_t bits_of(std::size_t count) {
    return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// "g1 = latch i0 g2, 1 ns 3 ns" and so on.
std::string netlist_text(const RandomNetlist& made) {
    std::string text;
    const Netlist& netlist = made.small.netlist;
    for (std::size_t i = 0; i < made.cells.size(); ++i) {
        const Cell& cell = netlist.cells[netlist.cells.id_at(i)];
        text += made.cells[i] + " = " + std::string(row_of(cell.type).name);
        for (const NetId pin : netlist.pins_of(cell)) {
            text += ' ' + std::string(netlist.names[pin]);
        }
        for (const Time time :
             {made.delays.rise[i], made.delays.fall[i], netlist.timings[cell.timing].rise,
              netlist.timings[cell.timing].fall}) {
            text += ", " + std::to_string(time / nanosecond);
        }
        text += cell.initial == one ? " ns from 1\n" : " ns from 0\n";
    }
    return text;
}

}  // namespace

TEST_CASE("random netlists show what their unknown inputs allow") {
    std::mt19937 random(1960);
    std::size_t pairs = 0;
    std::size_t known = 0;
    std::size_t settled = 0;
    std::size_t oscillations = 0;
    for (int round = 0; round < 20000; ++round) {
        CAPTURE(round);
        RandomNetlist made = Maker(random).make();
        const std::size_t inputs = made.small.netlist.inputs.size();
        const Spread spread = random_spread(random);
        WaveformPlayer player(made.small, made.delays, made.cells, spread);
        for (int waveform = 0; waveform < 6; ++waveform) {
            const Waveforms waveforms = random_waveforms(random, inputs, spread.rows());
            const WaveformPlayer::Played in_three = player.play(waveforms);
            for (int instance = 0; instance < 6; ++instance) {
                const Waveforms fill = random_fill(random, waveforms);
                const WaveformPlayer::Played in_two = player.play(fill);
                const std::size_t instants = std::min(in_three.instants, in_two.instants);
                const std::uint64_t seen = bits_of(instants * spread.moments);
                const bool is_known =
                    std::none_of(in_two.seen.begin(), in_two.seen.end(),
                                 [](const Seen& net) { return (net.zero & net.one) != 0; });
                REQUIRE(is_known);
                ++pairs;
                settled += static_cast<std::size_t>(in_two.settled && in_three.settled);
                oscillations += static_cast<std::size_t>(!in_two.settled);
                for (std::size_t net = 0; net < made.cells.size(); ++net) {
                    const Seen three = in_three.seen[net];
                    const Seen two{in_two.seen[net].zero & seen, in_two.seen[net].one & seen};
                    known += static_cast<std::size_t>((three.zero & three.one & seen) == 0);
                    const bool rests = in_two.settled && in_three.settled;
                    const bool ends_right = !rests || in_three.at_rest[net] == unknown ||
                                            in_three.at_rest[net] == in_two.at_rest[net];
                    if (three.allows(two) && ends_right) continue;
                    INFO(netlist_text(made) << made.cells[net] << ": " << text_of(waveforms)
                                            << "against " << text_of(fill));
                    CHECK(in_three.seen[net].zero == (three.zero | two.zero));
                    CHECK(in_three.seen[net].one == (three.one | two.one));
                    FAIL("not allowed");
                }
            }
        }
    }
    MESSAGE(pairs << " pairs of runs, " << settled << " settled, " << oscillations << " oscillate, "
                  << known << " nets known throughout");
    CHECK(settled > pairs / 2);
    CHECK(oscillations > pairs / 20);
    CHECK(known > pairs);
}
