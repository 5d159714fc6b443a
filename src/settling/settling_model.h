#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "settling/circuit.h"
#include "text/keep_going.h"

namespace grafwire {

/// Gates that change at one moment; mostly a single one.
using Firing = std::vector<CellAction>;

/// One thing that can become of a netlist within an instant.
struct Rest {
    enum class Kind : std::uint8_t {
        settles,
        oscillates,  ///< never comes to rest, although every gate takes a finite time
    };
    Kind kind = Kind::settles;
    CircuitState state;           ///< settles: at the end; what cannot be told is unknown
    std::vector<NetId> changing;  ///< oscillates: the nets that keep changing
    /// What leads there from the start, one after the other; only if it was asked for, and the
    /// model knows. Oscillates: then the firings of one turn, after which all is as before.
    std::vector<Firing> firings;
    std::vector<Firing> turn;
};

/// The nets that some firings change, each once and in order.
class ChangedNets {
  public:
    explicit ChangedNets(const Circuit& circuit) : circuit_(circuit) {}
    void add(const Firing& firing);
    std::vector<NetId> take();

  private:
    const Circuit& circuit_;
    std::vector<NetId> nets_;
};

/// All that can become of a netlist within an instant.
struct Rests {
    std::vector<Rest> rests;    ///< never empty where the search was complete
    bool broken_off = false;    ///< the caller said so
    bool is_too_large = false;  ///< there are more orders than are gone through; the rests are some
    std::size_t states = 0;     ///< that were gone through
};

/// A net, and how often it may change within an instant.
struct WatchedNet {
    NetId net = no_net;
    std::uint8_t most = 0;

    /// How often it has changed after a firing, if it had `before`.
    std::uint8_t count(std::uint8_t before, const CircuitState& from,
                       const CircuitState& to) const {
        const bool changes = from.values[index_of(net)] != to.values[index_of(net)];
        return static_cast<std::uint8_t>(before + (changes ? 1 : 0));
    }
};

/// Whether a net can change more often than it may.
struct Pulsing {
    enum class Answer : std::uint8_t {
        never,  ///< whatever the gates do, as far as the delay model lets them
        shown,  ///< with these firings
        open,   ///< there are more orders than are gone through, or the caller said so
    };
    Answer answer = Answer::open;
    std::vector<Firing> firings;  ///< from the start until everything rests
};

/// What is known of the delays of gates, as a question: from a state on, what can happen? A row of
/// the delay models that leaves delays open (delay_model.h) is a class of its own behind this.
class SettlingModel {
  public:
    virtual ~SettlingModel() = default;

    /// From a state whose inputs have just changed. `with_firings`: tell how each rest comes about.
    /// `most_states`: how many are gone through before the search is given up.
    virtual Rests settle(const CircuitState& start, bool with_firings, std::size_t most_states) = 0;

    /// From such a state, of which everything is known and after which all comes to rest: whether a
    /// net can change too often on the way.
    virtual Pulsing pulsing(const CircuitState& start, const WatchedNet& watched,
                            std::size_t most_states) = 0;

    /// Enough for nearly everything that can be answered at all.
    static constexpr std::size_t usual_states = 100'000;
    /// How many are worth going through before a case is left open.
    virtual std::size_t most_states() const { return usual_states; }
};

/// The model for a circuit, which must outlive it; nothing for delays that are fixed (the simulator
/// plays these). `keep_going` is asked often.
std::unique_ptr<SettlingModel> make_settling_model(const DelayModel& model, const Circuit& circuit,
                                                   KeepGoing keep_going);

}  // namespace grafwire
