// A netlist is a handle: it keeps the chart that it is for, and what reports call it.

#include "grafwire/netlist.h"

#include "grafwire/messages.h"
#include "grafwire/parts.h"
#include "text/joined.h"

namespace grafwire::api {

std::vector<std::string> styles() {
    std::vector<std::string> names;
    for (const StyleRow& row : style_table) names.emplace_back(row.name);
    return names;
}

Result<Netlist> make_netlist(const Chart& chart, const NetlistOptions& options) {
    const StyleRow* style = style_named(options.style);
    if (style == nullptr) {
        return {std::nullopt,
                {error(messages::library::unknown_style(options.style, joined(styles(), ", ")))}};
    }
    grafwire::NetlistOptions asked{style->style, std::nullopt, options.modes};
    if (options.cdx) asked.cdx = form_from(*options.cdx);
    Diagnostics diagnostics;
    auto netlist = grafwire::make_netlist(chart.parts().chart, asked, diagnostics);
    Result<Netlist> result{std::nullopt, messages_from(diagnostics)};
    if (netlist) {
        result.value = Netlist(std::make_shared<const Netlist::Parts>(Netlist::Parts{
            chart, std::move(*netlist), options.style, std::string(name_of(cdx_form(asked))), ""}));
    }
    return result;
}

/// Ports that do not fit are an error where nothing can be compared, a warning elsewhere.
Result<Netlist> read_netlist(const Chart& chart, std::string text, std::string_view format,
                             std::string name, bool starts_initially) {
    const NetlistFormat* row = netlist_format_named(format);
    if (row == nullptr || row->read == nullptr) {
        return {std::nullopt, {error(messages::library::no_format_to_read(format))}};
    }
    Diagnostics diagnostics;
    auto netlist = row->read({name, std::move(text)}, diagnostics);
    Result<Netlist> result{std::nullopt, messages_from(diagnostics)};
    if (!netlist) return result;
    const PortComparison ports = fit_netlist(chart.parts().chart, *netlist, starts_initially);
    if (!ports.fits()) {
        Message message = error(port_table(ports));
        if (ports.can_compare()) message.severity = Message::Severity::warning;
        result.messages.push_back(std::move(message));
    }
    if (!ports.can_compare()) return result;
    result.value = Netlist(std::make_shared<const Netlist::Parts>(
        Netlist::Parts{chart, std::move(*netlist), "", "", std::move(name)}));
    return result;
}

Chart Netlist::chart() const {
    return parts_->chart;
}

bool Netlist::is_clocked() const {
    return parts_->netlist.is_clocked();
}

std::size_t Netlist::cell_count() const {
    return parts_->netlist.cells.size();
}

std::vector<std::string> Netlist::inputs() const {
    std::vector<std::string> names;
    for (const auto& port : parts_->netlist.inputs) names.push_back(port.name);
    return names;
}

std::vector<std::string> Netlist::outputs() const {
    std::vector<std::string> names;
    for (const auto& port : parts_->netlist.outputs) names.push_back(port.name);
    return names;
}

}  // namespace grafwire::api
