#include "netlist/styles/receptivity.h"

#include <algorithm>
#include <utility>

namespace grafwire {

namespace {

using Products = std::vector<Product>;

bool holds_complement(const Product& product, const Literal& literal) {
    const Literal complement{literal.atom, !literal.negated};
    return std::binary_search(product.begin(), product.end(), complement);
}

/// Distributes AND over OR and pushes negations down to the atoms.
class Expansion {
  public:
    Expansion(const Expressions& pool, std::size_t most) : pool_(pool), most_(most) {}

    std::optional<Products> expand(ExprId id, bool negated) {
        Products products = value(id, negated);
        if (is_too_large_) return std::nullopt;
        return products;
    }

  private:
    Products value(ExprId id, bool negated) {
        switch (pool_.kind(id)) {
            case ExprKind::constant:
                if (pool_.constant_value(id) == negated) return {};
                return {Product()};
            case ExprKind::negation:
                return value(pool_.operands(id)[0], !negated);
            case ExprKind::conjunction:
                return negated ? sum(id, true) : product(id, false);
            case ExprKind::disjunction:
                return negated ? product(id, true) : sum(id, false);
            case ExprKind::exclusive_or:
                return exclusive(pool_.operands(id), negated);
            default:
                return {Product{{id, negated}}};
        }
    }

    Products sum(ExprId id, bool negated) {
        Products result;
        for (const ExprId operand : pool_.operands(id)) {
            for (Product& term : value(operand, negated)) add_product(result, std::move(term));
        }
        return limited(std::move(result));
    }

    Products product(ExprId id, bool negated) {
        Products result{Product()};
        for (const ExprId operand : pool_.operands(id)) {
            result = conjunction(result, value(operand, negated));
        }
        return result;
    }

    Products exclusive(std::span<const ExprId> operands, bool negated) {
        if (operands.size() == 1) return value(operands[0], negated);
        const auto rest = operands.subspan(1);
        Products result = conjunction(value(operands[0], false), exclusive(rest, !negated));
        for (Product& term : conjunction(value(operands[0], true), exclusive(rest, negated))) {
            add_product(result, std::move(term));
        }
        return limited(std::move(result));
    }

    Products conjunction(const Products& a, const Products& b) {
        Products result;
        for (const Product& left : a) {
            for (const Product& right : b) {
                if (is_too_large_) return {};
                if (auto both = product_of(left, right)) add_product(result, std::move(*both));
                if (result.size() > most_) is_too_large_ = true;
            }
        }
        return result;
    }

    Products limited(Products products) {
        if (products.size() <= most_) return products;
        is_too_large_ = true;
        return {};
    }

    const Expressions& pool_;
    std::size_t most_;
    bool is_too_large_ = false;
};

/// Of an expression where only the atoms of a product are known.
enum class Known { no, yes, maybe };

Known value_under(const Expressions& pool, ExprId id, const Product& known) {
    const auto inverse = [](Known value) {
        return value == Known::maybe ? value : value == Known::yes ? Known::no : Known::yes;
    };
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id) ? Known::yes : Known::no;
        case ExprKind::negation:
            return inverse(value_under(pool, pool.operands(id)[0], known));
        case ExprKind::conjunction:
        case ExprKind::disjunction: {
            const Known decides = pool.kind(id) == ExprKind::conjunction ? Known::no : Known::yes;
            Known result = inverse(decides);
            for (const ExprId operand : pool.operands(id)) {
                const Known value = value_under(pool, operand, known);
                if (value == decides) return decides;
                if (value == Known::maybe) result = Known::maybe;
            }
            return result;
        }
        default:
            break;
    }
    if (std::binary_search(known.begin(), known.end(), Literal{id, false})) return Known::yes;
    return std::binary_search(known.begin(), known.end(), Literal{id, true}) ? Known::no
                                                                             : Known::maybe;
}

}  // namespace

void add_product(std::vector<Product>& products, Product product) {
    const auto implies = [](const Product& narrow, const Product& wide) {
        return std::includes(narrow.begin(), narrow.end(), wide.begin(), wide.end());
    };
    for (const Product& other : products) {
        if (implies(product, other)) return;
    }
    std::erase_if(products, [&](const Product& other) { return implies(other, product); });
    products.push_back(std::move(product));
}

std::optional<std::vector<Product>> products_of(const Expressions& pool, ExprId id,
                                                std::size_t most) {
    return Expansion(pool, most).expand(id, false);
}

std::optional<std::vector<Product>> complement_of(const std::vector<Product>& products,
                                                  std::size_t most) {
    Products result{Product()};
    for (const Product& product : products) {
        Products longer;
        for (const Product& so_far : result) {
            for (const Literal& literal : product) {
                const Product other{{literal.atom, !literal.negated}};
                if (auto both = product_of(so_far, other)) add_product(longer, std::move(*both));
            }
        }
        if (longer.size() > most) return std::nullopt;
        result = std::move(longer);
    }
    return result;
}

std::optional<Product> product_of(const Product& a, const Product& b) {
    Product result;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    for (const Literal& literal : result) {
        if (holds_complement(result, literal)) return std::nullopt;
    }
    return result;
}

bool are_compatible(const Expressions& pool, const Product& a, const Product& b,
                    const std::vector<ExprId>& assumptions) {
    const std::optional<Product> both = product_of(a, b);
    if (!both) return false;
    return std::none_of(assumptions.begin(), assumptions.end(), [&](ExprId assumption) {
        return value_under(pool, assumption, *both) == Known::no;
    });
}

}  // namespace grafwire
