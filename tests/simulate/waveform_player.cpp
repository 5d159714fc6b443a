#include "waveform_player.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace grafwire::testing {

namespace {

constexpr Time apart = millisecond;

std::uint64_t bits(std::size_t from, std::size_t to) {
    std::uint64_t all = 0;
    for (std::size_t bit = from; bit < to; ++bit) all |= std::uint64_t{1} << bit;
    return all;
}

/// Adds the chain, and says what takes how long with it.
CellDelays with_chain(SmallNetlist& small, CellDelays delays, std::size_t length) {
    small.input("start");
    std::string last = "start";
    for (std::size_t i = 1; i < length; ++i) {
        const std::string beat = "beat" + std::to_string(i);
        small.cell(CellType::buffer, beat, {last});
        delays.rise.push_back(nanosecond);
        delays.fall.push_back(nanosecond);
        last = beat;
    }
    return delays;
}

std::vector<NetId> nets_of(const std::vector<Port>& ports) {
    std::vector<NetId> nets;
    for (const Port& port : ports) nets.push_back(port.net);
    return nets;
}

}  // namespace

std::string text_of(const Waveforms& waveforms) {
    std::string text;
    for (const InputRow& row : waveforms) {
        for (const Logic value : row) text += "01x"[static_cast<std::size_t>(value)];
        text += ' ';
    }
    return text;
}

std::size_t Spread::rows() const {
    return std::accumulate(positions.begin(), positions.end(), std::size_t{1});
}

WaveformPlayer::WaveformPlayer(SmallNetlist& small, CellDelays delays,
                               const std::vector<std::string>& watched, Spread spread)
    : spread_(std::move(spread)),
      inputs_(nets_of(small.netlist.inputs)),
      simulator_(small.netlist,
                 with_chain(small, std::move(delays),
                            *std::max_element(spread_.positions.begin(), spread_.positions.end()))),
      delay_ends_(small.netlist) {
    for (const std::string& name : watched) watched_.push_back(small.net(name));
    start_ = small.net("start");
    for (const Cell& cell : small.netlist.cells) {
        if (small.netlist.names[cell.output].starts_with("beat")) beats_.push_back(cell.output);
        if (row_of(cell.type).has_memory) held_.emplace_back(cell.output, cell.initial);
    }
    for (const Netlist::InitialValue& initial : small.netlist.initial_values) {
        held_.emplace_back(initial.net, initial.value ? one : zero);
    }
}

void WaveformPlayer::set_inputs(const InputRow& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) simulator_.set_input(inputs_[i], inputs[i]);
}

bool WaveformPlayer::come_to_rest(const InputRow& inputs) {
    simulator_.observe({});
    std::optional<Preparation> preparation(std::in_place, simulator_);
    simulator_.power_up();
    beat_ = zero;
    simulator_.set_input(start_, zero);
    set_inputs(inputs);
    for (const auto& [net, value] : held_) preparation->hold(net, value);
    if (!simulator_.settle().settled) return false;
    // The clocks have been what they are since always: no delay is running.
    SimulatorState state = simulator_.save();
    std::fill(state.due.begin(), state.due.end(), never);
    std::fill(state.towards.begin(), state.towards.end(), zero);
    simulator_.restore(state);
    simulator_.begin_instant(0);
    preparation->release();
    if (!simulator_.settle().settled) return false;
    preparation.reset();
    return simulator_.settle().settled;
}

void WaveformPlayer::play_instant(std::size_t first_row, std::size_t instant,
                                  const Waveforms& waveforms, Played& played) {
    const Time begin = static_cast<Time>(instant + 1) * apart;
    if (spread_.restored) simulator_.restore(simulator_.save());
    simulator_.begin_instant(begin);
    const std::size_t first_bit = instant * spread_.moments;
    std::vector<std::size_t> noted(watched_.size(), first_bit);
    std::vector<Logic> values;
    for (const NetId net : watched_) values.push_back(simulator_.value(net));
    // Notes the value that a net has had until before a moment.
    const auto note = [&](std::size_t i, std::size_t until) {
        const std::uint64_t held = bits(noted[i], until);
        if (values[i] != one) played.seen[i].zero |= held;
        if (values[i] != zero) played.seen[i].one |= held;
        noted[i] = std::max(noted[i], until);
    };
    simulator_.observe([&](Time at, NetId net, Logic value) {
        const auto moment = static_cast<std::size_t>((at - begin) / nanosecond);
        for (std::size_t i = 0; i < watched_.size(); ++i) {
            if (watched_[i] != net) continue;
            note(i, first_bit + std::min(moment, spread_.moments));
            values[i] = value;
        }
        const auto beat = std::find(beats_.begin(), beats_.end(), net);
        const auto position = static_cast<std::size_t>(beat - beats_.begin()) + 1;
        if (beat == beats_.end() || position >= spread_.positions[instant]) return;
        set_inputs(waveforms[first_row + position]);
    });
    set_inputs(waveforms[first_row]);
    beat_ = beat_ == one ? zero : one;
    simulator_.set_input(start_, beat_);
    if (spread_.delays_end) delay_ends_.take_effect(simulator_, begin);
    played.settled = simulator_.settle().settled;
    for (std::size_t i = 0; i < watched_.size(); ++i) note(i, first_bit + spread_.moments);
    simulator_.observe({});
}

WaveformPlayer::Played WaveformPlayer::play(const Waveforms& waveforms) {
    Played played;
    played.seen.resize(watched_.size());
    played.settled = come_to_rest(waveforms[0]);
    std::size_t row = 1;
    for (std::size_t instant = 0; instant < spread_.positions.size(); ++instant) {
        if (!played.settled) break;
        play_instant(row, instant, waveforms, played);
        row += spread_.positions[instant];
        ++played.instants;
    }
    for (const NetId net : watched_) played.at_rest.push_back(simulator_.value(net));
    return played;
}

}  // namespace grafwire::testing
