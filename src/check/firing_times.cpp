// From an order of firings to delays that bring it about.
//
// A gate that becomes excited at one firing and fires at a later one takes the time between the
// two; one that becomes quiet again before it fires would have taken longer. Where nothing bounds
// these times, the k-th firing of an instant takes place k units after its beginning. Where they
// are bounded, the moments of the firings solve a system of bounds on their differences, of which
// the shortest paths in a graph are a solution (R. Bellman, "On a routing problem", 1958).
//
// Since a simulation takes the delays that hold when a cell is evaluated, it is enough to say them
// anew at each moment at which a gate becomes excited.

#include "check/firing_times.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace grafwire {

namespace {

/// What a cell does between two firings of an instant; 0 stands for its beginning.
struct Span {
    enum class Kind : std::uint8_t {
        fires,     ///< it is excited at one, and fires at the other
        quietens,  ///< it becomes quiet there without having fired
        answers,   ///< a pulse cell sees an edge, and begins its pulse
        lasts,     ///< the pulse
    };
    Kind kind = Kind::fires;
    std::uint32_t cell = 0;
    bool to_one = false;  ///< what it fires, or would have fired to
    std::size_t from = 0;
    std::size_t to = 0;
};

/// Goes through the firings of an instant.
class SpanCollector {
  public:
    SpanCollector(const Circuit& circuit, const RacedInstant& instant)
        : circuit_(circuit), state_(instant.state), firings_(instant.firings) {
        // A turn that goes on for ever: its delays are those of the first time round.
        firings_.insert(firings_.end(), instant.turn.begin(), instant.turn.end());
    }

    std::vector<Span> collect() {
        note_edges(std::vector<std::uint8_t>(state_.unanswered.size()));
        note_excited();
        for (const Firing& firing : firings_) {
            ++now_;
            note_firing(firing);
            const std::vector<std::uint8_t> before = state_.unanswered;
            circuit_.perform(firing, state_);
            note_edges(before);
            note_excited();
        }
        return std::move(spans_);
    }

    const std::vector<Firing>& firings() const { return firings_; }

  private:
    struct Excited {
        std::size_t since = 0;
        bool to_one = false;
    };

    void note_firing(const Firing& firing) {
        for (const CellAction& action : firing) {
            if (action.kind == CellAction::Kind::answer) {
                std::vector<std::size_t>& edges = edges_[action.cell];
                spans_.push_back({Span::Kind::answers, action.cell, true, edges.front(), now_});
                edges.erase(edges.begin());
                begun_[action.cell] = now_;
            } else if (action.kind == CellAction::Kind::end_pulse) {
                spans_.push_back(
                    {Span::Kind::lasts, action.cell, false, begun_[action.cell], now_});
            } else if (const auto found = excited_.find(action.cell); found != excited_.end()) {
                spans_.push_back({Span::Kind::fires, action.cell, found->second.to_one,
                                  found->second.since, now_});
                excited_.erase(found);
            }
        }
    }

    /// Gates that have become excited by now, or quiet without having fired.
    void note_excited() {
        std::map<std::uint32_t, Excited> excited;
        for (const CellAction& action : circuit_.actions(state_)) {
            if (action.kind != CellAction::Kind::take) continue;
            const bool to_one = circuit_.asked(state_, action.cell) == Logic::one;
            const auto known = excited_.find(action.cell);
            excited[action.cell] = known != excited_.end() ? known->second : Excited{now_, to_one};
        }
        for (const auto& [cell, was] : excited_) {
            if (excited.contains(cell)) continue;
            spans_.push_back({Span::Kind::quietens, cell, was.to_one, was.since, now_});
        }
        excited_ = std::move(excited);
    }

    void note_edges(const std::vector<std::uint8_t>& before) {
        for (std::size_t pulse = 0; pulse < before.size(); ++pulse) {
            if (state_.unanswered[pulse] > before[pulse]) {
                edges_[circuit_.pulse_cell(pulse)].push_back(now_);
            }
        }
    }

    const Circuit& circuit_;
    CircuitState state_;
    std::vector<Firing> firings_;
    std::size_t now_ = 0;  ///< firings so far
    std::vector<Span> spans_;
    std::map<std::uint32_t, Excited> excited_;
    std::map<std::uint32_t, std::vector<std::size_t>> edges_;  ///< per pulse cell: to be answered
    std::map<std::uint32_t, std::size_t> begun_;               ///< per pulse cell: its last pulse
};

/// The moments of the firings of an instant, from its beginning.
class Moments {
  public:
    Moments(const Circuit& circuit, const std::vector<Firing>& firings,
            const std::vector<Span>& spans, const CellBands* bands)
        : circuit_(circuit),
          firings_(firings),
          spans_(spans),
          bands_(bands),
          at_(firings.size() + 1) {}

    bool find() {
        if (bands_ == nullptr) {
            for (std::size_t i = 1; i < at_.size(); ++i) {
                at_[i] = at_[i - 1] + (is_end(i) ? 0 : time_of_firing);
            }
            return true;
        }
        add_bounds();
        return solve();
    }

    Time operator[](std::size_t firing) const { return at_[firing]; }
    Time last() const { return *std::max_element(at_.begin(), at_.end()); }
    DelayBand band_of(const Span& span) const {
        const bool is_rise = span.kind == Span::Kind::answers || span.to_one;
        return (is_rise ? bands_->rise : bands_->fall)[span.cell];
    }

