#include "iec/identifiers.h"

#include <algorithm>

#include "text/characters.h"

namespace grafwire::iec {

std::string capitals(std::string_view name) {
    std::string result(name);
    for (char& c : result) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return result;
}

std::string small_letters(std::string_view name) {
    std::string result(name);
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
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
