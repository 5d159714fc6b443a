#include "draw/schematic_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/messages.h"
#include "text/joined.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr double row_height = 0.45;
constexpr double column_gap = 0.3;

/// `1, 3–5`; of many only the first.
std::string sheets_in_words(const std::vector<std::size_t>& sheets) {
    constexpr std::size_t most = 4;
    std::string words;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sheets.size();) {
        std::size_t end = i + 1;
        while (end < sheets.size() && sheets[end] == sheets[end - 1] + 1) ++end;
        if (count++ == most) return words + ", …";
        if (!words.empty()) words += ", ";
        words += end - i == 1   ? fmt::format("{}", sheets[i])
                 : end - i == 2 ? fmt::format("{}, {}", sheets[i], sheets[i] + 1)
                                : fmt::format("{}–{}", sheets[i], sheets[end - 1]);
        i = end;
    }
    return words;
}

/// The name without the signs that stand before it.
std::string_view bare(std::string_view name) {
    while (name.size() > 1 && (name.front() == '/' || name.front() == '(')) name.remove_prefix(1);
    return name;
}

/// Runs of digits are compared as numbers.
bool comes_before(std::string_view a, std::string_view b) {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!is_digit(a[i]) || !is_digit(b[j])) {
            if (a[i] != b[j]) return a[i] < b[j];
            ++i, ++j;
            continue;
        }
        const auto number = [](std::string_view text, std::size_t& at) {
            const std::size_t first = text.find_first_not_of('0', at);
            const std::size_t begin = std::min(first, text.size());
            at = begin;
            while (at < text.size() && is_digit(text[at])) ++at;
            return text.substr(begin, at - begin);
        };
        const std::string_view left = number(a, i);
        const std::string_view right = number(b, j);
        if (left.size() != right.size()) return left.size() < right.size();
        if (left != right) return left < right;
    }
    return a.size() - i < b.size() - j;
}

}  // namespace

IndexColumn::IndexColumn(const SchematicView& view, std::vector<IndexEntry> entries)
    : view_(&view), entries_(std::move(entries)) {
    const Message<>& made = messages::draw::made_on;
    const Message<>& read = messages::draw::read_on;
    const auto wide = [](const std::string& text) { return width_of(plain_text(text)); };
    double made_width =
        std::max(wide(made.in(view.language)), wide(messages::draw::input.in(view.language)));
    double read_width = wide(read.in(view.language));
    for (const IndexEntry& entry : entries_) {
        made_at_ = std::max(made_at_, wide(view.nets.names[index_of(entry.net)]));
        read_width = std::max(read_width, wide(sheets_in_words(entry.read_on)));
    }
    made_at_ += column_gap;
    read_at_ = made_at_ + made_width + column_gap;
    width_ = read_at_ + read_width;
}

double IndexColumn::height() const {
    return static_cast<double>(entries_.size() + 1) * row_height;
}

void IndexColumn::draw(SchematicPens& pens, Point at) const {
    double y = at.y + row_height / 2;
    const auto row = [&](Pen pen, const std::string& name, const std::string& made,
                         const std::string& read, Label::Role role) {
        const auto write = [&](const std::string& text, double x) {
            if (!text.empty()) {
                pen.label(plain_text(text), {at.x + x, y}, Label::Anchor::start, role);
            }
        };
        write(name, 0);
        write(made, made_at_);
        write(read, read_at_);
        y += row_height;
    };
    row(pens.owned_by({"index-head", {}, {}}), {}, messages::draw::made_on.in(view_->language),
        messages::draw::read_on.in(view_->language), Label::Role::remark);
    for (const IndexEntry& entry : entries_) {
        const std::string made = entry.made_on == 0 ? messages::draw::input.in(view_->language)
                                                    : fmt::format("{}", entry.made_on);
        Owner owner{"index",
                    {{"net", std::string(view_->nets.netlist.names[entry.net])},
                     {"made-on", fmt::format("{}", entry.made_on)},
                     {"read-on", joined(entry.read_on, " ")}},
                    {}};
        row(pens.owned_by(std::move(owner)), view_->nets.names[index_of(entry.net)], made,
            sheets_in_words(entry.read_on), Label::Role::plain);
    }
}

std::vector<IndexColumn> index_columns(const SchematicView& view, std::vector<IndexEntry> entries,
                                       std::size_t most) {
    std::sort(entries.begin(), entries.end(), [&](const IndexEntry& a, const IndexEntry& b) {
        const std::string_view left = view.nets.names[index_of(a.net)];
        const std::string_view right = view.nets.names[index_of(b.net)];
        if (comes_before(bare(left), bare(right))) return true;
        if (comes_before(bare(right), bare(left))) return false;
        return left.size() < right.size();
    });
    std::vector<IndexColumn> columns;
    for (std::size_t first = 0; first < entries.size(); first += most) {
        const std::size_t end = std::min(entries.size(), first + most);
        columns.emplace_back(
            view, std::vector<IndexEntry>(entries.begin() + static_cast<std::ptrdiff_t>(first),
                                          entries.begin() + static_cast<std::ptrdiff_t>(end)));
    }
    return columns;
}

}  // namespace grafwire
