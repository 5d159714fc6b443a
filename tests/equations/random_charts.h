#pragma once

#include <random>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// A random expression in the notation of the language.
class RandomText {
  public:
    RandomText(unsigned seed, std::vector<std::string> atoms)
        : random_(seed), atoms_(std::move(atoms)) {}

    std::size_t below(std::size_t limit) { return random_() % limit; }

    std::string expression(int depth) {
        if (depth == 0) return atoms_[below(atoms_.size())];
        switch (below(6)) {
            case 0:
                return atoms_[below(atoms_.size())];
            case 1:
                return "/(" + expression(depth - 1) + ")";
            case 2:
                return "(" + joined(" ⊕ ", depth) + ")";
            case 3:
                return "(" + joined(".", depth) + ")";
            default:
                return "(" + joined(" + ", depth) + ")";
        }
    }

  private:
    std::string joined(const char* sign, int depth) {
        std::string text = expression(depth - 1);
        for (std::size_t i = 0; i < 1 + below(3); ++i) text += sign + expression(depth - 1);
        return text;
    }

    std::mt19937 random_;
    std::vector<std::string> atoms_;
};

}  // namespace grafwire
