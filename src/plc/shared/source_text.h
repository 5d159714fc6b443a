#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "program/program.h"
#include "text/message.h"

namespace grafwire {

/// What a section of the scan does, with the subroutine of the method that it is (Cordier, "Méthode
/// d'implémentation du GRAFCET" (1998), section 5): `SBR 3: transition conditions`.
Localized section_title(SectionKind kind);

/// The text of a program as it grows, line by line: indents, wraps what is longer than 100
/// characters at a blank outside of as many parentheses as possible, and writes comments.
class SourceText {
  public:
    /// Where a line may go on in the next one.
    enum class Breaks { anywhere, within_parentheses };

    /// `comment_sign` begins a comment that runs to the end of its line: `//`, `#`.
    explicit SourceText(std::string_view comment_sign, Breaks breaks = Breaks::anywhere)
        : comment_sign_(comment_sign), breaks_(breaks) {}

    void line(std::string_view text);
    /// As it is, whatever its length; for lines with texts between quotation marks.
    void whole_line(std::string_view text);
    void blank() { text_ += '\n'; }
    /// A comment of as many lines as the text has.
    void comment(std::string_view text);
    /// Lines that are the same in every program; their indentation is kept.
    void block(std::string_view text) { text_ += text; }

    void indent() { depth_ += 4; }
    void outdent() { depth_ -= 4; }
    /// Whether a line of so many characters would be wrapped.
    bool is_too_long(std::size_t length) const { return depth_ + length > width; }

    /// The text so far, which is forgotten.
    std::string take() { return std::exchange(text_, {}); }

  private:
    static constexpr std::size_t width = 100;

    std::string comment_sign_;
    Breaks breaks_;
    std::string text_;
    std::size_t depth_ = 0;
};

/// A text of the chart as a comment may hold it: control characters become blanks, signs that turn
/// the direction of writing are written as names, and no compiler takes the end for a continuation
/// of the line.
std::string comment_text(std::string_view text);

/// A part of a program that is the same for every chart, with each of its marks replaced by a text:
/// `@moment` by what a moment is in the language of the reader. Where a text has several lines, the
/// next ones begin as the line of the mark does: with its indentation and, in a comment, the sign
/// of comments; within a text of Python (`f"@mark"`), that text is ended and another begun.
struct MarkedText {
    std::string_view mark;
    std::string text;
};
std::string with_texts(std::string_view block, std::initializer_list<MarkedText> texts);

/// Whether a program calls a function: its name, no part of a longer one, before a parenthesis.
bool calls(std::string_view program, std::string_view function);

}  // namespace grafwire
