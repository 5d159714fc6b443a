// Netlists have millions of nets, so their spellings lie one behind the other in one text, and a
// table of names is kept only for formats that cannot tell all names apart.

#include "formats/shared/net_spelling.h"

#include <algorithm>
#include <cassert>

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

NetSpelling::NetSpelling(const Netlist& netlist, Speller spell, SafeNames names) {
    std::vector<std::string> spelled(netlist.net_count());
    const auto claim = [&](NetId net, std::string_view name) {
        std::string word;
        spell(word, name);
        spelled[index_of(net)] = names.claim_word(std::move(word));
    };
    for (const Port& port : netlist.inputs) claim(port.net, port.name);
    for (const Port& port : netlist.outputs) {
        if (spelled[index_of(port.net)].empty()) claim(port.net, netlist.names[port.net]);
    }
    begins_.reserve(netlist.net_count() + 1);
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        if (spelled[i].empty()) claim(net, netlist.names[net]);
        begins_.push_back(text_.size());
        text_ += spelled[i];
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
        assert(is_percent_escaped(c));
        const auto byte = static_cast<unsigned char>(c);
        out.push_back('%');
        out.push_back(digits[byte >> 4]);
        out.push_back(digits[byte & 15]);
    }
}

namespace {

/// The value of a hexadecimal digit as append_percent_escaped() writes it; 16 of anything else.
unsigned digit_value(char c) {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    return c >= 'A' && c <= 'F' ? static_cast<unsigned>(c - 'A' + 10) : 16;
}

}  // namespace

std::string percent_decoded(std::string_view name) {
    std::string decoded;
    for (std::size_t i = 0; i < name.size(); ++i) {
        decoded += name[i];
        if (name[i] != '%' || i + 2 >= name.size()) continue;
        const unsigned high = digit_value(name[i + 1]);
        const unsigned low = digit_value(name[i + 2]);
        if (high > 7 || low > 15) continue;
        const char escaped = static_cast<char>(high * 16 + low);
        if (!is_percent_escaped(escaped)) continue;
        decoded.back() = escaped;
        i += 2;
    }
    return decoded;
}

/// Each look at the names is a pass over all nets, and nearly always the first is enough.
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
