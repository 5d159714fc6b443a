#include "plc/shared/reserved_words.h"

#include <algorithm>
#include <iterator>

#include "text/characters.h"

namespace grafwire {

namespace {

constexpr std::string_view c_words[] = {
    // C99 and C11
    "auto", "break", "case", "char", "const", "continue", "default", "do", "double", "else", "enum",
    "extern", "float", "for", "goto", "if", "inline", "int", "long", "register", "restrict",
    "return", "short", "signed", "sizeof", "static", "struct", "switch", "typedef", "union",
    "unsigned", "void", "volatile", "while",
    // C23 and C++20
    "alignas", "alignof", "and", "and_eq", "asm", "bitand", "bitor", "bool", "catch", "char16_t",
    "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield", "compl", "concept",
    "const_cast", "consteval", "constexpr", "constinit", "decltype", "delete", "dynamic_cast",
    "explicit", "export", "false", "friend", "mutable", "namespace", "new", "noexcept", "not",
    "not_eq", "nullptr", "operator", "or", "or_eq", "private", "protected", "public",
    "reinterpret_cast", "requires", "static_assert", "static_cast", "template", "this",
    "thread_local", "throw", "true", "try", "typeid", "typename", "typeof", "typeof_unqual",
    "using", "virtual", "wchar_t", "xor", "xor_eq",
    // macros of the headers, and those that compilers define for their systems
    "BUFSIZ", "EOF", "INT16_C", "INT32_C", "INT64_C", "NULL", "SEEK_CUR", "SEEK_END", "SEEK_SET",
    "errno", "i386", "linux", "stderr", "stdin", "stdout", "unix"};

constexpr std::string_view arduino_words[] = {
    "INPUT_PULLUP", "LED_BUILTIN", "LSBFIRST",  "MSBFIRST",   "abs",     "bit",  "bitClear",
    "bitRead",      "bitSet",      "bitToggle", "bitWrite",   "boolean", "byte", "cli",
    "constrain",    "degrees",     "highByte",  "interrupts", "lowByte", "max",  "min",
    "noInterrupts", "radians",     "round",     "sei",        "sq",      "word"};

constexpr std::string_view pascal_words[] = {"absolute",
                                             "and",
                                             "array",
                                             "as",
                                             "asm",
                                             "begin",
                                             "bitpacked",
                                             "case",
                                             "class",
                                             "const",
                                             "constructor",
                                             "destructor",
                                             "dispinterface",
                                             "div",
                                             "do",
                                             "downto",
                                             "else",
                                             "end",
                                             "except",
                                             "exports",
                                             "false",
                                             "file",
                                             "finalization",
                                             "finally",
                                             "for",
                                             "function",
                                             "goto",
                                             "if",
                                             "implementation",
                                             "in",
                                             "inherited",
                                             "initialization",
                                             "inline",
                                             "interface",
                                             "is",
                                             "label",
                                             "library",
                                             "mod",
                                             "nil",
                                             "not",
                                             "object",
                                             "of",
                                             "on",
                                             "operator",
                                             "or",
                                             "out",
                                             "packed",
                                             "procedure",
                                             "program",
                                             "property",
                                             "raise",
                                             "record",
                                             "reintroduce",
                                             "repeat",
                                             "resourcestring",
                                             "self",
                                             "set",
                                             "shl",
                                             "shr",
                                             "string",
                                             "then",
                                             "threadvar",
                                             "to",
                                             "true",
                                             "try",
                                             "type",
                                             "unit",
                                             "until",
                                             "uses",
                                             "var",
                                             "while",
                                             "with",
                                             "xor"};

constexpr std::string_view python_words[] = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

template <std::size_t size>
bool holds(const std::string_view (&words)[size], std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

bool is_capital_or_digit(char c) {
    return (c >= 'A' && c <= 'Z') || is_digit(c);
}

bool looks_like_a_macro(std::string_view word) {
    if (word.size() < 2 || !std::all_of(word.begin(), word.end(), is_capital_or_digit)) {
        return false;
    }
    const bool is_step = word[0] == 'X' && std::all_of(word.begin() + 1, word.end(), is_digit);
    return !is_step;
}

}  // namespace

bool is_c_word(std::string_view word) {
    return holds(c_words, word);
}

bool is_arduino_word(std::string_view word) {
    return is_c_word(word) || holds(arduino_words, word) || looks_like_a_macro(word);
}

bool is_pascal_word(std::string_view word) {
    return holds(pascal_words, word);
}

bool is_python_word(std::string_view word) {
    return holds(python_words, word);
}

}  // namespace grafwire
