#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <string>

#include "logic/logic.h"

using namespace grafwire;

namespace {

constexpr std::array all{Logic::zero, Logic::one, Logic::unknown};

/// Row by row, the left operand down and the right one across.
std::string table_of(const std::function<Logic(Logic, Logic)>& operation) {
    std::string table;
    for (const Logic a : all) {
        if (!table.empty()) table += ' ';
        for (const Logic b : all) table += digit_of(operation(a, b));
    }
    return table;
}

/// What all choices for the unknown operands agree on.
Logic by_completion(Logic a, Logic b, const std::function<bool(bool, bool)>& operation) {
    std::array<bool, 2> possible{};
    for (const bool left : {false, true}) {
        for (const bool right : {false, true}) {
            const bool fits = (a == Logic::unknown || a == logic_of(left)) &&
                              (b == Logic::unknown || b == logic_of(right));
            if (fits) possible[operation(left, right) ? 1 : 0] = true;
        }
    }
    if (possible[0] && possible[1]) return Logic::unknown;
    return logic_of(possible[1]);
}

/// Bits of a word as values: bit i is `values[i]`.
LogicWord word_of(const std::array<Logic, 9>& values) {
    LogicWord word;
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        if (values[i] == Logic::one) word.value |= 1U << i;
        if (values[i] == Logic::unknown) word.known &= ~(1U << i);
    }
    return word;
}

std::string digits_of(const LogicWord& word) {
    std::string digits;
    for (std::uint32_t i = 0; i < 9; ++i) {
        const bool is_known = (word.known >> i & 1U) != 0;
        const bool value = (word.value >> i & 1U) != 0;
        digits += digit_of(is_known ? logic_of(value) : Logic::unknown);
        CHECK((is_known || !value));
        if (i % 3 == 2 && i != 8) digits += ' ';
    }
    return digits;
}

}  // namespace

TEST_CASE("the truth tables of three values") {
    CHECK(~Logic::zero == Logic::one);
    CHECK(~Logic::one == Logic::zero);
    CHECK(~Logic::unknown == Logic::unknown);
    CHECK(table_of([](Logic a, Logic b) { return a & b; }) == "000 01x 0xx");
    CHECK(table_of([](Logic a, Logic b) { return a | b; }) == "01x 111 x1x");
    CHECK(table_of([](Logic a, Logic b) { return a ^ b; }) == "01x 10x xxx");
    CHECK(table_of([](Logic a, Logic b) { return agreed(a, b); }) == "0xx x1x xxx");
}

TEST_CASE("a result is known where all choices for unknown operands agree") {
    for (const Logic a : all) {
        for (const Logic b : all) {
            CHECK((a & b) == by_completion(a, b, std::logical_and<bool>()));
            CHECK((a | b) == by_completion(a, b, std::logical_or<bool>()));
            CHECK((a ^ b) == by_completion(a, b, std::not_equal_to<bool>()));
        }
    }
}

TEST_CASE("a word has the truth tables bit by bit") {
    std::array<Logic, 9> left{};
    std::array<Logic, 9> right{};
    for (std::size_t i = 0; i < 9; ++i) {
        left[i] = all[i / 3];
        right[i] = all[i % 3];
    }
    const LogicWord a = word_of(left);
    const LogicWord b = word_of(right);
    CHECK(digits_of(~b) == "10x 10x 10x");
    CHECK(digits_of(a & b) == "000 01x 0xx");
    CHECK(digits_of(a | b) == "01x 111 x1x");
    CHECK(digits_of(a ^ b) == "01x 10x xxx");
}

TEST_CASE("an unknown signal carries a cause, that of the left operand first") {
    using Named = Signal<char>;
    constexpr Named zero{Logic::zero, '-'};
    constexpr Named one{Logic::one, '-'};
    constexpr Named a{Logic::unknown, 'a'};
    constexpr Named b{Logic::unknown, 'b'};
    for (const Named& signal : {~a, a & b, a | b, a & one, one & a, zero | a, a | zero}) {
        CHECK(signal.value == Logic::unknown);
        CHECK(signal.cause == 'a');
    }
    CHECK((b & a).cause == 'b');
    CHECK((a & zero).value == Logic::zero);
    CHECK((one | a).value == Logic::one);
    CHECK(!a.is_known());
    CHECK((a | one).is_known());
}
