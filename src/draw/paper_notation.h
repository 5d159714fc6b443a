#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/scene.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// How NOT is written: a line over what is complemented, or `/` before it.
enum class NotSign : std::uint8_t { overline, slash };

/// A condition as on paper, in lines of at most `width` units where it can be broken at `+` or `·`:
/// `a·b̅ + ↑c`, `3s/X5`, `[C1 ≥ 3]`; 1 is underlined.
std::vector<Text> condition_on_paper(const Grafcet& grafcet, ExprId id, NotSign sign, double width);

/// The same in one line.
Text condition_on_paper(const Grafcet& grafcet, ExprId id, NotSign sign);

/// What a stored action does: `C := C + 1`, `V := a·b`; set and reset are `V := 1` and `V := 0`.
Text write_on_paper(const Grafcet& grafcet, const Write& write, NotSign sign);

/// An order: `G1{10,20}`, `G1{*}`, `G1{}`, `G1{INIT}`.
std::string order_on_paper(const Grafcet& grafcet, const Order& order);

}  // namespace grafwire
