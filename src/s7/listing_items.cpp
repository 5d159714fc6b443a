// Print with two columns, folded into one text, interleaves the right column with the left one, or
// puts it behind. The instructions can be sorted by their offsets; the question is where networks
// begin, whose lines have none.
//
// A network begins with the instruction that follows its line in its column. That is certain where
// it fits in with the others: taken in the order of their numbers, networks begin at ascending
// offsets. The heaviest ascending chain of such beginnings is kept, where one counts more if its
// line stands between two instructions that follow one another. A network that is left over had its
// line at the foot of a column, with its instructions elsewhere: among the instructions between its
// neighbours it begins where the sorted order leaves the order of the text.

#include "s7/listing_items.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "s7/messages.h"

namespace grafwire::s7 {

namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

std::uint32_t offset_of(const ListingItem& item) {
    return item.instruction.printed_offset;
}

bool ascends(const std::vector<ListingItem>& items) {
    std::uint32_t last = 0;
    bool is_first = true;
    for (const ListingItem& item : items) {
        if (item.is_network || offset_of(item) == Instruction::no_offset) continue;
        if (!is_first && offset_of(item) <= last) return false;
        last = offset_of(item);
        is_first = false;
    }
    return true;
}

/// The item before each in its column; nowhere before the first. (The right column is one text
/// from page to page, as the left one is.)
std::vector<std::size_t> predecessors(const std::vector<ListingItem>& items) {
    std::vector<std::size_t> before(items.size(), nowhere);
    std::size_t last[2] = {nowhere, nowhere};
    for (std::size_t i = 0; i < items.size(); ++i) {
        std::size_t& column = last[items[i].column];
        before[i] = column;
        column = i;
    }
    return before;
}

/// The members of a strictly ascending chain of values of the greatest weight.
std::vector<bool> heaviest_chain(const std::vector<std::size_t>& values,
                                 const std::vector<std::size_t>& weights) {
    std::vector<std::size_t> total(values.size(), 0);
    std::vector<std::size_t> before(values.size(), nowhere);
    std::size_t best = nowhere;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] == nowhere) continue;
        total[i] = weights[i];
        for (std::size_t k = 0; k < i; ++k) {
            if (values[k] != nowhere && values[k] < values[i] && total[k] + weights[i] > total[i]) {
                total[i] = total[k] + weights[i];
                before[i] = k;
            }
        }
        if (best == nowhere || total[i] > total[best]) best = i;
    }
    std::vector<bool> member(values.size(), false);
    for (; best != nowhere; best = before[best]) member[best] = true;
    return member;
}

