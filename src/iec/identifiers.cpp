// Names of a chart that are identifiers already keep their spelling, whatever the order of the
// names: an engineer finds `dcy` in the program as `dcy`, even where another name of the chart,
// such as `dçy`, would become the same. So there are two passes over a group of names, and only the
// second makes up new ones.

#include "iec/identifiers.h"

#include <algorithm>
#include <iterator>

#include "text/utf8.h"

namespace grafwire::iec {

namespace {

// In the order of bytes, for binary search.
// clang-format off
constexpr std::string_view keywords[] = {
    "abs", "acos", "action", "add", "and", "andn", "any", "any_bit", "any_date", "any_derived",
    "any_elementary", "any_int", "any_magnitude", "any_num", "any_real", "any_string", "array",
    "asin", "at", "atan", "bool", "by", "byte", "cal", "calc", "calcn", "case", "cdt",
    "concat", "configuration", "constant", "continue", "cos", "ctd", "ctu", "ctud", "date",
    "date_and_time", "delete", "dint", "div", "do", "dt", "dword", "else", "elsif", "en",
    "end_action", "end_case", "end_configuration", "end_for", "end_function",
    "end_function_block", "end_if", "end_program", "end_repeat", "end_resource", "end_step",
    "end_struct", "end_transition", "end_type", "end_var", "end_while", "eno", "eq", "exit",
    "exp", "expt", "f_edge", "f_trig", "false", "find", "for", "from", "function",
    "function_block", "ge", "gt", "if", "initial_step", "insert", "int", "interval", "jmp",
    "jmpc", "jmpcn", "ld", "ldate", "ldn", "ldt", "le", "left", "len", "limit", "lint", "ln",
    "log", "lreal", "lt", "ltime", "ltod", "lword", "max", "mid", "min", "mod", "move", "mul",
    "mux", "namespace", "ne", "non_retain", "not", "of", "on", "or", "orn", "overlap",
    "override", "pointer", "priority", "program", "r", "r_edge", "r_trig", "read_only",
    "read_write", "real", "ref", "ref_to", "repeat", "replace", "resource", "ret", "retain",
    "retc", "retcn", "return", "right", "rol", "ror", "rs", "rtc", "s", "sel", "sema", "shl",
    "shr", "sin", "single", "sint", "sqrt", "sr", "st", "step", "stn", "string", "struct",
    "sub", "super", "tan", "task", "then", "this", "time", "time_of_day", "to", "tod", "tof",
    "ton", "tp", "transition", "true", "trunc", "type", "udint", "uint", "ulint", "until",
    "using", "usint", "var", "var_access", "var_config", "var_external", "var_global",
    "var_in_out", "var_input", "var_output", "var_temp", "while", "with", "word", "wstring",
    "xor", "xorn"
};
// clang-format on

/// The operators of Instruction List that fill an input of a function block (2nd edition, table
/// 53).
constexpr std::string_view il_input_operators[] = {"cd", "clk", "cu", "in", "pt", "pv", "r1", "s1"};

}  // namespace

bool is_keyword(std::string_view word) {
    return std::binary_search(std::begin(keywords), std::end(keywords), word);
}

bool is_il_keyword(std::string_view word) {
    return is_keyword(word) ||
           std::binary_search(std::begin(il_input_operators), std::end(il_input_operators), word);
}

std::string capitals(std::string_view name) {
    std::string result(name);
    for (char& c : result) c = upper_case(c);
    return result;
}

std::string small_letters(std::string_view name) {
    std::string result(name);
    for (char& c : result) c = lower_case(c);
    return result;
}

bool is_identifier(std::string_view name) {
    if (name.empty() || is_digit(name.front()) || name.back() == '_') return false;
    const bool is_plain = std::all_of(name.begin(), name.end(), [](char c) {
        return is_ascii_letter(c) || is_digit(c) || c == '_';
    });
    return is_plain && name.find("__") == std::string_view::npos &&
           !is_keyword(small_letters(name));
}

std::vector<std::string> Identifiers::add(const std::vector<std::string>& names) {
    std::vector<std::string> identifiers(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (is_identifier(names[i]) && names_.keep(names[i])) identifiers[i] = names[i];
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (identifiers[i].empty()) identifiers[i] = names_.claim(names[i]);
    }
    return identifiers;
}

}  // namespace grafwire::iec
