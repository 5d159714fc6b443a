// Two-level minimisation by the method of Quine and McCluskey.
//
// With at most 10 atoms there are at most 3^10 = 59 049 products, few enough to keep one byte for
// each: a product that leaves an atom out is an implicant if the two products that name it are. A
// prime implicant is one that can leave out no further atom. Every row of the truth table then
// needs a prime that covers it; the cheapest set is searched by branch and bound, hardest rows
// first, so that essential primes are chosen before anything else. (McCluskey, "Minimization of
// Boolean functions", Bell System Technical Journal 35, 1956.)
//
// A product is numbered in base 3, one digit per atom: 0 negated, 1 plain, 2 left out.

#include "equations/minimise.h"

#include <algorithm>
#include <bitset>
#include <cassert>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "equations/logic.h"

namespace grafwire {

namespace {

constexpr std::size_t max_atoms = 10;
constexpr std::size_t max_rows = std::size_t{1} << max_atoms;
constexpr std::size_t search_budget = 100'000;  // branches; then the best cover so far is taken
using Rows = std::bitset<max_rows>;             // one bit per row of the truth table

bool is_operator(ExprKind kind) {
    return kind == ExprKind::negation || kind == ExprKind::conjunction ||
           kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
}

/// The atoms in the order in which they occur, and all nodes of the expression, operands first.
struct Parts {
    std::vector<ExprId> atoms;
    std::vector<ExprId> nodes;
    bool too_many = false;
};

Parts parts_of(const Expressions& pool, ExprId root) {
    Parts parts;
    std::unordered_set<ExprId> seen{root};
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
        const ExprId id = pending.back();
        pending.pop_back();
        parts.nodes.push_back(id);
        const ExprKind kind = pool.kind(id);
        if (is_operator(kind)) {
            const std::span<const ExprId> operands = pool.operands(id);
            for (std::size_t i = operands.size(); i-- > 0;) {
                if (seen.insert(operands[i]).second) pending.push_back(operands[i]);
            }
        } else if (kind != ExprKind::constant) {
            if (parts.atoms.size() == max_atoms) {
                parts.too_many = true;
                return parts;
            }
            parts.atoms.push_back(id);
        }
    }
    std::sort(parts.nodes.begin(), parts.nodes.end());
    return parts;
}

/// The values of an atom in all rows, counted in binary.
Rows column_of_atom(std::size_t atom, std::size_t row_count) {
    Rows rows;
    for (std::size_t row = 0; row < row_count; ++row) rows[row] = (row >> atom & 1U) != 0;
    return rows;
}

/// The values of the whole expression; all rows at once, operator by operator.
Rows truth_table(const Expressions& pool, const Parts& parts, ExprId root) {
    const std::size_t row_count = std::size_t{1} << parts.atoms.size();
    std::unordered_map<ExprId, Rows> values;
    for (std::size_t i = 0; i < parts.atoms.size(); ++i) {
        values[parts.atoms[i]] = column_of_atom(i, row_count);
    }
    for (const ExprId id : parts.nodes) {
        const ExprKind kind = pool.kind(id);
        if (kind == ExprKind::constant) {
            values[id] = pool.constant_value(id) ? ~Rows() : Rows();
        } else if (is_operator(kind)) {
            const std::span<const ExprId> operands = pool.operands(id);
            Rows value = values.at(operands.front());
            if (kind == ExprKind::negation) value.flip();
            for (const ExprId operand : operands.subspan(1)) {
                const Rows& other = values.at(operand);
                if (kind == ExprKind::conjunction) value &= other;
                if (kind == ExprKind::disjunction) value |= other;
                if (kind == ExprKind::exclusive_or) value ^= other;
            }
            values[id] = value;
        }
    }
    return values.at(root) & (~Rows() >> (max_rows - row_count));
}

struct Product {
    std::vector<std::uint8_t> digits;  // per atom
    Rows rows;                         // that it covers
    std::size_t literals = 0;
};

std::vector<std::size_t> powers_of_three(std::size_t count) {
    std::vector<std::size_t> powers{1};
    while (powers.size() <= count) powers.push_back(powers.back() * 3);
    return powers;
}

/// The product of that number, with the rows it covers.
Product product_of(std::size_t number, std::size_t atom_count) {
    Product product;
    std::vector<std::size_t> rows{0};
    for (std::size_t atom = 0; atom < atom_count; ++atom, number /= 3) {
        const auto digit = static_cast<std::uint8_t>(number % 3);
        product.digits.push_back(digit);
        product.literals += digit != 2;
        const std::size_t bit = std::size_t{1} << atom;
        const std::size_t before = rows.size();
        for (std::size_t i = 0; i < before; ++i) {
            if (digit == 2) rows.push_back(rows[i] | bit);
            if (digit == 1) rows[i] |= bit;
        }
    }
    for (const std::size_t row : rows) product.rows.set(row);
    return product;
}

/// Per product, whether it implies the function.
std::vector<bool> implicants(const Rows& function, std::size_t atom_count) {
    const std::vector<std::size_t> power = powers_of_three(atom_count);
    std::vector<bool> result(power[atom_count]);
    for (std::size_t number = 0; number < result.size(); ++number) {
        std::size_t row = 0;
        std::size_t left_out = atom_count;
        for (std::size_t atom = 0, rest = number; atom < atom_count; ++atom, rest /= 3) {
            if (rest % 3 == 1) row |= std::size_t{1} << atom;
            if (rest % 3 == 2) left_out = atom;
        }
        result[number] = left_out == atom_count ? function[row]
                                                : result[number - power[left_out]] &&
                                                      result[number - 2 * power[left_out]];
    }
    return result;
}

/// Implicants that are none any more where any atom is left out.
std::vector<Product> prime_implicants(const Rows& function, std::size_t atom_count) {
    const std::vector<std::size_t> power = powers_of_three(atom_count);
    const std::vector<bool> implicant = implicants(function, atom_count);
    std::vector<Product> primes;
    for (std::size_t number = 0; number < implicant.size(); ++number) {
        if (!implicant[number]) continue;
        bool prime = true;
        for (std::size_t atom = 0, rest = number; atom < atom_count && prime; ++atom, rest /= 3) {
            prime = rest % 3 == 2 || !implicant[number + (2 - rest % 3) * power[atom]];
        }
        if (prime) primes.push_back(product_of(number, atom_count));
    }
    return primes;
}

/// The cheapest set of primes that covers every row in which the function is 1. As a bound, what is
/// left needs at least so many more products as it has rows divided by the largest prime.
class CoverSearch {
  public:
    CoverSearch(const Rows& function, const std::vector<Product>& primes) : primes_(primes) {
        order_rows(function);
        for (const Product& prime : primes) {
            largest_ = std::max(largest_, (prime.rows & function).count());
        }
    }

