#pragma once

#include <string_view>

namespace grafwire {

// Words that a program must not use as names of its own.

/// Keywords of C and C++, and macros of the headers that the programs include.
bool is_c_word(std::string_view word);

/// Those, and the macros and types of the Arduino core and of the headers of its processors (AVR):
/// `INPUT`, `PORTB`, `PB0`, `word`. Some words that look like such a macro are taken for one:
/// `PB9`.
bool is_arduino_word(std::string_view word);

/// Keywords of Free Pascal and Turbo Pascal, in lower case.
bool is_pascal_word(std::string_view word);

/// Keywords of Python 3.
bool is_python_word(std::string_view word);

}  // namespace grafwire
