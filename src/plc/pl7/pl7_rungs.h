#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "plc/pl7/pl7_objects.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// The rungs of one part of a PL7-2 program, as lines of text. Contacts can be negated, groups of
/// them cannot: negations are moved inwards, and an exclusive OR becomes two branches, or rungs of
/// its own beforehand where it has more than two operands. A COMPAR block compares a word with a
/// word or a number, and an OPERATE block adds two: longer sums are worked out beforehand as well.
class Pl7Rungs {
  public:
    explicit Pl7Rungs(Pl7Objects& objects) : objects_(objects) {}

    /// `** LABEL 3   comment`.
    void label(std::string_view comment);
    void rung(const Condition& condition, std::string_view coil) {
        line(contacts(condition), coil);
    }
    /// A rung whose contacts are written already.
    void line(std::string_view contacts, std::string_view coil);

    /// Whether the contacts of a condition need rungs for sums, or for parts of exclusive ORs.
    static bool has_sums(const Condition& condition);
    static bool has_long_exclusive_ors(const Condition& condition);
    /// The contacts of a condition; rungs for its parts are added here.
    std::string contacts(const Condition& condition);
    /// The word or number that a sum is; rungs for it are added here.
    std::string value(const Sum& sum);
    /// A word or number with the value held within limits, where there are any.
    std::string limited(const std::string& value, std::optional<std::int64_t> low,
                        std::optional<std::int64_t> high);

    const std::string& text() const { return text_; }
    std::uint32_t labels() const { return labels_; }

  private:
    Condition drawable(const Condition& condition);
    Condition worked_out(Condition condition);
    std::string series_or_parallel(const Condition& condition, bool in_series);
    std::string compare(const Comparison& comparison);
    std::string new_temporary();

    Pl7Objects& objects_;
    std::string text_;
    std::uint32_t labels_ = 0;
    std::set<std::string> temporaries_;  ///< words that hold a value for the next rungs
};

/// Writes statements of a program as rungs, each with its condition as contacts. An error for each
/// duration that no timer holds exactly.
class Pl7Statements {
  public:
    Pl7Statements(const Grafcet& grafcet, const ScanProgram& program, Pl7Objects& objects,
                  Pl7Rungs& rungs, Language language, Diagnostics& diagnostics)
        : grafcet_(grafcet),
          program_(program),
          objects_(objects),
          rungs_(rungs),
          language_(language),
          diagnostics_(diagnostics) {}

    /// Names the time conditions that are the end of a timer; before anything reads them.
    void name_timers();
    /// A label and the rungs of a statement of any kind but table.
    void write(const Statement& statement);

  private:
    void write_move(const Statement& statement);
    void write_time(const Statement& statement);
    void run_timer(const std::string& timer, Time duration, const Condition& condition,
                   Location where);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Pl7Objects& objects_;
    Pl7Rungs& rungs_;
    Language language_;
    Diagnostics& diagnostics_;
};

}  // namespace grafwire
