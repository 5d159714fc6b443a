// The shrinker knows little of the language: it drops lines and words, asks the parser whether what
// is left is still a GRAFCET, and the property whether it still fails. Transitions and actions go
// first, then what they spoke of can go as well. After Zeller and Hildebrandt, "Simplifying and
// isolating failure-inducing input" (2002), with the brackets of the language as a hint.

#include "random/shrink.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "random/read_text.h"

namespace grafwire::testing {

namespace {

using Parts = std::vector<std::string>;

Parts lines_of(const std::string& text) {
    Parts lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        lines.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

bool is_word_character(char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool is_high = (static_cast<unsigned char>(c) & 0x80U) != 0;
    return is_letter || is_high || (c >= '0' && c <= '9');
}

std::size_t word_length(std::string_view text) {
    static constexpr std::string_view symbols[] = {
        "↑", "↓", "⊕", "->", ":=", "..", "<=", ">=", "<>"};
    for (const std::string_view symbol : symbols) {
        if (text.substr(0, symbol.size()) == symbol) return symbol.size();
    }
    if (text[0] == '"') return std::min(text.find('"', 1), text.size() - 1) + 1;
    std::size_t length = 0;
    while (length < text.size() && is_word_character(text[length])) ++length;
    return std::max<std::size_t>(length, 1);
}

/// The words of a line, each with the white space before it, without the line break.
Parts words_of(const std::string& line) {
    Parts words;
    for (std::size_t begin = 0; begin < line.size();) {
        std::size_t at = line.find_first_not_of(" \n", begin);
        if (at == std::string::npos) break;
        at += word_length(std::string_view(line).substr(at));
        words.push_back(line.substr(begin, at - begin));
        begin = at;
    }
    return words;
}

std::string glued(const Parts& parts) {
    std::string text;
    for (const std::string& part : parts) text += part;
    return text;
}

std::string_view bare(const std::string& word) {
    const std::size_t begin = word.find_first_not_of(" \n");
    return begin == std::string::npos ? std::string_view() : std::string_view(word).substr(begin);
}

Parts without(const Parts& parts, std::size_t begin, std::size_t end) {
    Parts rest = parts;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(begin),
               rest.begin() + static_cast<std::ptrdiff_t>(end));
    return rest;
}

class Shrinker {
  public:
    Shrinker(const RandomCase& failing, const Property& property, std::size_t tries)
        : best_(failing), property_(property), tries_left_(tries) {}

    RandomCase run() {
        bool progress = true;
        while (progress && tries_left_ != 0) {
            progress = false;
            for (std::string RandomCase::*text : {&RandomCase::stimuli, &RandomCase::chart}) {
                progress |= drop_lines(text);
                if (text == &RandomCase::chart) progress |= drop_blocks();
                progress |= shorten_lines(text);
            }
        }
        return best_;
    }

  private:
    bool accept(std::string RandomCase::*text, const Parts& parts);
    bool drop_lines(std::string RandomCase::*text);
    bool drop_blocks();
    bool shorten_lines(std::string RandomCase::*text);
    bool shorten_line(std::string RandomCase::*text, Parts& lines, std::size_t line);
    bool try_line(std::string RandomCase::*text, Parts& lines, std::size_t line,
                  const Parts& words);

    RandomCase best_;
    const Property& property_;
    std::size_t tries_left_;
};

bool Shrinker::accept(std::string RandomCase::*text, const Parts& parts) {
    RandomCase trial = best_;
    trial.*text = glued(parts);
    if (trial.*text == best_.*text || tries_left_ == 0) return false;
    const auto grafcet = read_grafcet(trial.chart);
    if (!grafcet || !read_stimuli(trial.stimuli, *grafcet)) return false;
    --tries_left_;
    if (property_(trial).empty()) return false;
    best_ = std::move(trial);
    return true;
}

bool Shrinker::drop_lines(std::string RandomCase::*text) {
    bool progress = false;
    Parts lines = lines_of(best_.*text);
    for (std::size_t size = std::max<std::size_t>(lines.size() / 2, 1); size != 0; size /= 2) {
        for (std::size_t end = lines.size(); end >= size && end != 0;) {
            const Parts fewer = without(lines, end - size, end);
            if (accept(text, fewer)) {
                lines = fewer;
                progress = true;
            }
            end = std::min(end - 1, lines.size());
        }
    }
    return progress;
}

/// Whole graphs and expansions, the latter together with the line of their macro-step.
bool Shrinker::drop_blocks() {
    bool progress = false;
    Parts lines = lines_of(best_.chart);
    for (std::size_t begin = 0; begin < lines.size(); ++begin) {
        const bool is_graph = lines[begin].rfind("graph", 0) == 0;
        const bool is_expansion = lines[begin].rfind("expansion", 0) == 0;
        if (!is_graph && !is_expansion) continue;
        std::size_t end = begin;
        while (end < lines.size() && lines[end] != "}\n") ++end;
        if (end == lines.size()) break;
        const Parts fewer = without(lines, begin, end + 1);
        bool dropped = is_graph && accept(&RandomCase::chart, fewer);
        Parts rest = fewer;
        for (std::size_t i = 0; i < fewer.size() && is_expansion && !dropped; ++i) {
            if (fewer[i].find("macro") == std::string::npos) continue;
            rest = without(fewer, i, i + 1);
            dropped = accept(&RandomCase::chart, rest);
        }
        if (!dropped) continue;
        lines = rest;
        progress = true;
        --begin;
    }
    return progress;
}

bool Shrinker::try_line(std::string RandomCase::*text, Parts& lines, std::size_t line,
                        const Parts& words) {
    Parts changed = lines;
    changed[line] = glued(words) + "\n";
    if (!accept(text, changed)) return false;
    lines = std::move(changed);
    return true;
}

bool Shrinker::shorten_line(std::string RandomCase::*text, Parts& lines, std::size_t line) {
    const Parts words = words_of(lines[line]);
    for (std::size_t size = std::min<std::size_t>(words.size(), 24); size != 0; --size) {
        for (std::size_t begin = 0; begin + size <= words.size(); ++begin) {
            if (try_line(text, lines, line, without(words, begin, begin + size))) return true;
        }
    }
    for (std::size_t open = 0; open < words.size(); ++open) {
        if (bare(words[open]) != "(") continue;
        std::size_t close = open + 1;
        for (std::size_t depth = 1; close < words.size(); ++close) {
            if (bare(words[close]) == "(") ++depth;
            if (bare(words[close]) == ")" && --depth == 0) break;
        }
        if (close == words.size()) break;
        Parts simpler = without(words, open, close);
        simpler[open] = " 1";
        if (try_line(text, lines, line, simpler)) return true;
        if (try_line(text, lines, line,
                     without(without(words, close, close + 1), open, open + 1))) {
            return true;
        }
    }
    return false;
}

bool Shrinker::shorten_lines(std::string RandomCase::*text) {
    bool progress = false;
    Parts lines = lines_of(best_.*text);
    for (std::size_t line = 0; line < lines.size(); ++line) {
        while (tries_left_ != 0 && shorten_line(text, lines, line)) progress = true;
    }
    return progress;
}

}  // namespace

RandomCase shrunk(const RandomCase& failing, const Property& property, std::size_t tries) {
    return Shrinker(failing, property, tries).run();
}

}  // namespace grafwire::testing
