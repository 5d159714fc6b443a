#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace grafwire {

/// The position of an id in its table.
template <typename Id>
constexpr std::size_t index_of(Id id) {
    return static_cast<std::size_t>(id);
}

/// What an id is that stands for no item: `EnclosureId enclosure = none`. An index may be none too.
struct None {
    template <typename Id>
    requires(std::is_enum_v<Id> || std::is_same_v<Id, std::uint32_t>) constexpr operator Id()
        const {  // NOLINT: it is to convert by itself
        return static_cast<Id>(0xffffffffU);
    }
    template <typename Id>
    friend constexpr bool operator==(Id id, None none) {
        return id == static_cast<Id>(none);
    }
};
inline constexpr None none;

/// `count` items of a table or list from number `first` on: an unbroken part of it.
template <typename Id = std::uint32_t>
struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    bool contains(Id id) const { return index_of(id) >= first && index_of(id) - first < count; }
    bool empty() const { return count == 0; }
    bool operator==(const Range&) const = default;

    /// Goes through the ids of the range.
    class Iterator {
      public:
        explicit Iterator(std::uint32_t at) : at_(at) {}
        Id operator*() const { return static_cast<Id>(at_); }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator==(const Iterator&) const = default;

      private:
        std::uint32_t at_;
    };
    Iterator begin() const { return Iterator(first); }
    Iterator end() const { return Iterator(first + count); }
};

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
