#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "netlist/delay_model.h"
#include "text/time.h"

namespace grafwire {

/// At which times some pending firings can take place, as far as they are bound to one another: a
/// set of vectors with one component per firing, up to a common shift, bounded by how large each
/// difference of two components can be.
class FiringDomain {
  public:
    FiringDomain() = default;
    /// All begin at one moment, each for itself.
    explicit FiringDomain(std::span<const DelayBand> bands);

    /// Where a firing of a later domain comes from.
    struct Origin {
        static constexpr std::size_t begins = static_cast<std::size_t>(-1);
        std::size_t firing = begins;  ///< it has been pending as this one; or it begins
        DelayBand band;               ///< with these bounds
    };
    /// Lets some firings (`first`) take place at one moment, not after those of `others` and before
    /// those of `later`: false where that cannot be. The domain `after` is that of the firings that
    /// are pending then; those that begin do so at that moment.
    bool fire(std::span<const std::size_t> first, std::span<const std::size_t> others,
              std::span<const std::size_t> later, std::span<const Origin> origins,
              FiringDomain& after) const;

    /// Whether everything that is possible in the other domain, of as many firings, is so here.
    bool includes(const FiringDomain& other) const;
    /// Becomes the smallest domain that includes both.
    void include(const FiringDomain& other);
    /// Lets every firing take place at any time.
    void include_all();

  private:
    Time& bound(std::size_t i, std::size_t j) { return bounds_[i * size_ + j]; }
    Time bound(std::size_t i, std::size_t j) const { return bounds_[i * size_ + j]; }
    bool tighten(std::size_t a, std::size_t b, Time limit);

    std::size_t size_ = 0;
    std::vector<Time> bounds_;  ///< row i, column j: the greatest component i minus component j
};

}  // namespace grafwire
