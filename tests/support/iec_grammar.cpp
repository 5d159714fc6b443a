// A text is read with Earley's method ("An efficient context-free parsing algorithm", 1970), which
// takes any context-free grammar as it stands: of each place in the text it keeps all that may have
// begun before and go on there. Repetitions are rules that begin with themselves, the form that
// costs least. What may be empty is stepped over where it is predicted (Aycock and Horspool,
// "Practical Earley parsing", 2002).

#include "support/iec_grammar.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <unordered_set>
#include <vector>

#include "support/files.h"

namespace grafwire::testing {

namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::string in_capitals(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

struct Word {
    enum class Kind : std::uint8_t { word, integer, time, symbol, line_end, wrong };
    Kind kind = Kind::wrong;
    std::string text;  ///< words in capitals
    std::size_t line = 1;
};

/// Words and symbols (tables 1 to 5 and 8): comments are blanks.
class Lexer {
  public:
    explicit Lexer(const std::string& text) : text_(text) {}

    std::vector<Word> all() {
        while (at_ < text_.size()) {
            if (text_.compare(at_, 2, "(*") == 0) {
                skip_comment();
            } else if (here() == '\n') {
                add(Word::Kind::line_end, 1);
                ++line_;
            } else if (here() == ' ') {
                ++at_;
            } else if (is_letter(here()) || here() == '_') {
                read_word();
            } else if (is_digit(here())) {
                add(Word::Kind::integer, run(is_digit));
            } else {
                read_symbol();
            }
        }
        return std::move(words_);
    }

  private:
    char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void add(Word::Kind kind, std::size_t length) {
        words_.push_back({kind, in_capitals(text_.substr(at_, length)), line_});
        at_ += length;
    }
    template <typename Test>
    std::size_t run(const Test& test) const {
        std::size_t end = at_;
        while (end < text_.size() && test(text_[end])) ++end;
        return end - at_;
    }
    void skip_comment() {
        const std::size_t end = text_.find("*)", at_ + 2);
        if (end == std::string::npos) return add(Word::Kind::wrong, text_.size() - at_);
        const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(at_);
        const auto stop = text_.begin() + static_cast<std::ptrdiff_t>(end);
        line_ += static_cast<std::size_t>(std::count(begin, stop, '\n'));
        at_ = end + 2;
    }
    void read_word() {
        const std::size_t length =
            run([](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
        const std::string word = in_capitals(text_.substr(at_, length));
        if ((word == "T" || word == "TIME") && text_.compare(at_ + length, 1, "#") == 0) {
            return read_time(length + 1);
        }
        const bool is_wrong = word.find("__") != std::string::npos || word.back() == '_';
        add(is_wrong ? Word::Kind::wrong : Word::Kind::word, length);
    }
    /// One unit, which is what programs of this project use.
    void read_time(std::size_t prefix) {
        const std::size_t begin = at_;
        at_ += prefix;
        std::size_t digits = run(is_digit);
        at_ += digits;
        if (here() == '.') {
            ++at_;
            digits = std::min(digits, run(is_digit));
            at_ += run(is_digit);
        }
        const std::size_t letters = run(is_letter);
        static const std::set<std::string> units{"D", "H", "M", "S", "MS"};
        const bool is_time = digits > 0 && units.count(in_capitals(text_.substr(at_, letters))) > 0;
        const std::size_t length = at_ + letters - begin;
        at_ = begin;
        add(is_time ? Word::Kind::time : Word::Kind::wrong, length);
    }
    void read_symbol() {
        for (const char* symbol : {":=", "=>", "..", "<>", "<=", ">=", "**"}) {
            if (text_.compare(at_, 2, symbol) == 0) return add(Word::Kind::symbol, 2);
        }
        const bool is_known = std::string("()[],;:.+-*/<>=&").find(here()) != std::string::npos;
        add(is_known ? Word::Kind::symbol : Word::Kind::wrong, 1);
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::vector<Word> words_;
};

/// A symbol of a rule: a rule's name, a word in its spelling, or a kind of words.
struct Symbol {
    enum class Kind : std::uint8_t { rule, reserved, free, identifier, integer, time, line_end };
    Kind kind = Kind::rule;
    std::size_t rule = 0;
    std::string text;
};

/// The grammar as plain rules: groups and repetitions have rules of their own.
class Grammar {
  public:
    explicit Grammar(const std::string& ebnf) {
        split(ebnf);
        while (at_ < words_.size()) {
            const std::size_t rule = rule_named(words_[at_++]);
            expect("=");
            read_alternatives(rule);
            expect(";");
        }
        for (std::size_t r = 0; r < rules.size(); ++r) {
            if (rules[r].empty()) throw std::runtime_error("no rule " + names_[r]);
        }
        find_nullable();
    }

    using Sequence = std::vector<Symbol>;
    std::vector<std::vector<Sequence>> rules;  ///< the alternatives of each
    std::vector<bool> nullable;

    std::size_t rule_named(const std::string& name) {
        const auto [found, is_new] = numbers_.emplace(name, rules.size());
        if (is_new) names_.push_back(name);
        if (is_new) rules.emplace_back();
        return found->second;
    }
    /// The words that are no names in what a rule is made of.
    std::set<std::string> reserved_in(std::size_t start) const;

  private:
    void split(const std::string& ebnf);
    void expect(const std::string& word) {
        if (at_ >= words_.size() || words_[at_] != word) throw std::runtime_error("no " + word);
        ++at_;
    }
    void read_alternatives(std::size_t rule);
    Symbol read_symbol();
    std::size_t new_rule() { return rule_named("#" + std::to_string(rules.size())); }
    void find_nullable();

    std::vector<std::string> words_;
    std::size_t at_ = 0;
    std::map<std::string, std::size_t> numbers_;
    std::vector<std::string> names_;
};

void Grammar::split(const std::string& ebnf) {
    for (std::size_t at = 0; at < ebnf.size();) {
        const char c = ebnf[at];
        std::size_t end = at + 1;
        if (c == '#') {
            end = ebnf.find('\n', at);
        } else if (c == '\'' || c == '"') {
            end = ebnf.find(c, at + 1) + 1;
        } else if (is_letter(c)) {
            while (is_letter(ebnf[end]) || ebnf[end] == '_') ++end;
        }
        if (c != '#' && c != ' ' && c != '\n') words_.push_back(ebnf.substr(at, end - at));
        at = end;
    }
}

void Grammar::read_alternatives(std::size_t rule) {
    std::vector<Sequence> alternatives(1);
    for (; at_ < words_.size(); ++at_) {
        const std::string& word = words_[at_];
        if (word == ";" || word == ")" || word == "]" || word == "}") break;
        if (word == "|") {
            alternatives.emplace_back();
        } else {
            alternatives.back().push_back(read_symbol());
        }
    }
    rules[rule] = std::move(alternatives);
}

/// Leaves the place at the last word of the symbol.
Symbol Grammar::read_symbol() {
    const std::string word = words_[at_];
    if (word.front() == '\'' || word.front() == '"') {
        const auto kind = word.front() == '"' ? Symbol::Kind::free : Symbol::Kind::reserved;
        return {kind, 0, word.substr(1, word.size() - 2)};
    }
    static const std::map<std::string, Symbol::Kind> kinds{{"identifier", Symbol::Kind::identifier},
                                                           {"integer", Symbol::Kind::integer},
                                                           {"time", Symbol::Kind::time},
                                                           {"EOL", Symbol::Kind::line_end}};
    if (const auto found = kinds.find(word); found != kinds.end()) return {found->second, 0, word};
    if (is_letter(word.front())) return {Symbol::Kind::rule, rule_named(word), word};
    const std::size_t group = new_rule();
    ++at_;
    read_alternatives(group);
    if (word == "[") rules[group].emplace_back();
    if (word != "{") return {Symbol::Kind::rule, group, word};
    const std::size_t repetition = new_rule();
    rules[repetition] = {
        {}, {{Symbol::Kind::rule, repetition, word}, {Symbol::Kind::rule, group, word}}};
    return {Symbol::Kind::rule, repetition, word};
}

void Grammar::find_nullable() {
    nullable.assign(rules.size(), false);
    for (bool changes = true; changes;) {
        changes = false;
        for (std::size_t r = 0; r < rules.size(); ++r) {
            const bool is_empty =
                std::any_of(rules[r].begin(), rules[r].end(), [&](const Sequence& sequence) {
                    return std::all_of(sequence.begin(), sequence.end(), [&](const Symbol& item) {
                        return item.kind == Symbol::Kind::rule && nullable[item.rule];
                    });
                });
            changes = changes || is_empty != nullable[r];
            nullable[r] = is_empty;
        }
    }
}

std::set<std::string> Grammar::reserved_in(std::size_t start) const {
    std::set<std::string> reserved;
    std::vector<bool> seen(rules.size(), false);
    std::vector<std::size_t> to_visit{start};
    while (!to_visit.empty()) {
        const std::size_t rule = to_visit.back();
        to_visit.pop_back();
        if (seen[rule]) continue;
        seen[rule] = true;
        for (const Sequence& sequence : rules[rule]) {
            for (const Symbol& item : sequence) {
                if (item.kind == Symbol::Kind::rule) to_visit.push_back(item.rule);
                if (item.kind == Symbol::Kind::reserved) reserved.insert(item.text);
            }
        }
    }
    return reserved;
}

class Parser {
  public:
    Parser(const Grammar& grammar, std::size_t start)
        : grammar_(grammar), start_(start), reserved_(grammar.reserved_in(start)) {}

    /// The number of the word that nothing of the grammar goes on with; that of all words where
    /// they are a start and where something is missing behind them.
    std::size_t stop_in(const std::vector<Word>& words, bool& is_whole) {
        sets_.clear();
        sets_.resize(words.size() + 1);
        predict(start_, 0);
        is_whole = false;
        for (std::size_t at = 0; at <= words.size(); ++at) {
            if (sets_[at].items.empty()) return at - 1;
            is_whole = false;
            for (std::size_t i = 0; i < sets_[at].items.size(); ++i) {
                const Item item = sets_[at].items[i];
                const Grammar::Sequence& sequence = grammar_.rules[item.rule][item.alternative];
                if (item.dot == sequence.size()) {
                    complete(item, at);
                    is_whole = is_whole || (item.rule == start_ && item.origin == 0);
                } else if (sequence[item.dot].kind == Symbol::Kind::rule) {
                    sets_[at].waiting[sequence[item.dot].rule].push_back(item);
                    predict(sequence[item.dot].rule, at);
                    if (grammar_.nullable[sequence[item.dot].rule]) add(advanced(item), at);
                } else if (at < words.size() && matches(sequence[item.dot], words[at])) {
                    add(advanced(item), at + 1);
                }
            }
        }
        return words.size();
    }

  private:
    struct Item {
        std::uint32_t rule = 0;
        std::uint32_t alternative = 0;
        std::uint32_t dot = 0;
        std::uint32_t origin = 0;
    };
    struct Set {
        std::vector<Item> items;
        std::unordered_set<std::uint64_t> known;
        std::map<std::size_t, std::vector<Item>> waiting;  ///< by the rule that they wait for
    };
    static Item advanced(Item item) {
        ++item.dot;
        return item;
    }
    void add(const Item& item, std::size_t at) {
        const std::uint64_t key = std::uint64_t{item.rule} << 48U |
                                  std::uint64_t{item.alternative} << 40U |
                                  std::uint64_t{item.dot} << 32U | item.origin;
        if (sets_[at].known.insert(key).second) sets_[at].items.push_back(item);
    }
    void predict(std::size_t rule, std::size_t at) {
        for (std::size_t a = 0; a < grammar_.rules[rule].size(); ++a) {
            add({static_cast<std::uint32_t>(rule), static_cast<std::uint32_t>(a), 0,
                 static_cast<std::uint32_t>(at)},
                at);
        }
    }
    void complete(const Item& item, std::size_t at) {
        const auto waiting = sets_[item.origin].waiting.find(item.rule);
        if (waiting == sets_[item.origin].waiting.end()) return;
        // Empty ones have been stepped over, and would add to the list that is gone through here.
        if (item.origin == at) return;
        for (const Item& next : waiting->second) add(advanced(next), at);
    }
    bool matches(const Symbol& symbol, const Word& word) const {
        switch (symbol.kind) {
            case Symbol::Kind::reserved:
            case Symbol::Kind::free:
                return word.kind != Word::Kind::wrong && word.text == symbol.text;
            case Symbol::Kind::identifier:
                return word.kind == Word::Kind::word && reserved_.count(word.text) == 0;
            case Symbol::Kind::integer:
                return word.kind == Word::Kind::integer;
            case Symbol::Kind::time:
                return word.kind == Word::Kind::time;
            case Symbol::Kind::line_end:
                return word.kind == Word::Kind::line_end;
            case Symbol::Kind::rule:
                break;
        }
        return false;
    }

    const Grammar& grammar_;
    std::size_t start_;
    std::set<std::string> reserved_;
    std::vector<Set> sets_;
};

/// Line ends are blanks but in instructions, where several are one.
std::vector<Word> without_idle_line_ends(const std::vector<Word>& words, bool has_instructions) {
    std::size_t first_instruction = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i].text == "END_VAR") first_instruction = i + 1;
    }
    std::vector<Word> kept;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool is_end = words[i].kind == Word::Kind::line_end;
        const bool counts = has_instructions && i > first_instruction && !kept.empty() &&
                            kept.back().kind != Word::Kind::line_end &&
                            kept.back().text != "END_VAR" &&
                            kept.back().text != "END_FUNCTION_BLOCK";
        if (!is_end || counts) kept.push_back(words[i]);
    }
    return kept;
}

}  // namespace

std::string misfit_in_iec(const std::string& text, const std::string& start) {
    static Grammar grammar(text_of(std::string(GRAFWIRE_ROOT) + "/tests/support/iec_61131_3.ebnf"));
    const std::vector<Word> words = without_idle_line_ends(Lexer(text).all(), start == "il_block");
    bool is_whole = false;
    const std::size_t stop = Parser(grammar, grammar.rule_named(start)).stop_in(words, is_whole);
    if (is_whole && stop == words.size()) return {};
    if (stop == words.size()) return "the text ends too early";
    const std::string word =
        words[stop].kind == Word::Kind::line_end ? "the end" : words[stop].text;
    return "line " + std::to_string(words[stop].line) + ": '" + word + "' does not fit";
}

}  // namespace grafwire::testing
