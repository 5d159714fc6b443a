#include "plc/bit_runs.h"

namespace grafwire {

namespace {

bool is_in_table(BitKind kind) {
    switch (kind) {
        case BitKind::step:
        case BitKind::previous:
        case BitKind::activate:
        case BitKind::deactivate:
        case BitKind::forced_on:
        case BitKind::forced_off:
        case BitKind::may_evolve:
            return true;
        default:
            return false;
    }
}

}  // namespace

std::vector<BitRun> bit_runs(std::span<const Bit> bits) {
    constexpr std::uint32_t worth_a_loop = 4;
    std::vector<BitRun> runs;
    for (std::size_t at = 0; at < bits.size();) {
        std::uint32_t count = 1;
        while (is_in_table(bits[at].kind) && at + count < bits.size() &&
               bits[at + count] == Bit{bits[at].kind, bits[at].index + count}) {
            ++count;
        }
        if (count < worth_a_loop) count = 1;
        runs.push_back({bits[at], count});
        at += count;
    }
    return runs;
}

}  // namespace grafwire
