// The canonical layout of a text, which is made from its tokens and not from the model: comments,
// blank lines, defined names and the order of parts are no part of a model, and stay.
//
// Each declaration, step, transition and brace is a part, and begins a line. Within a part a line
// end stays where lines are usually broken: behind a comma, around an operator, before `do`; and
// behind a comment, where it must.

#include "grafcet/format_grafcet.h"

#include <string_view>
#include <utility>
#include <vector>

#include "grafcet/aligned_lines.h"
#include "grafcet/chart_parser.h"
#include "grafcet/spelled_tokens.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// A comment, and how many line ends stand between it and what is before it.
struct Comment {
    std::string text;
    std::size_t line_ends = 0;
};

/// What stands between two tokens, and how many line ends stand behind the last comment.
struct Gap {
    std::vector<Comment> comments;
    std::size_t line_ends = 0;
};

Gap read_gap(std::string_view text) {
    Gap gap;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '\n') ++gap.line_ends;
        if (text[at] != '#') continue;
        std::string_view comment = text.substr(at, text.find('\n', at) - at);
        at += comment.size() - 1;
        comment = comment.substr(0, comment.find_last_not_of(" \t\r\v\f") + 1);
        gap.comments.push_back({std::string(comment), std::exchange(gap.line_ends, 0)});
    }
    return gap;
}

LineKind kind_of_part(TokenKind first) {
    switch (first) {
        case TokenKind::kw_counter:
            return LineKind::counter;
        case TokenKind::kw_define:
            return LineKind::definition;
        case TokenKind::kw_time:
            return LineKind::duration;
        case TokenKind::kw_initial:
        case TokenKind::kw_step:
        case TokenKind::kw_entry:
        case TokenKind::kw_exit:
            return LineKind::step;
        case TokenKind::left_parenthesis:
        case TokenKind::arrow:
        case TokenKind::word:
        case TokenKind::integer:
        case TokenKind::quoted:
            return LineKind::transition;
        default:
            return LineKind::plain;
    }
}

/// A sign between operands, before or behind which a line may end.
bool is_between_operands(const SpelledToken& token) {
    return !token.joins && (token.text == "." || token.text == "+" || token.text == "⊕" ||
                            token.kind == TokenKind::minus);
}

class ChartLayout {
  public:
    ChartLayout(std::string_view source, const std::vector<SpelledToken>& tokens)
        : source_(source), tokens_(tokens) {}

    std::vector<TextLine> lines() {
        std::size_t at = byte_order_mark_size(source_);
        for (const SpelledToken& token : tokens_) {
            const Gap gap = read_gap(source_.substr(at, token.begin - at));
            if (token.begins_part) {
                begin_part(token, gap);
            } else {
                go_on(token, gap);
            }
            append(token);
            at = token.end;
        }
        add_comments(read_gap(source_.substr(at)));
        return std::move(lines_);
    }

  private:
    void begin_part(const SpelledToken& token, const Gap& gap);
    void go_on(const SpelledToken& token, const Gap& gap);
    void append(const SpelledToken& token);
    void add_comments(const Gap& gap);
    TextLine& add_line(LineKind kind, std::size_t line_ends);
    bool begins_cell(const SpelledToken& token) const;

    std::string_view source_;
    const std::vector<SpelledToken>& tokens_;
    std::vector<TextLine> lines_;
    bool is_in_block_ = false;
    bool is_behind_brace_ = false;  ///< the `{` of a block is the last token

    // Of the part that is being laid out.
    const SpelledToken* first_ = nullptr;
    const SpelledToken* previous_ = nullptr;
    bool is_in_body_ = false;  ///< behind the keyword of a list, the `:` or `=` of others
    bool is_on_first_line_ = false;
};

/// A blank line stands where there was one, but neither first in the file or a block nor last.
TextLine& ChartLayout::add_line(LineKind kind, std::size_t line_ends) {
    TextLine& line = lines_.emplace_back();
    line.kind = kind;
    line.is_indented = is_in_block_;
    line.is_behind_blank_line = line_ends > 1 && lines_.size() > 1 && !is_behind_brace_;
    line.begins_group = line.is_behind_blank_line || is_behind_brace_;
    is_behind_brace_ = false;
    return line;
}

