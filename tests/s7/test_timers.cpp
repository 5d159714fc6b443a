// Timers and counters.

#include <doctest/doctest.h>

#include "s7/addresses/cpu.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

TEST_CASE("the ticks of the timers") {
    CHECK(timer_kind(0) == TimerKind{millisecond, true});
    CHECK(timer_kind(4) == TimerKind{10 * millisecond, true});
    CHECK(timer_kind(31) == TimerKind{100 * millisecond, true});
    CHECK(timer_kind(32) == TimerKind{millisecond, false});
    CHECK(timer_kind(33) == TimerKind{10 * millisecond, false});
    CHECK(timer_kind(36) == TimerKind{10 * millisecond, false});
    CHECK(timer_kind(37) == TimerKind{100 * millisecond, false});
    CHECK(timer_kind(64) == TimerKind{millisecond, true});
    CHECK(timer_kind(96) == TimerKind{millisecond, false});
    CHECK(timer_kind(97) == TimerKind{10 * millisecond, false});
    CHECK(timer_kind(127) == TimerKind{100 * millisecond, false});
}

TEST_CASE("TON counts whole ticks from the scan that enables it") {
    Controller plc("NETWORK1\nLD E0.0\nTON T37 K3\nLD T37\n= A0.0\nMOVW T37 VW10\nMEND\n");
    plc.scan();
    plc.set("E0.0", true);
    plc.scan(35 * millisecond);
    std::vector<bool> seen;
    for (int i = 0; i < 10; ++i) {
        plc.scan(35 * millisecond);
        seen.push_back(plc.bit("A0.0"));
        CHECK(plc.value("T37") == (i + 1) * 35 / 100);
    }
    // 9 · 35 ms are the first to reach 300 ms.
    CHECK(seen == std::vector<bool>{0, 0, 0, 0, 0, 0, 0, 0, 1, 1});
    plc.set("E0.0", false);
    plc.scan();
    CHECK_FALSE(plc.bit("A0.0"));
    CHECK(plc.value("T37") == 0);
}

TEST_CASE("a timer that is not executed does not count on, but time passes") {
    Controller plc(R"(NETWORK1
LD E0.1
JMP K0
LD SM0.0
TON T33 K5
LBL K0
LD T33
= A0.0
MEND
)");
    plc.scan();
    plc.set("E0.1", true);
    plc.scan(100 * millisecond);
    CHECK_FALSE(plc.bit("A0.0"));
    plc.set("E0.1", false);
    plc.scan();
    CHECK(plc.bit("A0.0"));
}

TEST_CASE("R begins a timer anew") {
    Controller plc("NETWORK1\nLD E0.0\nR T32 K1\nLD SM0.0\nTON T32 K20\nLD T32\n= A0.0\nMEND\n");
    plc.scan();
    plc.scan(20 * millisecond);
    CHECK(plc.bit("A0.0"));
    plc.set("E0.0", true);
    plc.scan();
    CHECK_FALSE(plc.bit("A0.0"));
    plc.set("E0.0", false);
    plc.scan(19 * millisecond);
    CHECK_FALSE(plc.bit("A0.0"));
    plc.scan(1 * millisecond);
    CHECK(plc.bit("A0.0"));
}

TEST_CASE("TONR keeps what it has counted") {
    Controller plc("NETWORK1\nLD E0.0\nTONR T1 K5\nLD T1\n= A0.0\nMEND\n");
    plc.set("E0.0", true);
    plc.scan();
    plc.scan(30 * millisecond);
    plc.set("E0.0", false);
    plc.scan(0);
    plc.scan(500 * millisecond);
    CHECK_FALSE(plc.bit("A0.0"));
    plc.set("E0.0", true);
    plc.scan();
    plc.scan(20 * millisecond);
    CHECK(plc.bit("A0.0"));
}

TEST_CASE("a state does not grow older once a timer has reached its preset") {
    Controller plc("NETWORK1\nLD SM0.0\nTON T37 K3\nLD T37\n= A0.0\nMEND\n");
    for (int i = 0; i < 4; ++i) plc.scan(100 * millisecond);
    const auto timers = plc.state.timers;
    plc.scan(5 * second);
    CHECK(plc.state.timers == timers);
    CHECK(plc.machine.delays() == std::vector<Time>{100 * millisecond, 300 * millisecond});
}

TEST_CASE("counters count rising edges") {
    Controller plc(R"(NETWORK1
LD E0.0
LD E0.1
LD E0.2
CTUD Z0 K2
LD E0.0
LD E0.2
CTU Z1 K2
LD Z0
= A0.0
LD Z1
= A0.1
MEND
)");
    const auto pulse = [&](const std::string& input) {
        plc.set(input, true);
        plc.scan();
        plc.scan();
        plc.set(input, false);
        plc.scan();
    };
    pulse("E0.0");
    CHECK(plc.value("Z0") == 1);
    CHECK_FALSE(plc.bit("A0.1"));
    pulse("E0.0");
    pulse("E0.0");
    CHECK(plc.value("Z0") == 3);
    CHECK(plc.value("Z1") == 3);
    CHECK(plc.bit("A0.0"));
    CHECK(plc.bit("A0.1"));
    pulse("E0.1");
    pulse("E0.1");
    CHECK(plc.value("Z0") == 1);
    CHECK_FALSE(plc.bit("A0.0"));
    pulse("E0.2");
    CHECK(plc.value("Z0") == 0);
    CHECK(plc.value("Z1") == 0);
}

}  // namespace grafwire::testing
