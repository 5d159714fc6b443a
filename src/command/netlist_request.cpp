#include "command/netlist_request.h"

#include <vector>

namespace grafwire {

void NetlistRequest::declare(const CommandLine& line, bool style_is_required) {
    std::vector<std::string> styles;
    for (const StyleRow& row : style_table) styles.emplace_back(row.name);
    const AddedOption option =
        line.add("--style", style, "how the equations become cells").one_of(styles);
    if (style_is_required) {
        option.required();
    } else {
        style = "nand";
        option.shows_default();
    }
    line.add("--cdx", cdx, "form of CDX (default: successor; transition for clocked)")
        .one_of({"successor", "transition"});
    line.add("--modes", modes, "with Init, AUdur and AUdoux, or without")
        .one_of({"on", "off"})
        .shows_default();
}

Style NetlistRequest::style_id() const {
    for (const StyleRow& row : style_table) {
        if (row.name == style) return row.style;
    }
    return Style::nand;
}

CdxForm NetlistRequest::cdx_form() const {
    if (cdx.empty()) return style_table[static_cast<std::size_t>(style_id())].default_cdx;
    return cdx == "successor" ? CdxForm::successor : CdxForm::transition;
}

std::string_view NetlistRequest::cdx_name() const {
    return cdx_form() == CdxForm::successor ? "successor" : "transition";
}

std::optional<Netlist> make_netlist(const LoadedGrafcet& loaded, const NetlistRequest& request) {
    if (request.style_id() == Style::clocked && request.cdx_form() == CdxForm::successor) {
        complain(
            "the clocked style has the transition form of CDX only: leave out --cdx successor");
        return std::nullopt;
    }
    Equations equations =
        equations_from(loaded.grafcet, {request.cdx_form(), request.modes == "on"});
    Diagnostics diagnostics;
    auto netlist = netlist_from(equations, request.style_id(), diagnostics);
    show_diagnostics(diagnostics, loaded.source);
    return netlist;
}

}  // namespace grafwire
