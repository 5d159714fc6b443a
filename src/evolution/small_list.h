#pragma once

#include <array>
#include <cstddef>
#include <vector>

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

}  // namespace grafwire
