#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"
#include "text/safe_names.h"

namespace grafwire {

/// How a file format writes a name down; appends to `out`.
using Speller = void (*)(std::string& out, std::string_view name);

/// The nets of a netlist as a file format spells them, worked out once. The net of an input port
/// goes under the name of the port.
class NetSpelling {
  public:
    /// Of a speller under which different names come out different.
    NetSpelling(const Netlist& netlist, Speller spell);
    /// Of any other, in a language where case matters, or not, as in `names`: where two nets would
    /// be spelled alike, or a net like a word of the language, a number follows. Ports come first,
    /// since they are what users look for.
    NetSpelling(const Netlist& netlist, Speller spell, SafeNames names);

    std::string_view operator[](NetId net) const {
        const std::size_t index = index_of(net);
        const auto begin = static_cast<std::size_t>(begins_[index]);
        const auto end = static_cast<std::size_t>(begins_[index + 1]);
        return std::string_view(text_).substr(begin, end - begin);
    }

    /// Of all nets together, in bytes.
    std::size_t length() const { return text_.size(); }

  private:
    std::string text_;
    std::vector<std::uint64_t> begins_;
};

/// White space and other control characters: no format can hold these in a name.
constexpr bool is_control_or_blank(char c) {
    return static_cast<unsigned char>(c) <= 0x20 || c == 0x7f;
}

/// Whether some format writes a character of a name as `%` and two hexadecimal digits; all that do
/// so write `%` itself as `%25`.
constexpr bool is_percent_escaped(char c) {
    return is_control_or_blank(c) ||
           std::string_view("%#=\\\"`*").find(c) != std::string_view::npos;
}

/// Writes the characters that `is_unsafe` names, and `%` itself, as `%` and two hexadecimal digits.
/// They must be among those of is_percent_escaped().
void append_percent_escaped(std::string& out, std::string_view name, bool (*is_unsafe)(char));

/// Undoes this, whichever format the name was written for: files are taken from one to another by
/// Yosys. Other percent signs stay.
std::string percent_decoded(std::string_view name);

/// A suffix (`$g`, `$gg`, …) that no net name ends with: names of cells are made with it, where
/// nets and cells share one name space.
std::string cell_suffix(const Netlist& netlist);

}  // namespace grafwire
