#pragma once

#include <string_view>
#include <vector>

#include "text/source.h"

namespace grafwire {

/// A word, and where it stands.
struct BlifWord {
    std::string_view text;
    Location where;
};

/// Cuts a BLIF text into logical lines of words: comments left out, lines ended by `\` joined with
/// the next. The words point into the text.
///
///     .names a b \       # the step
///         X1
///
/// is the one line `.names` `a` `b` `X1`.
class BlifLines {
  public:
    explicit BlifLines(std::string_view text) : text_(text) {}

    /// The next line that is not empty; false at the end. A comment that begins with `#@` counts as
    /// a line whose first word is `#@…`.
    bool next(std::vector<BlifWord>& words);

  private:
    void skip_comment();
    bool join_lines();
    BlifWord take_word();
    void advance();
    bool at_end() const { return position_ == text_.size(); }
    char here() const { return text_[position_]; }

    std::string_view text_;
    std::size_t position_ = 0;
    Location where_{1, 1};
};

}  // namespace grafwire
