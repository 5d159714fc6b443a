#include "export/net_spelling.h"

namespace grafwire {

NetSpelling::NetSpelling(const Netlist& netlist, Speller spell) {
    std::vector<const std::string*> port_names(netlist.net_count());
    for (const Port& port : netlist.inputs) port_names[index_of(port.net)] = &port.name;
    begins_.reserve(netlist.net_count() + 1);
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        begins_.push_back(text_.size());
        const std::string* port_name = port_names[i];
        spell(text_, port_name != nullptr ? *port_name : netlist.names[static_cast<NetId>(i)]);
    }
    begins_.push_back(text_.size());
}

void append_percent_escaped(std::string& out, std::string_view name, bool (*is_unsafe)(char)) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    for (const char c : name) {
        if (c != '%' && !is_unsafe(c)) {
            out.push_back(c);
            continue;
        }
        const auto byte = static_cast<unsigned char>(c);
        out.push_back('%');
        out.push_back(digits[byte >> 4]);
        out.push_back(digits[byte & 15]);
    }
}

std::string cell_suffix(const Netlist& netlist) {
    std::string suffix = "$g";
    const auto is_taken = [&] {
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            if (netlist.names[static_cast<NetId>(i)].ends_with(suffix)) return true;
        }
        return false;
    };
    while (is_taken()) suffix += 'g';
    return suffix;
}

}  // namespace grafwire
