#pragma once

#include <span>
#include <string>
#include <vector>

#include "formats/shared/netlist_assembly.h"

namespace grafwire {

/// A logic function as a list of cubes, as BLIF has it: each row has a `0`, `1` or `-` per input,
/// and the function is `value` where a row fits, else the opposite.
struct Cover {
    std::vector<NetId> inputs;
    std::vector<std::string> rows;
    bool value = true;
};

/// Makes gates for a cover. A cover that is one gate (a product or sum of plain or of inverted
/// inputs, an exclusive or, a constant) becomes that gate; any other a sum of products with
/// inverters where needed.
void add_cover(NetlistAssembly& assembly, const Cover& cover, NetId output, Location where);

}  // namespace grafwire
