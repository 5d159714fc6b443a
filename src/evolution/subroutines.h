#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evolution/evaluate.h"
#include "evolution/evolution.h"
#include "evolution/tables.h"

namespace grafwire {

/// A list whose first `inline_capacity` items need no memory of their own. A scan touches few
/// transitions and orders, so that it seldom asks for memory at all, and needs no workspace that
/// would have to be passed around or kept between scans.
template <typename Item, std::size_t inline_capacity>
class SmallList {
  public:
    SmallList() = default;
    SmallList(const SmallList&) = delete;
    SmallList& operator=(const SmallList&) = delete;

    void push_back(const Item& item) {
        if (size_ < inline_capacity) {
            inline_[size_] = item;
        } else {
            if (size_ == inline_capacity) spilled_.assign(inline_.begin(), inline_.end());
            spilled_.push_back(item);
        }
        ++size_;
    }
    void clear() {
        size_ = 0;
        spilled_.clear();
    }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    Item* begin() { return size_ <= inline_capacity ? inline_.data() : spilled_.data(); }
    Item* end() { return begin() + size_; }
    const Item* begin() const {
        return size_ <= inline_capacity ? inline_.data() : spilled_.data();
    }
    const Item* end() const { return begin() + size_; }

  private:
    std::array<Item, inline_capacity> inline_;
    std::vector<Item> spilled_;
    std::size_t size_ = 0;
};

/// What the subroutines of one scan work on.
struct ScanContext {
    const Grafcet& grafcet;
    const EvolutionTables& tables;
    EvolutionState& state;
    Evaluator read;  ///< reads `state` as it is at the time
    Time now;
    ScanRecord* record = nullptr;  ///< where to note what the scan does, if anywhere
};

/// The transitions cleared in a scan.
using ClearedList = SmallList<TransitionId, 32>;

// The parts of a scan after the clearing of transitions, in the order in which they are called.

/// SBR 5 up to AUdur: forcing, enclosures. `init` is the value of Init, which keeps the activation
/// links of enclosures from acting.
void apply_forcing(const ScanContext& scan, bool init);

/// The last part of SBR 5: what the stored actions of the steps that have changed, and of the
/// transitions that were cleared, write. `cleared` in any order.
void run_stored_actions(const ScanContext& scan, const ClearedList& cleared);

/// SBR 6: the values of time conditions, and the times at which their running delays end.
void update_time_conditions(const ScanContext& scan);

}  // namespace grafwire