/// Comments between parts: one on the line of a part stays behind it.
void ChartLayout::add_comments(const Gap& gap) {
    for (const Comment& comment : gap.comments) {
        if (comment.line_ends == 0 && !lines_.empty()) {
            lines_.back().comment = comment.text;
        } else {
            add_line(LineKind::plain, comment.line_ends).comment = comment.text;
        }
    }
}

void ChartLayout::begin_part(const SpelledToken& token, const Gap& gap) {
    add_comments(gap);
    const bool is_brace = token.kind == TokenKind::right_brace;
    if (is_brace) is_in_block_ = false;
    const LineKind kind = kind_of_part(token.kind);
    TextLine& line = add_line(kind, is_brace ? 0 : gap.line_ends);
    line.cells.emplace_back();
    if (kind == LineKind::transition && token.kind != TokenKind::left_parenthesis) {
        line.cells.emplace_back();
    }
    if (is_brace || token.kind == TokenKind::kw_graph || token.kind == TokenKind::kw_expansion) {
        line.begins_group = true;
    }
    first_ = &token;
    previous_ = nullptr;
    is_in_body_ = false;
    is_on_first_line_ = true;
}

/// Begins a new line within a part where one stays.
void ChartLayout::go_on(const SpelledToken& token, const Gap& gap) {
    for (const Comment& comment : gap.comments) {
        if (comment.line_ends == 0) {
            lines_.back().comment = comment.text;
        } else {
            add_line(LineKind::goes_on, 0).comment = comment.text;
        }
    }
    const bool may_break =
        is_in_body_ && !token.joins &&
        (previous_->kind == TokenKind::comma || is_between_operands(*previous_) ||
         is_between_operands(token) || token.kind == TokenKind::kw_do);
    if (gap.comments.empty() && (gap.line_ends == 0 || !may_break)) return;
    add_line(LineKind::goes_on, 0).cells.emplace_back();
    is_on_first_line_ = false;
}

/// Whether a column begins with this token.
bool ChartLayout::begins_cell(const SpelledToken& token) const {
    if (!is_on_first_line_ || is_in_body_ || previous_ == nullptr) {
        return token.kind == TokenKind::arrow && previous_ == nullptr;
    }
    switch (lines_.back().kind) {
        case LineKind::counter:
        case LineKind::step:
            return token.kind == TokenKind::colon;
        case LineKind::definition:
        case LineKind::duration:
            return token.kind == TokenKind::equal;
        case LineKind::transition:
            return token.kind == TokenKind::arrow || token.kind == TokenKind::colon ||
                   token.kind == TokenKind::assign ||
                   previous_->kind == TokenKind::right_parenthesis;
        default:
            return false;
    }
}

void ChartLayout::append(const SpelledToken& token) {
    TextLine& line = lines_.back();
    if (begins_cell(token)) line.cells.emplace_back();
    // A label without steps behind it leaves their column empty.
    if (line.kind == LineKind::transition && token.kind == TokenKind::arrow &&
        previous_ != nullptr && previous_->kind == TokenKind::right_parenthesis) {
        line.cells.emplace_back();
    }
    std::string& cell = line.cells.back();
    if (!cell.empty() && !token.joins) cell += ' ';
    cell += token.text;
    const bool opens_block =
        token.kind == TokenKind::left_brace &&
        (first_->kind == TokenKind::kw_graph || first_->kind == TokenKind::kw_expansion);
    if (opens_block) {
        is_in_block_ = true;
        is_behind_brace_ = true;
    }
    const bool is_list = &token == first_ && line.kind == LineKind::plain && !opens_block;
    const bool opens_body = is_list || token.kind == TokenKind::colon ||
                            token.kind == TokenKind::assign || token.kind == TokenKind::equal;
    if (opens_body && !is_in_body_) {
        constexpr std::size_t sign_and_blank = 2;
        is_in_body_ = true;
        if (is_on_first_line_) line.hang = is_list ? count_code_points(cell) + 1 : sign_and_blank;
    }
    previous_ = &token;
}

}  // namespace

std::optional<std::string> format_grafcet(const SourceFile& source, Language keywords,
                                          Diagnostics& diagnostics) {
    std::vector<ReadToken> tokens;
    if (!parse_keeping_tokens(source, tokens, diagnostics)) return std::nullopt;
    const std::vector<SpelledToken> spelled = spell_tokens(source.text, tokens, keywords);
    return write_aligned(ChartLayout(source.text, spelled).lines());
}

}  // namespace grafwire
