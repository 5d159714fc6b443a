#include "support/iec_lexer.h"

#include <algorithm>
#include <cctype>

namespace grafwire::testing {

namespace {

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

class Lexer {
  public:
    explicit Lexer(const std::string& text) : text_(text) {}

    std::vector<IecToken> all() {
        for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
            const char c = text_[at_];
            if (is_letter(c) || c == '_') {
                read_word();
            } else if (is_digit(c)) {
                std::string digits;
                while (is_digit(here())) digits += text_[at_++];
                if (is_letter(here())) fail("a number runs into a letter");
                add(IecToken::Kind::integer, digits, number(digits));
            } else {
                read_symbol();
            }
        }
        add(IecToken::Kind::end, "end of the text", 0);
        return std::move(tokens_);
    }

  private:
    char here(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[noreturn]] void fail(const std::string& message) const { throw PlcError(line_, message); }
    void add(IecToken::Kind kind, std::string text, std::int64_t value) {
        tokens_.push_back({kind, std::move(text), value, line_});
    }
    std::int64_t number(const std::string& digits) const {
        if (digits.size() > 18) fail("a number of more than 18 digits");
        return std::stoll(digits);
    }

    void skip_blanks() {
        while (at_ < text_.size()) {
            if (here() == '(' && here(1) == '*') {
                skip_comment();
            } else if (here() == ' ' || here() == '\n') {
                if (here() == '\n') ++line_;
                ++at_;
            } else {
                return;
            }
        }
    }

    void skip_comment() {
        for (at_ += 2; !(here() == '*' && here(1) == ')'); ++at_) {
            if (at_ >= text_.size()) fail("a comment without an end");
            if (here() == '(' && here(1) == '*') fail("a comment within a comment");
            if (here() == '\n') ++line_;
        }
        at_ += 2;
    }

    void read_word() {
        std::string word;
        while (is_letter(here()) || is_digit(here()) || here() == '_') {
            word += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_++])));
        }
        if ((word == "t" || word == "time") && here() == '#') {
            ++at_;
            return read_time();
        }
        if (word.find("__") != std::string::npos || word.back() == '_') {
            fail("underscores in '" + word + "'");
        }
        add(IecToken::Kind::identifier, word, 0);
    }

    /// Units from the longest to the shortest, each once; only the last has a fraction.
    void read_time() {
        struct Unit {
            const char* name;
            Time length;
        };
        static constexpr Unit units[] = {
            {"d", 24 * hour},    {"h", hour},         {"m", minute},      {"s", second},
            {"ms", millisecond}, {"us", microsecond}, {"ns", nanosecond},
        };
        std::size_t next_unit = 0;
        Time total = 0;
        bool had_fraction = false;
        while (is_digit(here())) {
            if (had_fraction) fail("a fraction before the last unit of a time");
            std::string whole;
            std::string fraction;
            while (is_digit(here())) whole += text_[at_++];
            if (here() == '.') {
                ++at_;
                had_fraction = true;
                while (is_digit(here())) fraction += text_[at_++];
                if (fraction.empty()) fail("a time without digits after the point");
            }
            std::string name;
            while (is_letter(here())) name += text_[at_++];
            while (next_unit < std::size(units) && units[next_unit].name != name) ++next_unit;
            if (next_unit == std::size(units)) fail("a time with the unit '" + name + "'");
            total += number(whole) * units[next_unit].length;
            Time part = units[next_unit].length;
            for (const char digit : fraction) {
                if (part % 10 != 0) fail("a time finer than a picosecond");
                part /= 10;
                total += (digit - '0') * part;
            }
            ++next_unit;
        }
        if (next_unit == 0) fail("a time without digits");
        add(IecToken::Kind::time, "a time", total);
    }

    void read_symbol() {
        for (const char* symbol : {":=", "..", "<>", "<=", ">="}) {
            if (here() == symbol[0] && here(1) == symbol[1]) {
                add(IecToken::Kind::symbol, symbol, 0);
                at_ += 2;
                return;
            }
        }
        if (std::string("()[],;:.+-*/<>=&").find(here()) == std::string::npos) {
            fail(std::string("the character '") + here() + "'");
        }
        add(IecToken::Kind::symbol, std::string(1, here()), 0);
        ++at_;
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::vector<IecToken> tokens_;
};

}  // namespace

std::vector<IecToken> iec_tokens(const std::string& text) {
    return Lexer(text).all();
}

}  // namespace grafwire::testing