    std::vector<std::size_t> cheapest(const Rows& function) {
        best_cost_ = no_cost;
        branch(function, 0, 0);
        assert(best_cost_ != no_cost);
        return best_;
    }

  private:
    static constexpr std::size_t no_cost = static_cast<std::size_t>(-1);
    static constexpr std::size_t product_cost = 1 << 16;  // more than all literals together

    struct Row {
        std::size_t row = 0;
        std::vector<std::size_t> covered_by;  // primes, the larger ones first
    };

    void order_rows(const Rows& function) {
        for (std::size_t row = 0; row < max_rows; ++row) {
            if (!function[row]) continue;
            Row entry{row, {}};
            for (std::size_t i = 0; i < primes_.size(); ++i) {
                if (primes_[i].rows[row]) entry.covered_by.push_back(i);
            }
            std::stable_sort(entry.covered_by.begin(), entry.covered_by.end(),
                             [&](std::size_t a, std::size_t b) {
                                 return primes_[a].literals < primes_[b].literals;
                             });
            rows_.push_back(std::move(entry));
        }
        std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
            return a.covered_by.size() < b.covered_by.size();
        });
    }

    // Covers what is left, from the given place in the order of rows on. As deep as the cover has
    // products, hence at most max_rows / 2.
    void branch(const Rows& left, std::size_t place, std::size_t cost) {
        while (place < rows_.size() && !left[rows_[place].row]) ++place;
        if (place == rows_.size()) {
            if (cost < best_cost_) {
                best_cost_ = cost;
                best_ = chosen_;
            }
            return;
        }
        const std::size_t at_least = (left.count() + largest_ - 1) / largest_;
        if (best_cost_ != no_cost &&
            (cost + at_least * product_cost >= best_cost_ || ++branches_ > search_budget)) {
            return;
        }
        for (const std::size_t prime : rows_[place].covered_by) {
            chosen_.push_back(prime);
            branch(left & ~primes_[prime].rows, place + 1,
                   cost + product_cost + primes_[prime].literals);
            chosen_.pop_back();
        }
    }

    const std::vector<Product>& primes_;
    std::vector<Row> rows_;
    std::size_t largest_ = 1;
    std::vector<std::size_t> chosen_;
    std::vector<std::size_t> best_;
    std::size_t best_cost_ = no_cost;
    std::size_t branches_ = 0;
};

/// Products that name early atoms come first, plain before negated.
bool reads_before(const Product& a, const Product& b) {
    const auto rank = [](std::uint8_t digit) { return digit == 1 ? 0 : digit == 0 ? 1 : 2; };
    return std::lexicographical_compare(
        a.digits.begin(), a.digits.end(), b.digits.begin(), b.digits.end(),
        [&](std::uint8_t left, std::uint8_t right) { return rank(left) < rank(right); });
}

}  // namespace

ExprId minimised(Expressions& pool, ExprId id) {
    const Parts parts = parts_of(pool, id);
    if (parts.too_many) return no_expr;
    const Rows function = truth_table(pool, parts, id);
    const std::vector<Product> primes = prime_implicants(function, parts.atoms.size());

    std::vector<Product> cover;
    if (function.any()) {
        for (const std::size_t prime : CoverSearch(function, primes).cheapest(function)) {
            cover.push_back(primes[prime]);
        }
    }
    std::sort(cover.begin(), cover.end(), reads_before);

    std::vector<ExprId> sum;
    for (const Product& product : cover) {
        std::vector<ExprId> factors;
        for (std::size_t atom = 0; atom < parts.atoms.size(); ++atom) {
            const ExprId literal = parts.atoms[atom];
            if (product.digits[atom] == 1) factors.push_back(literal);
            if (product.digits[atom] == 0) factors.push_back(not_of(pool, literal));
        }
        sum.push_back(and_of(pool, factors));
    }
    return or_of(pool, sum);
}

}  // namespace grafwire
