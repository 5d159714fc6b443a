#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "command/command_line.h"
#include "command/inputs.h"
#include "equations/equations.h"
#include "netlist/styles/netlist_from.h"

namespace grafwire {

/// The options that say which netlist to make; shared by several commands.
struct NetlistRequest {
    std::string style;
    std::string cdx;
    std::string modes = "on";
    void declare(const CommandLine& line, bool style_is_required);
    /// The form of CDX that results.
    CdxForm cdx_form() const;
    std::string_view cdx_name() const;
    Style style_id() const;
};

/// The generated netlist, with messages shown; empty after an error.
std::optional<Netlist> make_netlist(const LoadedGrafcet& loaded, const NetlistRequest& request);

}  // namespace grafwire
