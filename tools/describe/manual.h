#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command/description.h"

namespace grafwire {

/// A manual page in the language of man(7), and the name of its file: `grafwire-check.1`.
struct ManualPage {
    std::string file;
    std::string text;
};

/// The pages of the program and of each of its commands. `date`: of the version, as YYYY-MM-DD.
std::vector<ManualPage> manual_pages(const CommandDescription& program, std::string_view date,
                                     Language language);

}  // namespace grafwire