class Columns {
  public:
    explicit Columns(const std::vector<ListingItem>& items)
        : items_(items), before_(predecessors(items)) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            (items[i].is_network ? networks_ : instructions_).push_back(i);
        }
        std::stable_sort(networks_.begin(), networks_.end(), [&](std::size_t a, std::size_t b) {
            return items[a].network.number < items[b].network.number;
        });
        std::stable_sort(instructions_.begin(), instructions_.end(),
                         [&](std::size_t a, std::size_t b) {
                             return offset_of(items[a]) < offset_of(items[b]);
                         });
    }

    /// Where two instructions have one offset, the second of them; nowhere if there are none.
    std::size_t repeated_offset() const {
        for (std::size_t k = 1; k < instructions_.size(); ++k) {
            if (offset_of(items_[instructions_[k]]) == offset_of(items_[instructions_[k - 1]])) {
                return std::max(instructions_[k], instructions_[k - 1]);
            }
        }
        return nowhere;
    }

    /// The item order; a network whose beginning cannot be found goes into `lost`.
    std::vector<std::size_t> order(std::vector<std::size_t>& lost) const {
        std::vector<std::size_t> begins = certain_beginnings();
        for (std::size_t n = 0; n < networks_.size(); ++n) {
            if (begins[n] == nowhere) begins[n] = break_between(begins, n);
            if (begins[n] == nowhere) lost.push_back(networks_[n]);
        }
        std::vector<std::size_t> result;
        std::size_t n = 0;
        for (std::size_t k = 0; k <= instructions_.size(); ++k) {
            while (n < networks_.size() && (begins[n] == nowhere || begins[n] <= k)) {
                result.push_back(networks_[n++]);
            }
            if (k < instructions_.size()) result.push_back(instructions_[k]);
        }
        return result;
    }

  private:
    /// Per network its first instruction, as a place in the order of the offsets.
    std::vector<std::size_t> certain_beginnings() const {
        std::vector<std::size_t> place(items_.size(), nowhere);
        for (std::size_t k = 0; k < instructions_.size(); ++k) place[instructions_[k]] = k;
        std::vector<std::size_t> follower(items_.size(), nowhere);
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (before_[i] != nowhere) follower[before_[i]] = i;
        }
        std::vector<std::size_t> begins;
        std::vector<std::size_t> weights;
        for (const std::size_t network : networks_) {
            const std::size_t next = follower[network];
            const std::size_t begin = next == nowhere ? nowhere : place[next];
            const bool is_between = begin != nowhere && begin > 0 && before_[network] != nowhere &&
                                    instructions_[begin - 1] == before_[network];
            begins.push_back(begin);
            weights.push_back(is_between ? 2 : 1);
        }
        const std::vector<bool> certain = heaviest_chain(begins, weights);
        for (std::size_t n = 0; n < begins.size(); ++n) {
            if (!certain[n]) begins[n] = nowhere;
        }
        return begins;
    }

    /// The first place between the beginnings of the neighbours at which the order of the offsets
    /// leaves that of the text.
    std::size_t break_between(const std::vector<std::size_t>& begins, std::size_t n) const {
        std::size_t first = n == 0 ? 0 : nowhere;
        if (n != 0 && begins[n - 1] != nowhere) first = begins[n - 1] + 1;
        std::size_t last = instructions_.size();
        for (std::size_t m = n + 1; m < begins.size(); ++m) {
            if (begins[m] != nowhere) {
                last = begins[m];
                break;
            }
        }
        if (first == 0 && last > 0) return 0;
        for (std::size_t k = first; k < last; ++k) {
            if (before_[instructions_[k]] != instructions_[k - 1]) return k;
        }
        return nowhere;
    }

    const std::vector<ListingItem>& items_;
    std::vector<std::size_t> before_;
    std::vector<std::size_t> networks_;      ///< in the order of their numbers
    std::vector<std::size_t> instructions_;  ///< in the order of their offsets
};

}  // namespace

void order_columns(std::vector<ListingItem>& items, Diagnostics& diagnostics) {
    if (ascends(items)) return;
    for (const ListingItem& item : items) {
        if (item.is_network || offset_of(item) != Instruction::no_offset) continue;
        diagnostics.error(code::bad_offset, item.instruction.where, messages::s7::offset_missing());
        return;
    }
    const Columns columns(items);
    if (const std::size_t repeated = columns.repeated_offset(); repeated != nowhere) {
        diagnostics.error(code::bad_offset, items[repeated].instruction.where,
                          messages::s7::offset_repeated(offset_of(items[repeated])));
        return;
    }
    std::vector<std::size_t> lost;
    const std::vector<std::size_t> order = columns.order(lost);
    for (const std::size_t network : lost) {
        diagnostics.error(code::bad_network, items[network].network.where,
                          messages::s7::network_lost(items[network].network.number));
    }
    std::size_t moved = 0;
    while (order[moved] == moved) ++moved;
    const Location where =
        items[moved].is_network ? items[moved].network.where : items[moved].instruction.where;
    diagnostics.warning(code::read_leniently, where, messages::s7::put_in_order());
    std::vector<ListingItem> sorted;
    for (const std::size_t item : order) sorted.push_back(std::move(items[item]));
    items = std::move(sorted);
}

void assemble(std::vector<ListingItem> items, Listing& listing, Diagnostics& diagnostics) {
    for (ListingItem& item : items) {
        if (item.is_network) {
            const std::uint32_t last =
                listing.networks.empty() ? 0 : listing.networks.back().number;
            if (!listing.networks.empty() && item.network.number <= last) {
                diagnostics.warning(code::read_leniently, item.network.where,
                                    messages::s7::networks_descend(item.network.number, last));
            }
            listing.networks.push_back(std::move(item.network));
            continue;
        }
        if (listing.networks.empty()) {
            diagnostics.error(code::bad_network, item.instruction.where,
                              messages::s7::outside_a_network());
            listing.networks.emplace_back();
        }
        listing.networks.back().instructions.push_back(std::move(item.instruction));
    }
}

}  // namespace grafwire::s7
