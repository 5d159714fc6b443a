// The distance between two names is the number of characters that must be inserted, removed,
// replaced or exchanged with their neighbour to turn one into the other (optimal string alignment,
// the restricted form of Damerau's distance). Three rows of the usual table are kept; a candidate
// whose length alone puts it out of reach is never compared.

#include "text/nearest_name.h"

#include <algorithm>
#include <string>

#include "text/utf8.h"

namespace grafwire {

namespace {

std::u32string code_points_of(std::string_view text) {
    std::u32string result;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint code_point = decode_utf8(text, at);
        result.push_back(code_point.value);
        at += std::max<std::size_t>(code_point.length, 1);
    }
    return result;
}

/// Row i of the table holds the distances of the first i characters of `a` to the beginnings of
/// `b`.
std::size_t edit_distance(const std::u32string& a, const std::u32string& b) {
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, above);
        std::swap(above, row);
    }
    return above[b.size()];
}

}  // namespace

std::string_view nearest_name(std::string_view mistyped,
                              const std::vector<std::string_view>& names) {
    constexpr std::size_t longest_compared = 200;
    const std::u32string wanted = code_points_of(mistyped);
    if (wanted.size() < 2 || wanted.size() > longest_compared) return {};
    std::size_t allowed = std::max<std::size_t>(wanted.size() / 3, 1);
    std::string_view nearest;
    for (const std::string_view name : names) {
        const std::size_t length = count_code_points(name);
        if (length > wanted.size() + allowed || length + allowed < wanted.size()) continue;
        const std::size_t distance = edit_distance(wanted, code_points_of(name));
        if (distance > allowed) continue;
        // From here on only a nearer one counts, which also ends most comparisons by the length.
        nearest = name;
        if (distance == 0) break;
        allowed = distance - 1;
        if (allowed == 0) break;
    }
    return nearest;
}

}  // namespace grafwire
