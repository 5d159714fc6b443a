// Ripple-carry arithmetic on words of nets. Counters are small and the clocked style computes once
// a scan, so the simplest adder is the right one: it can be followed with a pencil.
//
// Every gate is made in a statement of its own: C++ leaves the order in which arguments are
// evaluated to the compiler, and the order of the cells must not depend on it.

#include "netlist/styles/arithmetic.h"

#include <algorithm>
#include <bit>
#include <string>

namespace grafwire {

NetId Arithmetic::gate(CellType type, NetId a, NetId b) {
    return gates_.gate(type, {a, b}, "a" + std::to_string(++next_));
}

NetId Arithmetic::and_of(NetId a, NetId b) {
    if (gates_.is_low(a) || gates_.is_low(b)) return gates_.low();
    if (gates_.is_high(a) || a == b) return b;
    if (gates_.is_high(b)) return a;
    return gate(CellType::and_gate, a, b);
}

NetId Arithmetic::or_of(NetId a, NetId b) {
    if (gates_.is_high(a) || gates_.is_high(b)) return gates_.high();
    if (gates_.is_low(a) || a == b) return b;
    if (gates_.is_low(b)) return a;
    return gate(CellType::or_gate, a, b);
}

NetId Arithmetic::xor_of(NetId a, NetId b) {
    if (a == b) return gates_.low();
    if (gates_.is_low(a)) return b;
    if (gates_.is_low(b)) return a;
    if (gates_.is_high(a)) return gates_.inverted(b);
    if (gates_.is_high(b)) return gates_.inverted(a);
    return gate(CellType::xor_gate, a, b);
}

// Three gates and a shared inverter; fewer where an operand is constant.
NetId Arithmetic::choose(NetId chosen, NetId a, NetId b) {
    if (a == b) return a;
    const NetId from_a = and_of(chosen, a);
    const NetId from_b = and_of(gates_.inverted(chosen), b);
    return or_of(from_a, from_b);
}

Word Arithmetic::choose(NetId chosen, const Word& a, const Word& b) {
    const std::size_t width = std::max(a.size(), b.size());
    const Word left = extended(a, width);
    const Word right = extended(b, width);
    Word result;
    for (std::size_t i = 0; i < width; ++i) result.push_back(choose(chosen, left[i], right[i]));
    return result;
}

Word Arithmetic::constant(WideInteger value, std::size_t width) {
    Word word;
    for (std::size_t i = 0; i < width; ++i) {
        word.push_back((value & 1) != 0 ? gates_.high() : gates_.low());
        value >>= 1;
    }
    return word;
}

Word Arithmetic::extended(Word word, std::size_t width) const {
    while (word.size() < width) word.push_back(word.back());
    return word;
}

Word Arithmetic::add(const Word& a, const Word& b, NetId carry) {
    const std::size_t width = std::max(a.size(), b.size()) + 1;
    const Word left = extended(a, width);
    const Word right = extended(b, width);
    Word result;
    for (std::size_t i = 0; i < width; ++i) {
        const NetId half = xor_of(left[i], right[i]);
        result.push_back(xor_of(half, carry));
        if (i + 1 == width) break;
        const NetId generated = and_of(left[i], right[i]);
        const NetId propagated = and_of(half, carry);
        carry = or_of(generated, propagated);
    }
    return result;
}

Word Arithmetic::subtract(const Word& a, const Word& b) {
    const std::size_t width = std::max(a.size(), b.size());
    Word complement = extended(b, width);
    for (NetId& bit : complement) bit = gates_.inverted(bit);
    return add(extended(a, width), complement, gates_.high());
}

// The constants of a sum are added up here, and cost one word; every counter costs an adder. Each
// adds a bit to be on the safe side, but twice as many words need only one bit more; bits beyond
// that are all the sign and are dropped, or the gates would grow with the square of the counters.
Word Arithmetic::sum(const Sum& terms, const std::vector<Word>& counters) {
    WideInteger constant_part = 0;
    for (const SumTerm& term : terms) {
        if (term.counter == SumTerm::no_counter) {
            constant_part += term.negative ? -WideInteger{term.value} : WideInteger{term.value};
        }
    }
    std::size_t width = 1;
    for (WideInteger rest = constant_part; rest != 0 && rest != -1; rest >>= 1) ++width;
    Word result = constant(constant_part, width);
    std::size_t words = 1;
    for (const SumTerm& term : terms) {
        if (term.counter == SumTerm::no_counter) continue;
        const Word& counter = counters[term.counter];
        width = std::max(width, counter.size());
        ++words;
        result = term.negative ? subtract(result, counter) : add(result, counter, gates_.low());
        result.resize(std::min(result.size(), width + std::bit_width(words)));
    }
    return result;
}

NetId Arithmetic::is_zero(const Word& word) {
    NetId any = gates_.low();
    for (const NetId bit : word) any = or_of(any, bit);
    return gates_.inverted(any);
}

// left < right where left - right is negative, and so on; the difference is wide enough never to
// overflow.
NetId Arithmetic::compare(const Word& left, Relation relation, const Word& right) {
    const Word difference = subtract(left, right);
    const auto negative_or_zero = [&] {
        const NetId zero = is_zero(difference);
        return or_of(is_negative(difference), zero);
    };
    switch (relation) {
        case Relation::equal:
            return is_zero(difference);
        case Relation::not_equal:
            return gates_.inverted(is_zero(difference));
        case Relation::less:
            return is_negative(difference);
        case Relation::greater_equal:
            return gates_.inverted(is_negative(difference));
        case Relation::less_equal:
            return negative_or_zero();
        case Relation::greater:
            return gates_.inverted(negative_or_zero());
    }
    return gates_.low();
}

}  // namespace grafwire