  private:
    /// The moment `later` is at most `most` after `earlier`.
    struct Bound {
        std::size_t later = 0;
        std::size_t earlier = 0;
        Time most = 0;
    };

    /// Delays of timers that end take no time of gates.
    bool is_end(std::size_t firing) const {
        return firings_[firing - 1][0].kind == CellAction::Kind::end_delay;
    }

    bool reads(std::uint32_t reader, std::uint32_t cell) const {
        const auto readers = circuit_.readers(circuit_.output(cell));
        return std::find(readers.begin(), readers.end(), reader) != readers.end();
    }
    bool have_common_reader(std::uint32_t a, std::uint32_t b) const {
        const auto readers = circuit_.readers(circuit_.output(a));
        return std::any_of(readers.begin(), readers.end(),
                           [&](std::uint32_t reader) { return reads(reader, b); });
    }
    /// Whether it makes a difference which of two firings comes first.
    bool are_ordered(const Firing& a, const Firing& b) const {
        for (const CellAction& x : a) {
            for (const CellAction& y : b) {
                const bool depend = x.cell == y.cell || reads(x.cell, y.cell) ||
                                    reads(y.cell, x.cell) || have_common_reader(x.cell, y.cell);
                if (depend) return true;
            }
        }
        return false;
    }

    void add_bounds() {
        for (std::size_t i = 1; i < at_.size(); ++i) {
            bounds_.push_back({0, i, 0});
            for (std::size_t j = 1; j < i; ++j) {
                const bool are_apart = is_end(i) || is_end(j);
                if (are_apart || are_ordered(firings_[j - 1], firings_[i - 1])) {
                    bounds_.push_back({j, i, 0});
                }
            }
        }
        for (const Span& span : spans_) {
            const DelayBand band = band_of(span);
            if (span.kind == Span::Kind::quietens) {
                bounds_.push_back({span.to, span.from, band.max - 1});
            } else {
                bounds_.push_back({span.to, span.from, band.max});
                bounds_.push_back({span.from, span.to, -band.min});
            }
        }
    }

    bool solve() {
        std::fill(at_.begin(), at_.end(), never / 2);
        at_[0] = 0;
        for (std::size_t round = 0; round <= at_.size(); ++round) {
            bool is_changed = false;
            for (const Bound& bound : bounds_) {
                const Time latest = at_[bound.earlier] + bound.most;
                if (latest >= at_[bound.later]) continue;
                at_[bound.later] = latest;
                is_changed = true;
            }
            if (!is_changed) return true;
        }
        return false;
    }

    const Circuit& circuit_;
    const std::vector<Firing>& firings_;
    const std::vector<Span>& spans_;
    const CellBands* bands_;
    std::vector<Time> at_;
    std::vector<Bound> bounds_;
};

bool append_delays(const Circuit& circuit, const RacedInstant& instant, const CellBands* bands,
                   DelaySchedule& schedule) {
    SpanCollector collector(circuit, instant);
    const std::vector<Span> spans = collector.collect();
    Moments moments(circuit, collector.firings(), spans, bands);
    if (!moments.find()) return false;
    const Time endless = moments.last() + 2 * time_of_firing;
    std::map<std::pair<std::uint32_t, std::size_t>, Time> widths;
    for (const Span& span : spans) {
        if (span.kind == Span::Kind::lasts) {
            widths[{span.cell, span.from}] = moments[span.to] - moments[span.from];
        }
    }
    for (const Span& span : spans) {
        if (span.kind == Span::Kind::lasts) continue;
        Time delay = moments[span.to] - moments[span.from];
        if (span.kind == Span::Kind::quietens) {
            delay = bands == nullptr ? endless : moments.band_of(span).max;
        }
        const auto width = widths.find({span.cell, span.to});
        const bool has_width = span.kind == Span::Kind::answers && bands == nullptr;
        // The other edge, which it does not take meanwhile, is as near to this as its bounds allow.
        const auto within = [&](const std::vector<DelayBand>& edge) {
            return std::clamp(delay, edge[span.cell].min, edge[span.cell].max);
        };
        const bool is_either = bands == nullptr || span.kind == Span::Kind::answers;
        const bool is_rise = is_either || span.to_one;
        const bool is_fall = is_either || !span.to_one;
        schedule.changes.push_back(
            {instant.begin + moments[span.from], static_cast<CellId>(span.cell),
             is_rise ? delay : within(bands->rise), is_fall ? delay : within(bands->fall),
             has_width ? (width == widths.end() ? endless : width->second) : 0});
    }
    return true;
}

}  // namespace

std::optional<DelaySchedule> delays_for(const Circuit& circuit,
                                        const std::vector<RacedInstant>& instants,
                                        const CellBands* bands) {
    DelaySchedule schedule;
    for (const RacedInstant& instant : instants) {
        if (!append_delays(circuit, instant, bands, schedule)) return std::nullopt;
    }
    std::stable_sort(schedule.changes.begin(), schedule.changes.end(),
                     [](const DelayChange& a, const DelayChange& b) {
                         return std::tie(a.at, a.cell) < std::tie(b.at, b.cell);
                     });
    return schedule;
}

}  // namespace grafwire
