#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace grafwire::testing {

/// What the product gives for one random case, part by part.
struct PinnedCase {
    std::string summary;  ///< for people: a few words for each part
    std::string text;     ///< all of it

    void add(const std::string& few_words, const std::string& part) {
        summary += (summary.empty() ? "" : ", ") + few_words;
        text += part;
    }
};

/// What the product gives for many random cases, as a reviewed file with one line a case: the case,
/// a summary for people, and a digest of the whole text. Nobody has judged these texts one by one;
/// that they are right is what the other tests are for. Here a change that nobody meant shows,
/// however small: a count, an order, a word of an explanation.
///
/// A case that differs is shown with its whole text. After a change that was meant, `tools/bless
/// --tables` writes the file anew; the summaries in `git diff` then say which verdicts and counts
/// moved.
class PinnedTable {
  public:
    /// `name`: the file below tests/pinned/.
    explicit PinnedTable(std::string name);

    /// Compares a case. Keys are different from each other.
    void add(const std::string& key, const PinnedCase& pinned);
    /// At the end: with `is_whole`, the file has no other cases. Writes it where it is renewed.
    void finish(bool is_whole);

  private:
    std::string name_;
    std::map<std::string, std::string> expected_;  ///< the rest of the line by the key
    std::string lines_;                            ///< those of this run
    std::size_t count_ = 0;
};

/// The text as every version of the program writes it: without what says which one has.
std::string of_any_version(std::string text);

/// 64 bits of a text (FNV-1a; Fowler, Noll, Vo), as 16 hexadecimal digits.
std::string digest(std::string_view text);

}  // namespace grafwire::testing
