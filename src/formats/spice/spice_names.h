#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// SPICE knows no difference between capital and small letters, and only letters, digits and `_`
/// are safe. A net keeps its name in small letters where that is free, with `_` for what is not
/// safe and a number where that is taken. No name begins with `_` or a digit.
class SpiceNames {
  public:
    explicit SpiceNames(const Netlist& netlist);

    std::string_view operator[](NetId net) const { return names_[index_of(net)]; }
    /// Whether more than the case of letters differs.
    bool is_changed(NetId net) const { return changed_[index_of(net)] != 0; }

  private:
    std::vector<std::string> names_;
    std::vector<std::uint8_t> changed_;
};

}  // namespace grafwire
