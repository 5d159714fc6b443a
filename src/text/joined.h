#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace grafwire {

/// The texts, or whole numbers, one after the other, with the separator between them. fmt::join
/// would do, but takes a second to compile wherever it is used.
template <class Items>
std::string joined(const Items& items, std::string_view separator) {
    std::string result;
    bool first = true;
    for (const auto& item : items) {
        if (!first) result += separator;
        first = false;
        if constexpr (std::integral<typename Items::value_type>) {
            result += std::to_string(item);
        } else {
            result += item;
        }
    }
    return result;
}

}  // namespace grafwire
