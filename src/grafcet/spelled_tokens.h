#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/lexer.h"

namespace grafwire {

/// A token in the spelling of the canonical layout.
struct SpelledToken {
    TokenKind kind = TokenKind::end;
    std::string text;
    /// The bytes of the source that it stands for. Comments lie between tokens, never within one.
    std::size_t begin = 0;
    std::size_t end = 0;
    bool begins_part = false;  ///< as of ReadToken
    bool joins = false;        ///< it stands right behind the token before, without a blank
};

/// The tokens of a chart without errors: one spelling of each keyword, in the language asked for,
/// and of each operator; names in normal form C, between quotation marks only where they must be.
/// The chart that they spell is the same.
std::vector<SpelledToken> spell_tokens(std::string_view source, std::span<const ReadToken> tokens,
                                       Language language);

}  // namespace grafwire
