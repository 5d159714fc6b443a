// BLIF has no tokens but words: what ends a line, joins it with the next or begins a comment is all
// there is to know. The reader of words keeps the place of each, for messages.

#include "formats/blif/blif_lines.h"

#include "text/utf8.h"

namespace grafwire {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

}  // namespace

void BlifLines::advance() {
    const auto byte = static_cast<unsigned char>(text_[position_++]);
    if (byte == '\n') {
        ++where_.line;
        where_.column = 1;
    } else if (position_ == text_.size() || begins_character(text_[position_])) {
        ++where_.column;
    }
}

void BlifLines::skip_comment() {
    while (!at_end() && here() != '\n') advance();
}

/// Passes a `\` and the end of its line, if that is what stands here.
bool BlifLines::join_lines() {
    if (here() != '\\') return false;
    std::size_t after = position_ + 1;
    while (after < text_.size() && is_blank(text_[after])) ++after;
    if (after < text_.size() && text_[after] != '\n') return false;
    while (position_ < after) advance();
    if (!at_end()) advance();
    return true;
}

/// Up to a blank, a comment, or a `\` that ends the line; one within a word belongs to it.
BlifWord BlifLines::take_word() {
    const std::size_t begin = position_;
    const Location where = where_;
    while (!at_end() && !is_blank(here()) && here() != '\n') {
        if (here() == '#' && position_ != begin) break;
        if (here() == '\\') {
            BlifLines ahead = *this;
            if (ahead.join_lines()) break;
        }
        advance();
    }
    return {text_.substr(begin, position_ - begin), where};
}

bool BlifLines::next(std::vector<BlifWord>& words) {
    words.clear();
    while (!at_end()) {
        if (is_blank(here()) || join_lines()) {
            if (!at_end() && is_blank(here())) advance();
        } else if (here() == '\n') {
            advance();
            if (!words.empty()) return true;
        } else if (here() == '#') {
            const bool is_ours =
                words.empty() && position_ + 1 < text_.size() && text_[position_ + 1] == '@';
            if (is_ours) {
                words.push_back(take_word());
            } else {
                skip_comment();
            }
        } else {
            words.push_back(take_word());
        }
    }
    return !words.empty();
}

}  // namespace grafwire
