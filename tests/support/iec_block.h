#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "support/iec_lexer.h"

namespace grafwire::testing {

enum class IecType { boolean, literal, int16, int32, int64, time, ton, tof, step };

/// A value with its type; a `literal` is a whole number that fits any integer type.
struct IecValue {
    IecType type = IecType::boolean;
    std::int64_t value = 0;
};

bool is_integer(IecType type);
/// The type of a name in lower case; an error where it is none.
IecType iec_type_named(const std::string& name, std::size_t line);

/// One variable of a function block: a value, an array of values, a timer, or the flag of a step.
struct IecVariable {
    IecType type = IecType::boolean;
    bool is_array = false;
    bool is_constant = false;
    bool is_input = false;
    std::int64_t first_index = 0;
    std::vector<std::int64_t> values;
    // Of a timer (TON, TOF: 2.5.2.3.4).
    bool q = false;
    bool runs = false;
    Time since = 0;
};

/// The variables of a function block, and its name. Types are strict: nothing is converted, an
/// integer that leaves the range of its type is an error, so is an index beyond its array.
class IecBlock {
  public:
    /// Declares a variable; an error where the name is taken.
    void declare(const std::string& name, const IecVariable& variable, std::size_t line);
    /// Reads `FUNCTION_BLOCK name` and its declarations.
    void read_declarations(IecTokenCursor& cursor);

    IecVariable& variable(const std::string& name, std::size_t line);
    IecValue load(const std::string& name, const IecValue* index, std::size_t line);
    void store(const std::string& name, const IecValue* index, IecValue value, std::size_t line);
    /// The output Q of a timer, the flag X of a step.
    IecValue field(const std::string& name, const std::string& field, std::size_t line);
    bool timer_output(const std::string& name, std::size_t line);
    void call_timer(const std::string& name, bool in, Time pt, Time now, std::size_t line);

    /// The names declared in each block of declarations, in order: `VAR_INPUT`, `VAR_OUTPUT`,
    /// `VAR`, `VAR CONSTANT`, all in lower case.
    std::vector<std::pair<std::string, std::vector<std::string>>> sections;
    std::unordered_map<std::string, IecVariable> variables;

  private:
    void read_section(IecTokenCursor& cursor, const std::string& kind);
    std::int64_t& cell(IecVariable& variable, const IecValue* index, std::size_t line);
};

/// The sum or difference of two integers of one type; an error where it leaves the type.
IecValue add_integers(IecValue left, IecValue right, bool subtract, std::size_t line);
/// -1, 0 or 1 for less, equal, greater; an error for values of different types.
int compare_values(IecValue left, IecValue right, std::size_t line);

/// A machine whose program is a function block; the body is executed by the language.
class IecMachine : public PlcMachine {
  public:
    explicit IecMachine(const Grafcet& grafcet) : grafcet_(grafcet) {}

    void set_input(std::uint32_t index, bool value) override;
    bool step(std::uint32_t index) const override;
    bool output(std::uint32_t index) const override;
    bool var(std::uint32_t index) const override;
    std::int64_t counter(std::uint32_t index) const override;

  protected:
    /// The name of the n-th variable of the first section of a kind.
    const std::string& name_in(const std::string& section, std::size_t index) const;

    IecBlock block_;
    const Grafcet& grafcet_;
};

}  // namespace grafwire::testing
