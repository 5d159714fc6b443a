#include "ladder/identifiers.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "text/utf8.h"

namespace grafwire::ladder {

namespace {

/// Keywords of IEC 61131-3 (annex C) and the standard functions and blocks that programs here use.
constexpr std::string_view keywords[] = {"ABS",
                                         "ACTION",
                                         "ADD",
                                         "AND",
                                         "ANY",
                                         "ANY_BIT",
                                         "ANY_DATE",
                                         "ANY_INT",
                                         "ANY_NUM",
                                         "ANY_REAL",
                                         "ARRAY",
                                         "ASIN",
                                         "AT",
                                         "BOOL",
                                         "BY",
                                         "BYTE",
                                         "CAL",
                                         "CALC",
                                         "CALCN",
                                         "CASE",
                                         "CD",
                                         "CDT",
                                         "CLK",
                                         "CONCAT",
                                         "CONFIGURATION",
                                         "CONSTANT",
                                         "COS",
                                         "CTD",
                                         "CTU",
                                         "CTUD",
                                         "CU",
                                         "CV",
                                         "DATE",
                                         "DATE_AND_TIME",
                                         "DELETE",
                                         "DINT",
                                         "DIV",
                                         "DO",
                                         "DS",
                                         "DT",
                                         "DWORD",
                                         "ELSE",
                                         "ELSIF",
                                         "EN",
                                         "END_ACTION",
                                         "END_CASE",
                                         "END_FOR",
                                         "END_FUNCTION",
                                         "END_IF",
                                         "END_PROGRAM",
                                         "END_REPEAT",
                                         "END_STEP",
                                         "END_STRUCT",
                                         "END_TRANSITION",
                                         "END_TYPE",
                                         "END_VAR",
                                         "END_WHILE",
                                         "ENO",
                                         "EQ",
                                         "ET",
                                         "EXIT",
                                         "EXP",
                                         "FALSE",
                                         "FIND",
                                         "FOR",
                                         "FROM",
                                         "FUNCTION",
                                         "FUNCTION_BLOCK",
                                         "F_EDGE",
                                         "F_TRIG",
                                         "GE",
                                         "GT",
                                         "IF",
                                         "IN",
                                         "INITIAL_STEP",
                                         "INSERT",
                                         "INT",
                                         "INTERVAL",
                                         "JMP",
                                         "JMPC",
                                         "JMPCN",
                                         "LD",
                                         "LDN",
                                         "LE",
                                         "LEFT",
                                         "LEN",
                                         "LIMIT",
                                         "LINT",
                                         "LN",
                                         "LOG",
                                         "LREAL",
                                         "LT",
                                         "LWORD",
                                         "MAX",
                                         "MID",
                                         "MIN",
                                         "MOD",
                                         "MOVE",
                                         "MUL",
                                         "MUX",
                                         "NE",
                                         "NOT",
                                         "OF",
                                         "ON",
                                         "OR",
                                         "ORN",
                                         "PRIORITY",
                                         "PROGRAM",
                                         "PT",
                                         "PV",
                                         "Q",
                                         "R",
                                         "REAL",
                                         "REPEAT",
                                         "RET",
                                         "RETAIN",
                                         "RETURN",
                                         "RS",
                                         "R_EDGE",
                                         "R_TRIG",
                                         "S",
                                         "SEL",
                                         "SINT",
                                         "SR",
                                         "ST",
                                         "STEP",
                                         "STRING",
                                         "SUB",
                                         "TASK",
                                         "THEN",
                                         "TIME",
                                         "TO",
                                         "TOD",
                                         "TOF",
                                         "TON",
                                         "TP",
                                         "TRANSITION",
                                         "TRUE",
                                         "TYPE",
                                         "UDINT",
                                         "UINT",
                                         "UNTIL",
                                         "VAR",
                                         "VAR_EXTERNAL",
                                         "VAR_GLOBAL",
                                         "VAR_INPUT",
                                         "VAR_IN_OUT",
                                         "VAR_OUTPUT",
                                         "WHILE",
                                         "WITH",
                                         "WORD",
                                         "XOR"};

bool is_keyword(std::string_view name) {
    return std::binary_search(std::begin(keywords), std::end(keywords), name);
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The base letters of U+00C0 to U+00FF.
constexpr std::string_view latin =
    "AAAAAAACEEEEIIIIDNOOOOO_OUUUUYTsaaaaaaaceeeeiiiidnooooo_ouuuuyty";

std::string spelled(char32_t c) {
    static constexpr std::pair<char32_t, std::string_view> words[] = {
        {U'+', "_plus_"}, {U'-', "_minus_"}, {U'↑', "rise_"}, {U'↓', "fall_"}, {U'=', "_eq_"},
        {U'<', "_lt_"},   {U'>', "_gt_"},    {U'/', "_"},     {U'.', "_"},     {U'\'', "_"},
        {U'&', "_and_"},  {U'*', "_times_"}, {U'%', "_pc_"}};
    for (const auto& [character, word] : words) {
        if (character == c) return std::string(word);
    }
    if (c >= 0xC0 && c <= 0xFF) return std::string(1, latin[c - 0xC0]);
    return "_";
}

std::string made_safe(std::string_view name) {
    std::string rough;
    for (std::size_t at = 0; at < name.size();) {
        const CodePoint c = decode_utf8(name, at);
        const bool plain = c.length <= 1 && (is_letter(name[at]) || is_digit(name[at]));
        rough += plain ? std::string(1, name[at]) : spelled(c.value);
        at += std::max(c.length, 1U);
    }
    std::string safe;
    for (const char c : rough) {
        if (c == '_' && (safe.empty() || safe.back() == '_')) continue;
        safe += c;
    }
    if (!safe.empty() && safe.back() == '_') safe.pop_back();
    if (safe.empty() || is_digit(safe.front())) safe.insert(0, "n");
    return safe;
}

}  // namespace

std::string capitals(std::string_view name) {
    std::string result(name);
    for (char& c : result) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return result;
}

bool is_identifier(std::string_view name) {
    if (name.empty() || is_digit(name.front()) || name.back() == '_') return false;
    char last = 0;
    for (const char c : name) {
        if (!is_letter(c) && !is_digit(c) && c != '_') return false;
        if (c == '_' && last == '_') return false;
        last = c;
    }
    return !is_keyword(capitals(name));
}

bool Identifiers::take(const std::string& identifier) {
    return is_identifier(identifier) && taken_.insert(capitals(identifier)).second;
}

std::vector<std::string> Identifiers::add(const std::vector<std::string>& names) {
    std::vector<std::string> identifiers(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (take(names[i])) identifiers[i] = names[i];
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!identifiers[i].empty()) continue;
        const std::string safe = made_safe(names[i]);
        std::string identifier = safe;
        for (std::size_t n = 2; !take(identifier); ++n) identifier = fmt::format("{}_{}", safe, n);
        identifiers[i] = identifier;
    }
    return identifiers;
}

}  // namespace grafwire::ladder
