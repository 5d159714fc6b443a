#include "grafcet/sum_range.h"

#include <algorithm>
#include <limits>

namespace grafwire {

std::optional<IntegerRange> range_of(const Grafcet& grafcet, const Sum& sum) {
    IntegerRange reached;  // by any partial sum; the empty one is 0
    std::int64_t low = 0;
    std::int64_t high = 0;
    for (const SumTerm& term : sum) {
        std::int64_t from = term.value;
        std::int64_t to = term.value;
        if (term.counter != SumTerm::no_counter) {
            from = grafcet.counters[CounterId{term.counter}].low;
            to = grafcet.counters[CounterId{term.counter}].high;
        }
        if (term.negative) {
            if (from == std::numeric_limits<std::int64_t>::min()) return std::nullopt;
            std::swap(from, to);
            from = -from;
            to = -to;
        }
        if (__builtin_add_overflow(low, from, &low) || __builtin_add_overflow(high, to, &high)) {
            return std::nullopt;
        }
        reached.low = std::min(reached.low, low);
        reached.high = std::max(reached.high, high);
    }
    return reached;
}

IntegerRange value_range(const Grafcet& grafcet, const Sum& sum) {
    IntegerRange range;
    for (const SumTerm& term : sum) {
        IntegerRange part{term.value, term.value};
        if (term.counter != SumTerm::no_counter) {
            const Counter& counter = grafcet.counters[CounterId{term.counter}];
            part = {counter.low, counter.high};
        }
        if (term.negative) part = {-part.high, -part.low};
        range.low += part.low;
        range.high += part.high;
    }
    return range;
}

}  // namespace grafwire
