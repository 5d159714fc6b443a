#pragma once

#include "text/time.h"

namespace grafwire::testing {

/// An S5 timer of a SIMATIC S7, with a state that retentive memory may have left it in.
struct AwlS5Timer {
    bool last_rlo = true;  ///< at the last SE or SA
    bool runs = false;
    bool is_off_delay = false;
    bool elapsed = true;
    Time since = 0;
    Time length = 0;

    /// SE starts at a rise of the RLO and stops where it is 0; SA starts at a fall and stops where
    /// it is 1.
    void run(bool off_delay, bool rlo, Time loaded, Time now);
    void reset();
    bool status(Time now) const;
};

/// The instance of an SFB 4 (TON) or SFB 5 (TOF), likewise.
struct AwlIecTimer {
    bool runs = true;
    bool q = true;
    Time since = 0;

    void call(bool is_on_delay, bool in, Time pt, Time now);
};

}  // namespace grafwire::testing
