#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// A word of the textual languages of IEC 61131-3 (edition 2, annex B).
struct IecToken {
    enum class Kind { identifier, integer, time, symbol, end };
    Kind kind = Kind::end;
    std::string text;        ///< identifiers in lower case: case does not matter
    std::int64_t value = 0;  ///< of an integer, or a time in picoseconds
    std::size_t line = 0;
};

/// All words of a text, the last being an `end`. Refuses what is no word: two underscores in a row,
/// letters beyond ASCII outside comments, comments that do not end, malformed literals.
std::vector<IecToken> iec_tokens(const std::string& text);

/// Reads words one after the other. Copies share the words.
class IecTokenCursor {
  public:
    explicit IecTokenCursor(std::vector<IecToken> tokens)
        : tokens_(std::make_shared<const std::vector<IecToken>>(std::move(tokens))) {}

    const IecToken& peek() const { return (*tokens_)[at_]; }
    const IecToken& take() {
        const IecToken& token = peek();
        if (at_ + 1 < tokens_->size()) ++at_;
        return token;
    }
    bool is(std::string_view text) const {
        const IecToken& token = peek();
        return token.text == text &&
               (token.kind == IecToken::Kind::symbol || token.kind == IecToken::Kind::identifier);
    }
    bool accept(std::string_view text) {
        if (!is(text)) return false;
        take();
        return true;
    }
    void expect(std::string_view text) {
        if (!accept(text)) fail("expected '" + std::string(text) + "'");
    }
    const std::string& identifier() {
        if (peek().kind != IecToken::Kind::identifier) fail("expected a name");
        return take().text;
    }
    std::int64_t integer() {
        if (peek().kind != IecToken::Kind::integer) fail("expected a whole number");
        return take().value;
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw PlcError(peek().line, message + ", got '" + peek().text + "'");
    }

  private:
    std::shared_ptr<const std::vector<IecToken>> tokens_;
    std::size_t at_ = 0;
};

}  // namespace grafwire::testing
