#include "formats/shared/net_spelling.h"

#include <algorithm>

namespace grafwire {

NetSpelling::NetSpelling(const Netlist& netlist, Speller spell) {
    // Input ports in the order of their nets; of two on one net the last one counts.
    std::vector<const Port*> inputs;
    for (const Port& port : netlist.inputs) inputs.push_back(&port);
    std::stable_sort(inputs.begin(), inputs.end(),
                     [](const Port* a, const Port* b) { return a->net < b->net; });
    auto input = inputs.begin();
    begins_.reserve(netlist.net_count() + 1);
    text_.reserve(netlist.names.length() + netlist.names.length() / 4);
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        begins_.push_back(text_.size());
        std::string_view name = netlist.names[net];
        for (; input != inputs.end() && (*input)->net == net; ++input) name = (*input)->name;
        spell(text_, name);
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
