#pragma once

#include <optional>
#include <string>

#include "grafcet/grafcet.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

/// The GRAFCET of a text, or nothing; `messages` (if not null) receives what there is to say.
std::optional<Grafcet> read_grafcet(const std::string& text, std::string* messages = nullptr);
std::optional<Stimuli> read_stimuli(const std::string& text, const Grafcet& grafcet,
                                    std::string* messages = nullptr);

}  // namespace grafwire::testing
