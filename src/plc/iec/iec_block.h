#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/message.h"
#include "text/safe_names.h"

namespace grafwire {

/// How a time condition is made of the standard function blocks (IEC 61131-3, 2.5.2.3.4).
enum class IecTimer {
    copy,   ///< no delay at all: the condition itself
    ton,    ///< on-delay only: TON, its Q is the value
    tof,    ///< off-delay only: TOF, its Q is the value
    latch,  ///< both: a bit that two TON set and reset
};
IecTimer iec_timer_for(Time on_delay, Time off_delay);

/// What the tables of the method are made of.
enum class IecTables {
    arrays,  ///< `Ts[X10]` is the X of step 10, `Ta[X10]` says that it is to be activated
    bits,    ///< a variable each: `X10`, `Ta_X10`
};

/// The names of a program in the textual languages of IEC 61131-3. They do not depend on case
/// there, and have no double underscores.
class IecNames {
  public:
    /// `is_reserved` is asked in lower case whether a word is one of the language.
    IecNames(const Grafcet& grafcet, const ScanProgram& program, IecTables tables,
             bool (*is_reserved)(std::string_view));

    std::string of(Bit bit) const;
    std::string of(IntegerCell cell) const;
    IecTables tables() const { return form_; }
    /// The array of a table of steps, transitions or graphs; empty where it is none.
    const std::string& table(BitKind kind) const { return tables_[static_cast<std::size_t>(kind)]; }
    /// The index of a step, transition or graph in its tables.
    const std::string& index_of(Bit bit) const;
    /// The function blocks of a time condition, by its place in Expressions::time_conditions.
    const std::string& on_timer(std::uint32_t time) const { return on_timers_[time]; }
    const std::string& off_timer(std::uint32_t time) const { return off_timers_[time]; }

    /// A name that nothing has yet, for a label.
    std::string new_label(std::string_view wanted) { return names_.claim(wanted); }
    /// One bit more that holds part of a condition, BitKind::auxiliary.
    void add_auxiliary();
    std::uint32_t auxiliary_count() const {
        return static_cast<std::uint32_t>(
            bits_[static_cast<std::size_t>(BitKind::auxiliary)].size());
    }

    std::string block;    ///< the function block itself
    std::string started;  ///< 1 after the first scan
    std::string any;      ///< the variable that runs through a table; of arrays

    /// Names that are not those of the chart, each with what it stands for there.
    const std::vector<std::pair<std::string, std::string>>& changed() const { return changed_; }

  private:
    std::string claim(const std::string& original);
    std::string claim(const std::string& wanted, const std::string& original);
    std::vector<std::string>& names_of(BitKind kind) {
        return bits_[static_cast<std::size_t>(kind)];
    }
    void claim_interface();
    void claim_tables();
    void claim_bits_of_tables();
    void claim_edges();
    void claim_times();
    /// `m` for an operand that is one variable, else the number.
    std::string operand_word(ExprId operand, std::size_t number) const;

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    IecTables form_;
    SafeNames names_;
    std::array<std::string, bit_kind_count> tables_;
    std::array<std::vector<std::string>, bit_kind_count> bits_;  ///< that are in no array
    std::vector<std::string> steps_, transitions_, graphs_;
    std::vector<std::string> on_timers_, off_timers_;
    std::vector<std::string> counters_, scratch_integers_;
    std::vector<std::pair<std::string, std::string>> changed_;
};

/// A comment of IEC 61131-3; a text that would end it early is written with a blank more.
std::string iec_comment(std::string_view text);

/// What a program in a textual language of IEC 61131-3 begins with: a comment that says what it is
/// and which names had to be changed, then `FUNCTION_BLOCK …` and its variables. The inputs and
/// outputs of the block are those of the chart, in its order, with Init, AUdur and AUdoux after the
/// declared inputs; the first block of internal variables holds the vars and counters of the chart.
/// `textual_language` is what the comment calls the language of IEC 61131-3.
///
/// An error where an integer needs more than the 64 bits of LINT; empty then.
std::string iec_declarations(const Grafcet& grafcet, const ScanProgram& program,
                             const IecNames& names, const Localized& textual_language,
                             const PlcOptions& options, Diagnostics& diagnostics);

}  // namespace grafwire
