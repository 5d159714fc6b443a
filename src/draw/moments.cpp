#include "draw/moments.h"

namespace grafwire {

namespace {

bool changes_in(const Trace& trace, std::size_t row) {
    for (std::size_t column = 0; column < trace.columns.size(); ++column) {
        if (value_in(trace, row, column) != value_in(trace, row - 1, column)) return true;
    }
    return false;
}

}  // namespace

std::int64_t value_in(const Trace& trace, std::size_t row, std::size_t column) {
    if (row >= trace.row_count()) return Trace::unknown;
    return trace.values[row * trace.columns.size() + column];
}

std::vector<std::size_t> moments_of(const Trace& trace, const Trace* other) {
    std::vector<std::size_t> moments;
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        const bool changes =
            row == 0 || changes_in(trace, row) || (other != nullptr && changes_in(*other, row));
        if (changes || row + 1 == trace.row_count()) moments.push_back(row);
    }
    return moments;
}

}  // namespace grafwire
