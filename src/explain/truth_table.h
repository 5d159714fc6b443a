#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace grafwire {

/// A Boolean function of a few variables, as the column of its truth table: bit r is its value in
/// row r, in which variable v is bit v of r.
class TruthTable {
  public:
    static constexpr std::size_t most_variables = 14;  ///< 2 KiB a table

    /// A constant.
    TruthTable(std::size_t variables, bool value);
    /// The function that is one of the variables.
    static TruthTable variable(std::size_t variables, std::size_t index);

    bool at(std::size_t row) const { return (words_[row / 64] >> (row % 64) & 1U) != 0; }
    /// Whether it is that constant.
    bool is(bool value) const;
    bool depends_on(std::size_t variable) const;
    /// The function with one variable held; it no longer depends on it.
    TruthTable with(std::size_t variable, bool value) const;

    TruthTable operator~() const;
    TruthTable& operator&=(const TruthTable& other);
    TruthTable& operator|=(const TruthTable& other);
    TruthTable& operator^=(const TruthTable& other);
    friend TruthTable operator&(TruthTable a, const TruthTable& b) { return a &= b; }
    friend TruthTable operator|(TruthTable a, const TruthTable& b) { return a |= b; }
    friend TruthTable operator^(TruthTable a, const TruthTable& b) { return a ^= b; }
    bool operator==(const TruthTable&) const = default;

  private:
    /// Of at least six variables, those that there are not without effect.
    std::vector<std::uint64_t> words_;
};

/// A product of variables: bit v of `plain` or `negated`.
struct Product {
    std::uint32_t plain = 0;
    std::uint32_t negated = 0;
};

/// A sum of products, none of which can be left out, for a function that is 1 at least where
/// `lower` is and at most where `upper` is. Nothing where that takes more than `most` products.
std::optional<std::vector<Product>> irredundant_sum(const TruthTable& lower,
                                                    const TruthTable& upper, std::size_t variables,
                                                    std::size_t most);

}  // namespace grafwire
