#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// A variable, time condition or edge, as it is or negated.
struct Literal {
    ExprId atom = no_expr;
    bool negated = false;
    auto operator<=>(const Literal&) const = default;
};

/// AND of the literals; 1 where there is none.
using Product = std::vector<Literal>;

/// Adds a product to a sum, unless it is implied by one of them; drops those that it implies.
void add_product(std::vector<Product>& products, Product product);

/// An expression as OR of products, none of which is 0 or implied by another; none at all for 0.
/// nullopt where more than `most` are needed on the way.
std::optional<std::vector<Product>> products_of(const Expressions& pool, ExprId id,
                                                std::size_t most = 64);

/// What is 1 where the OR of these products is 0; nullopt likewise.
std::optional<std::vector<Product>> complement_of(const std::vector<Product>& products,
                                                  std::size_t most = 64);

/// a . b; nullopt where that is 0.
std::optional<Product> product_of(const Product& a, const Product& b);

/// Whether both products can be 1 at once, as far as their literals and the assumptions of the
/// chart tell. `pool` is that of the products, `assumptions` are expressions of it.
bool are_compatible(const Expressions& pool, const Product& a, const Product& b,
                    const std::vector<ExprId>& assumptions);

}  // namespace grafwire
