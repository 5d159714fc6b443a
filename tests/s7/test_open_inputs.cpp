// Scans with open inputs, and the bits that are alive at the start of a scan, on random listings:
// what a scan knows in spite of open inputs it gives for every completion of them, and what is not
// alive makes no difference.

#include <doctest/doctest.h>

#include "random/random_source.h"
#include "s7/random_listing.h"
#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

InputImage random_image(RandomSource& random) {
    InputImage image;
    for (std::uint8_t& byte : image.value) byte = static_cast<std::uint8_t>(random.below(256));
    return image;
}

/// The first two bytes partly open.
InputImage partly_open(InputImage image, RandomSource& random) {
    for (std::size_t i = 0; i < 2; ++i) {
        image.known[i] = static_cast<std::uint8_t>(random.below(256) | random.below(256));
        image.value[i] = static_cast<std::uint8_t>(image.value[i] & image.known[i]);
    }
    return image;
}

Operand bit_of(Area area, std::int32_t address, std::uint8_t bit) {
    Operand operand;
    operand.area = area;
    operand.address = address;
    operand.bit = bit;
    return operand;
}

/// A few scans, so that the memory holds something.
MachineState warmed_up(Machine& machine, RandomSource& random, Time& now) {
    MachineState state = machine.start();
    for (std::size_t scan = random.below(4); scan > 0; --scan) {
        REQUIRE(machine.scan(state, random_image(random), now).is_done());
        now += 70 * millisecond;
    }
    return state;
}

constexpr Area areas[] = {Area::output, Area::variable, Area::memento};

}  // namespace

TEST_CASE("what is known with open inputs holds for all their values") {
    std::size_t done = 0;
    std::size_t unknown = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
        CAPTURE(seed);
        const Listing listing = random_listing(seed);
        Machine machine(listing, Cpu::cpu_214);
        Machine closed(listing, Cpu::cpu_214);
        RandomSource random(seed);
        Time now = 0;
        const MachineState before = warmed_up(machine, random, now);
        const InputImage open = partly_open(random_image(random), random);
        MachineState after = before;
        const Machine::ScanEnd end = machine.scan(after, open, now);
        REQUIRE_FALSE(end.error);
        const auto is_open = [&](std::uint32_t input) {
            return input < 16 && (open.known[input / 8] >> (input % 8) & 1U) == 0;
        };
        if (end.needs) {
            CHECK(is_open(*end.needs));
            continue;
        }
        ++done;
        for (int completion = 0; completion < 8; ++completion) {
            InputImage image = open;
            for (std::size_t i = 0; i < 2; ++i) {
                image.value[i] = static_cast<std::uint8_t>(
                    open.value[i] | (random.below(256) & static_cast<std::size_t>(~open.known[i])));
                image.known[i] = 0xff;
            }
            MachineState other = before;
            REQUIRE(closed.scan(other, image, now).is_done());
            CHECK(other.timers == after.timers);
            CHECK(other.counters == after.counters);
            CHECK(other.edges == after.edges);
            for (const Area area : areas) {
                for (std::int32_t byte = 0; byte < 8; ++byte) {
                    for (std::uint8_t bit = 0; bit < 8; ++bit) {
                        const Operand place = bit_of(area, byte, bit);
                        const s7::Signal seen = machine.bit(after, place);
                        if (!seen.is_known()) {
                            ++unknown;
                            CHECK(is_open(seen.cause));
                        } else if (seen.value != closed.bit(other, place).value) {
                            FAIL_CHECK(write_listing(listing, {}));
                        }
                    }
                }
            }
        }
    }
    CHECK(done > 300);
    CHECK(unknown > 200);
}

TEST_CASE("bits that are not alive make no difference") {
    std::size_t dead = 0;
    for (std::uint64_t seed = 5001; seed <= 6500; ++seed) {
        CAPTURE(seed);
        const Listing listing = random_listing(seed);
        Machine machine(listing, Cpu::cpu_214);
        RandomSource random(seed);
        std::vector<Operand> observed;
        for (std::uint8_t bit = 0; bit < 8; ++bit) {
            observed.push_back(bit_of(Area::output, 0, bit));
            observed.push_back(bit_of(Area::variable, 2, bit));
        }
        const auto live = machine.live_at_start(observed);
        Time now = 0;
        MachineState one = warmed_up(machine, random, now);
        MachineState other = one;
        for (std::size_t i = 0; i < live.size(); ++i) {
            const auto flipped = static_cast<std::uint8_t>(random.below(256) & ~live[i] & 0xffU);
            dead += flipped != 0 ? 1 : 0;
            other.memory[i] = static_cast<std::uint8_t>(other.memory[i] ^ flipped);
        }
        for (int scan = 0; scan < 3; ++scan) {
            const InputImage image = random_image(random);
            REQUIRE(machine.scan(one, image, now).is_done());
            std::vector<bool> seen;
            for (const Operand& place : observed) seen.push_back(machine.bit(one, place).is_one());
            REQUIRE(machine.scan(other, image, now).is_done());
            for (std::size_t i = 0; i < observed.size(); ++i) {
                if (machine.bit(other, observed[i]).is_one() != seen[i]) {
                    FAIL_CHECK(write_listing(listing, {}));
                }
            }
            CHECK(one.timers == other.timers);
            CHECK(one.edges == other.edges);
            now += 70 * millisecond;
        }
    }
    CHECK(dead > 100'000);
}

}  // namespace grafwire::testing
