#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "text/source.h"

namespace grafwire {

/// A position that moves forwards over one line of a text that goes by lines (stimuli, assignments
/// of addresses; UTF-8) and knows its column. A comment, from `#` on, ends the line. White space is
/// all that Unicode calls so: where French typography puts a no-break space before a colon, it
/// separates like any other.
class LineCursor {
  public:
    LineCursor(std::string_view line, std::uint32_t number) : line_(line), number_(number) {}

    bool at_end() const { return at_ == line_.size() || line_[at_] == '#'; }
    /// The next byte; only where the line is not at its end.
    char peek() const { return line_[at_]; }
    void skip(std::size_t bytes) { at_ += bytes; }
    bool skip_if(char c);
    void skip_blanks();

    /// Takes letters, digits and `_`; empty if the next character is none of them.
    std::string_view take_word();
    /// Takes everything up to the next white space, or the next `stop`.
    std::string_view take_until_blank(char stop = ' ');
    /// All that is left of the line, a comment included.
    std::string_view rest() const { return line_.substr(at_); }

    /// Counts on from the last place asked for, so that a long line is counted once.
    Location here();

  private:
    std::size_t blank_size() const;
    std::size_t word_character_size() const;

    std::string_view line_;
    std::uint32_t number_;
    std::size_t at_ = 0;
    std::size_t counted_ = 0;
    std::size_t column_ = 1;
};

}  // namespace grafwire
