// The greatest ratio of delays for which a netlist is right.
//
// What gates of 1 to 2 ns can do, gates of 1 to 3 ns can do as well, so there is one ratio up to
// which a netlist is right. It is found by bisection. A check that ends undecided says nothing:
// then the two ends, the smallest ratio that is refuted and the greatest that is proven, are sought
// apart, and both are told. Only checks that are decided count, so neither can be wrong.
//
// A difference is found sooner than its absence is proven, and the sooner the more delays differ.
// So after equal delays come those that differ much, for which little time is needed.

#include "check/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "check/check_equivalence.h"

namespace grafwire {

namespace {

std::vector<int> all_ratios() {
    std::vector<int> ratios;
    for (int ratio = least_ratio; ratio <= greatest_ratio; ratio = next_ratio(ratio)) {
        ratios.push_back(ratio);
    }
    return ratios;
}

/// Looked at first.
constexpr int first_ratios[] = {least_ratio, 100, greatest_ratio};

class ToleranceSearch {
  public:
    ToleranceSearch(const Grafcet& grafcet, const NetlistFor& netlist_for,
                    const CheckOptions& options)
        : grafcet_(grafcet),
          netlist_for_(netlist_for),
          options_(options),
          ratios_(all_ratios()),
          right_below_(0),
          wrong_from_(ratios_.size()) {
        options_.looks_at_many = false;
        options_.looks_for_pulses = false;
    }

    Tolerance find() {
        std::size_t undecided = none;
        for (const int ratio : first_ratios) {
            const auto place = std::find(ratios_.begin(), ratios_.end(), ratio);
            const auto number = static_cast<std::size_t>(place - ratios_.begin());
            const Verdict verdict = look_at(number);
            if (verdict == Verdict::different) break;
            if (verdict == Verdict::undecided) undecided = number;
        }
        // Close in, from either side of what is undecided.
        while (right_below_ < wrong_from_) {
            const std::size_t middle = right_below_ + (wrong_from_ - right_below_) / 2;
            if (look_at(middle) != Verdict::undecided) continue;
            undecided = middle;
            break;
        }
        if (undecided != none) {
            lower_refutation(undecided);
            raise_proof(undecided);
        }
        return result();
    }

  private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    Verdict look_at(std::size_t number) {
        if (undecided_.contains(number)) return Verdict::undecided;
        const CheckResult checked = check(delays_of_ratio(ratios_[number]));
        if (checked.verdict == Verdict::undecided) undecided_.insert(number);
        if (checked.verdict == Verdict::equivalent) {
            right_below_ = std::max(right_below_, number + 1);
        } else if (checked.verdict == Verdict::different) {
            wrong_from_ = number;
            witness_ = checked.witness;
        }
        return checked.verdict;
    }

    CheckResult check(const DelayModel& delays) {
        const bool goes_on = !options_.keep_going || options_.keep_going();
        const auto netlist = goes_on ? netlist_for_(delays) : std::nullopt;
        if (!netlist) return {};
        options_.delays = delays;
        return check_equivalence(grafcet_, *netlist, options_);
    }

    void raise_proof(std::size_t undecided) {
        while (right_below_ < undecided) {
            const std::size_t middle = right_below_ + (undecided - right_below_) / 2;
            if (look_at(middle) != Verdict::equivalent) undecided = middle;
        }
    }

    void lower_refutation(std::size_t undecided) {
        while (undecided + 1 < wrong_from_ && wrong_from_ != ratios_.size()) {
            const std::size_t middle = undecided + 1 + (wrong_from_ - undecided - 1) / 2;
            if (look_at(middle) != Verdict::different) undecided = middle;
        }
    }

    Tolerance result() {
        Tolerance tolerance;
        if (right_below_ != 0) tolerance.holds = ratios_[right_below_ - 1];
        if (wrong_from_ != ratios_.size()) {
            tolerance.fails = ratios_[wrong_from_];
            tolerance.witness = std::move(witness_);
        } else if (right_below_ == ratios_.size()) {
            tolerance.is_unlimited = check(*delay_model_of("any")).verdict == Verdict::equivalent;
        }
        return tolerance;
    }

    const Grafcet& grafcet_;
    const NetlistFor& netlist_for_;
    CheckOptions options_;
    const std::vector<int> ratios_;
    std::size_t right_below_;  ///< it is right for all ratios before this one
    std::size_t wrong_from_;   ///< a difference was found for this one
    std::optional<Witness> witness_;
    std::set<std::size_t> undecided_;
};

}  // namespace

DelayModel delays_of_ratio(int tenths) {
    return *delay_model_of(fmt::format("1..{}.{}", tenths / 10, tenths % 10));
}

Tolerance find_tolerance(const Grafcet& grafcet, const NetlistFor& netlist_for,
                         const CheckOptions& options) {
    return ToleranceSearch(grafcet, netlist_for, options).find();
}

}  // namespace grafwire
