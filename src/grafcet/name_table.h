#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace grafwire {

/// Values found by name, in the order added. The names are kept as views: their text must outlive
/// the table.
///
/// Open addressing with linear probing; the size is a power of two, at most half of it used. Names
/// that differ in their last character only have their places side by side: a file numbers its
/// steps one after the other and links near ones, so that most look-ups find their place in the
/// cache however long the file is. A place holds the hash, so that other
/// names are skipped without comparing their text.
template <typename Value>
class NameTable {
  public:
    struct Added {
        Value& value;  ///< of the first use of the name; moves when a name is added
        bool is_new;
    };
    /// Of a name added twice the first value counts.
    Added add(std::string_view name, Value value) {
        if (2 * (entries_.size() + 1) > slots_.size()) grow(std::max(smallest, 2 * slots_.size()));
        const std::uint32_t hash = hash_of(name);
        Slot& slot = slots_[place_of(name, hash)];
        const bool is_new = slot.entry == free;
        if (is_new) {
            slot = {hash, static_cast<std::uint32_t>(entries_.size())};
            entries_.push_back({name, value});
        }
        return {entries_[slot.entry].value, is_new};
    }

    /// Null where there is no such name.
    const Value* find(std::string_view name) const {
        if (slots_.empty()) return nullptr;
        const Slot& slot = slots_[place_of(name, hash_of(name))];
        return slot.entry == free ? nullptr : &entries_[slot.entry].value;
    }

    /// Makes room for so many names.
    void reserve(std::size_t names) {
        entries_.reserve(names);
        std::size_t size = smallest;
        while (size < 2 * names) size *= 2;
        if (size > slots_.size()) grow(size);
    }

  private:
    struct Entry {
        std::string_view name;
        Value value;
    };
    static constexpr std::uint32_t free = 0xffffffffU;
    struct Slot {
        std::uint32_t hash = 0;
        std::uint32_t entry = free;
    };
    static constexpr std::size_t smallest = 64;
    /// The last bits are those of the last character: `X12` and `X13` are neighbours.
    static std::uint32_t hash_of(std::string_view name) {
        constexpr unsigned neighbour_bits = 4;
        if (name.empty()) return 0;
        const std::size_t stem = std::hash<std::string_view>()(name.substr(0, name.size() - 1));
        const auto last = static_cast<std::uint32_t>(static_cast<unsigned char>(name.back()));
        return static_cast<std::uint32_t>(stem << neighbour_bits) |
               (last & ((1U << neighbour_bits) - 1));
    }

    /// Where the name is, or would be.
    std::size_t place_of(std::string_view name, std::uint32_t hash) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = hash & mask;
        while (slots_[i].entry != free &&
               (slots_[i].hash != hash || entries_[slots_[i].entry].name != name))
            i = (i + 1) & mask;
        return i;
    }

    /// Puts all places into a larger table by the hashes they hold.
    void grow(std::size_t size) {
        std::vector<Slot> old(size);
        old.swap(slots_);
        const std::size_t mask = slots_.size() - 1;
        for (const Slot& slot : old) {
            if (slot.entry == free) continue;
            std::size_t i = slot.hash & mask;
            while (slots_[i].entry != free) i = (i + 1) & mask;
            slots_[i] = slot;
        }
    }

    std::vector<Entry> entries_;
    std::vector<Slot> slots_;
};

}  // namespace grafwire
