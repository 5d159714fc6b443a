#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace grafwire {

/// The position of an id in its table.
template <typename Id>
constexpr std::size_t index_of(Id id) {
    return static_cast<std::size_t>(id);
}

/// A vector whose elements are reached by an id type of their own, so that a step can never be
/// looked up with the number of a transition.
template <typename Id, typename Item>
class Table {
  public:
    Table() = default;
    explicit Table(std::size_t size, Item item = Item()) : items_(size, item) {}

    decltype(auto) operator[](Id id) { return items_[index_of(id)]; }
    decltype(auto) operator[](Id id) const { return items_[index_of(id)]; }

    /// Appends an item and says under which id it is found.
    Id add(Item item) {
        items_.push_back(std::move(item));
        return static_cast<Id>(items_.size() - 1);
    }

    std::size_t size() const { return items_.size(); }
    bool empty() const { return items_.empty(); }
    Id id_at(std::size_t index) const { return static_cast<Id>(index); }

    auto begin() { return items_.begin(); }
    auto end() { return items_.end(); }
    auto begin() const { return items_.begin(); }
    auto end() const { return items_.end(); }

    std::vector<Item>& items() { return items_; }
    const std::vector<Item>& items() const { return items_; }

    bool operator==(const Table&) const = default;

  private:
    std::vector<Item> items_;
};

}  // namespace grafwire
