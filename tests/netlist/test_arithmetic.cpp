// Words of gates against whole numbers: every pair of small counters, random sums.

#include <doctest/doctest.h>

#include <algorithm>

#include "netlist/styles/arithmetic.h"
#include "random/random_source.h"

namespace grafwire::testing {

namespace {

/// Counters as input words, and what has been computed from them by gates.
struct Bench {
    NetlistBuilder builder{"arithmetic", InnerNames::by_role};
    GateMaker gates{builder, {builder.add_module("arithmetic"), 0}, "test"};
    std::vector<Word> counters;
    Netlist netlist;
    std::vector<bool> values;

    explicit Bench(const std::vector<std::size_t>& widths) {
        for (const std::size_t width : widths) {
            Word word;
            for (std::size_t bit = 0; bit < width; ++bit) {
                const std::string name =
                    "c" + std::to_string(counters.size()) + "_" + std::to_string(bit);
                word.push_back(builder.add_net(name));
                builder.add_input(name, word.back());
            }
            counters.push_back(word);
        }
    }
    void finish() {
        netlist = builder.finish();
        REQUIRE(fault_of(netlist) == "");
    }
    /// Gives the counters values and computes all gates, which stand in the order of data flow.
    void apply(const std::vector<std::int64_t>& numbers) {
        values.assign(netlist.net_count(), false);
        for (std::size_t i = 0; i < counters.size(); ++i) {
            for (std::size_t bit = 0; bit < counters[i].size(); ++bit) {
                values[index_of(counters[i][bit])] = (numbers[i] >> bit & 1) != 0;
            }
        }
        for (const Cell& cell : netlist.cells) values[index_of(cell.output)] = compute(cell);
    }
    bool compute(const Cell& cell) const {
        const auto pins = netlist.pins_of(cell);
        const auto is_one = [&](NetId net) { return values[index_of(net)]; };
        switch (cell.type) {
            case CellType::high:
                return true;
            case CellType::inverter:
                return !is_one(pins[0]);
            case CellType::buffer:
                return is_one(pins[0]);
            case CellType::and_gate:
                return std::all_of(pins.begin(), pins.end(), is_one);
            case CellType::or_gate:
                return std::any_of(pins.begin(), pins.end(), is_one);
            case CellType::xor_gate:
                return std::count_if(pins.begin(), pins.end(), is_one) % 2 == 1;
            default:
                return false;
        }
    }
    std::int64_t number(const Word& word) const {
        std::int64_t result = values[index_of(word.back())] ? -1 : 0;
        for (std::size_t i = word.size(); i-- != 0;) {
            result = result * 2 + (values[index_of(word[i])] ? 1 : 0);
        }
        return result;
    }
};

std::int64_t expected_sum(const Sum& terms, const std::vector<std::int64_t>& numbers) {
    std::int64_t total = 0;
    for (const SumTerm& term : terms) {
        const std::int64_t value =
            term.counter == SumTerm::no_counter ? term.value : numbers[term.counter];
        total += term.negative ? -value : value;
    }
    return total;
}

}  // namespace

TEST_CASE("comparisons of all small numbers") {
    Bench bench({4, 3});
    Arithmetic arithmetic(bench.gates);
    std::vector<NetId> results;
    for (int relation = 0; relation < 6; ++relation) {
        results.push_back(arithmetic.compare(bench.counters[0], static_cast<Relation>(relation),
                                             bench.counters[1]));
    }
    bench.finish();
    for (std::int64_t a = -8; a < 8; ++a) {
        for (std::int64_t b = -4; b < 4; ++b) {
            bench.apply({a, b});
            const bool expected[] = {a == b, a != b, a<b, a <= b, a> b, a >= b};
            for (std::size_t i = 0; i < 6; ++i) {
                CHECK(bench.values[index_of(results[i])] == expected[i]);
            }
        }
    }
}

TEST_CASE("random sums are the sums of whole numbers") {
    RandomSource random(1);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::size_t> widths;
        for (std::size_t i = random.between(1, 3); i != 0; --i) {
            widths.push_back(random.between(1, 6));
        }
        Bench bench(widths);
        Sum terms;
        for (std::size_t i = random.between(1, 5); i != 0; --i) {
            const bool is_number = random.one_in(3);
            terms.push_back({random.flip(),
                             is_number ? SumTerm::no_counter
                                       : static_cast<std::uint32_t>(random.below(widths.size())),
                             is_number ? static_cast<std::int64_t>(random.below(20)) : 0});
        }
        Arithmetic arithmetic(bench.gates);
        const Word sum = arithmetic.sum(terms, bench.counters);
        const NetId chooser = bench.counters[0][0];
        const Word chosen = arithmetic.choose(chooser, sum, bench.counters[0]);
        const NetId is_zero = arithmetic.is_zero(sum);
        bench.finish();
        for (int sample = 0; sample < 20; ++sample) {
            std::vector<std::int64_t> numbers;
            for (const std::size_t width : widths) {
                const auto range = std::size_t{1} << width;
                numbers.push_back(static_cast<std::int64_t>(random.below(range)) -
                                  static_cast<std::int64_t>(range / 2));
            }
            bench.apply(numbers);
            const std::int64_t expected = expected_sum(terms, numbers);
            CHECK(bench.number(sum) == expected);
            CHECK(bench.values[index_of(arithmetic.is_negative(sum))] == (expected < 0));
            CHECK(bench.values[index_of(is_zero)] == (expected == 0));
            CHECK(bench.number(chosen) == ((numbers[0] & 1) != 0 ? expected : numbers[0]));
        }
    }
}

TEST_CASE("the widest numbers do not overflow") {
    Bench bench({1});
    Arithmetic arithmetic(bench.gates);
    const std::int64_t largest = INT64_MAX;
    const Word a =
        arithmetic.sum({{false, SumTerm::no_counter, largest}, {false, 0, 0}}, {bench.counters});
    const Word b = arithmetic.sum({{true, SumTerm::no_counter, largest}}, bench.counters);
    const NetId greater = arithmetic.compare(a, Relation::greater, b);
    bench.finish();
    bench.apply({0});
    CHECK(bench.values[index_of(greater)]);
    CHECK(bench.number(Word(a.begin(), a.end())) == largest);
    bench.apply({-1});
    CHECK(bench.values[index_of(greater)]);
    CHECK(bench.number(Word(b.begin(), b.end())) == -largest);
}

}  // namespace grafwire::testing
