// The sum of products is that of S. Minato and E. Morreale ("Fast generation of irredundant
// sum-of-products forms", SASIMI 1992): what must be covered where a variable is 0 and may not be
// where it is 1 needs a product with its negation, likewise the other way round, and the rest is
// covered without the variable. With `a` to be covered and `b` left open, a + b comes out as `a`: b
// buys nothing.
//
// The cost grows with the rows, 2^variables, and with the products; it is why there is a bound on
// both (most_variables, `most`). Tables are words of 64 rows: the first six variables are patterns
// within a word (`in_word`), each further one says which words are 1.

#include "explain/truth_table.h"

#include <algorithm>

namespace grafwire {

namespace {

/// The column of variable 0 to 5 within the 64 rows of a word: 01 01…, 0011…, …
constexpr std::uint64_t in_word[6] = {0xaaaaaaaaaaaaaaaaU, 0xccccccccccccccccU,
                                      0xf0f0f0f0f0f0f0f0U, 0xff00ff00ff00ff00U,
                                      0xffff0000ffff0000U, 0xffffffff00000000U};

/// The sum under construction. The recursion takes the variables from the last one down.
class IrredundantSum {
  public:
    IrredundantSum(std::size_t variables, std::size_t most) : variables_(variables), most_(most) {}

    /// Adds products for the interval, each with these variables besides; gives what they cover.
    TruthTable cover(const TruthTable& lower, const TruthTable& upper, std::size_t variables,
                     const Product& besides) {
        if (lower.is(false) || products_.size() > most_) return {variables_, false};
        if (upper.is(true)) {
            products_.push_back(besides);
            return {variables_, true};
        }
        std::size_t v = variables - 1;
        while (!lower.depends_on(v) && !upper.depends_on(v)) --v;
        const TruthTable lower0 = lower.with(v, false);
        const TruthTable lower1 = lower.with(v, true);
        const TruthTable upper0 = upper.with(v, false);
        const TruthTable upper1 = upper.with(v, true);
        const std::uint32_t bit = 1U << v;
        const TruthTable f0 =
            cover(lower0 & ~upper1, upper0, v, {besides.plain, besides.negated | bit});
        const TruthTable f1 =
            cover(lower1 & ~upper0, upper1, v, {besides.plain | bit, besides.negated});
        const TruthTable rest = cover((lower0 & ~f0) | (lower1 & ~f1), upper0 & upper1, v, besides);
        const TruthTable x = TruthTable::variable(variables_, v);
        return (~x & f0) | (x & f1) | rest;
    }

    std::size_t most() const { return most_; }
    std::vector<Product>& products() { return products_; }

  private:
    std::size_t variables_;
    std::size_t most_;
    std::vector<Product> products_;
};

}  // namespace

TruthTable::TruthTable(std::size_t variables, bool value)
    : words_(std::size_t{1} << (std::max<std::size_t>(variables, 6) - 6),
             value ? ~std::uint64_t{0} : 0) {}

TruthTable TruthTable::variable(std::size_t variables, std::size_t index) {
    TruthTable table(variables, false);
    for (std::size_t w = 0; w < table.words_.size(); ++w) {
        if (index < 6) {
            table.words_[w] = in_word[index];
        } else if ((w >> (index - 6) & 1U) != 0) {
            table.words_[w] = ~std::uint64_t{0};
        }
    }
    return table;
}

bool TruthTable::is(bool value) const {
    const std::uint64_t word = value ? ~std::uint64_t{0} : 0;
    return std::all_of(words_.begin(), words_.end(), [&](std::uint64_t w) { return w == word; });
}

bool TruthTable::depends_on(std::size_t variable) const {
    return with(variable, false) != with(variable, true);
}

TruthTable TruthTable::with(std::size_t variable, bool value) const {
    TruthTable result = *this;
    for (std::size_t w = 0; w < words_.size(); ++w) {
        if (variable >= 6) {
            const std::size_t bit = std::size_t{1} << (variable - 6);
            result.words_[w] = words_[value ? w | bit : w & ~bit];
            continue;
        }
        const unsigned shift = 1U << variable;
        const std::uint64_t mask = in_word[variable];
        const std::uint64_t half = words_[w] & (value ? mask : ~mask);
        result.words_[w] = half | (value ? half >> shift : half << shift);
    }
    return result;
}

TruthTable TruthTable::operator~() const {
    TruthTable result = *this;
    for (std::uint64_t& word : result.words_) word = ~word;
    return result;
}

TruthTable& TruthTable::operator&=(const TruthTable& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= other.words_[w];
    return *this;
}

TruthTable& TruthTable::operator|=(const TruthTable& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
    return *this;
}

TruthTable& TruthTable::operator^=(const TruthTable& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] ^= other.words_[w];
    return *this;
}

std::optional<std::vector<Product>> irredundant_sum(const TruthTable& lower,
                                                    const TruthTable& upper, std::size_t variables,
                                                    std::size_t most) {
    IrredundantSum sum(variables, most);
    sum.cover(lower, upper, variables, {});
    std::vector<Product> products = std::move(sum.products());
    if (products.size() > most) return std::nullopt;
    // In the order of the variables that stand in them.
    std::sort(products.begin(), products.end(), [](const Product& a, const Product& b) {
        const std::uint32_t in_a = a.plain | a.negated;
        const std::uint32_t in_b = b.plain | b.negated;
        const std::uint32_t only = in_a ^ in_b;
        if (only == 0) return a.plain > b.plain;
        return (in_a & (only & (~only + 1))) != 0;
    });
    return products;
}

}  // namespace grafwire
