#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace grafwire {

/// Lines of one kind have the same columns.
enum class LineKind : std::uint8_t {
    plain,
    counter,     ///< name, range
    definition,  ///< name, condition
    duration,    ///< name, duration
    step,        ///< step, actions
    transition,  ///< label, steps before, steps after, condition; each may be empty
    goes_on,     ///< of the part on the lines before
};

/// A line of a text whose columns are still to be aligned.
struct TextLine {
    LineKind kind = LineKind::plain;
    bool is_indented = false;  ///< it stands in a block
    bool is_behind_blank_line = false;
    bool begins_group = false;       ///< its columns are not those of the lines above
    std::vector<std::string> cells;  ///< none: a line that holds a comment only, or nothing
    std::string comment;             ///< from its `#` on
    /// Where the lines that go on begin: so many characters behind the beginning of the last cell;
    /// 0 where they are indented instead.
    std::size_t hang = 0;
};

/// The text, each line ended by a line feed.
std::string write_aligned(std::vector<TextLine> lines);

}  // namespace grafwire
