#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// How a file format writes a name down; appends to `out`. Different names must come out different.
using Speller = void (*)(std::string& out, std::string_view name);

/// The nets of a netlist as a file format spells them, worked out once. The net of an input port
/// goes under the name of the port.
class NetSpelling {
  public:
    NetSpelling(const Netlist& netlist, Speller spell);

    std::string_view operator[](NetId net) const {
        const std::size_t index = index_of(net);
        return std::string_view(text_).substr(begins_[index], begins_[index + 1] - begins_[index]);
    }

    /// Of all nets together, in bytes.
    std::size_t length() const { return text_.size(); }

  private:
    std::string text_;
    std::vector<std::uint64_t> begins_;
};

/// Writes the characters that `is_unsafe` names, and `%` itself, as `%` and two hexadecimal digits.
/// The readers undo this.
void append_percent_escaped(std::string& out, std::string_view name, bool (*is_unsafe)(char));

/// White space and other control characters: no format can hold these in a name.
constexpr bool is_control_or_blank(char c) {
    return static_cast<unsigned char>(c) <= 0x20 || c == 0x7f;
}

/// A suffix (`$g`, `$gg`, …) that no net name ends with: names of cells are made with it, where
/// nets and cells share one name space.
std::string cell_suffix(const Netlist& netlist);

}  // namespace grafwire
