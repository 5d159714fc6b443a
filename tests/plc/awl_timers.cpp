#include "plc/awl_timers.h"

namespace grafwire::testing {

void AwlS5Timer::run(bool off_delay, bool rlo, Time loaded, Time now) {
    const bool starts = off_delay ? last_rlo && !rlo : !last_rlo && rlo;
    if (starts) {
        runs = true;
        elapsed = false;
        since = now;
        length = loaded;
    } else if (rlo == off_delay) {
        runs = false;
        elapsed = false;
    }
    is_off_delay = off_delay;
    last_rlo = rlo;
}

void AwlS5Timer::reset() {
    runs = elapsed = last_rlo = false;
}

bool AwlS5Timer::status(Time now) const {
    const bool over = runs && now - since >= length;
    if (is_off_delay) return last_rlo || (runs && !over);
    return last_rlo && (elapsed || over);
}

void AwlIecTimer::call(bool is_on_delay, bool in, Time pt, Time now) {
    if (in != is_on_delay) {  // at rest
        q = !is_on_delay;
        runs = false;
        return;
    }
    if (!runs && q != is_on_delay) {
        runs = true;
        since = now;
    }
    if (runs && now - since >= pt) {
        q = is_on_delay;
        runs = false;
    }
}

}  // namespace grafwire::testing
