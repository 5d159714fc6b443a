#pragma once

#include <cstddef>
#include <string>

namespace bench {

/// One graph: steps in a ring, every eighth initial, so that tokens stand eight steps apart. The
/// receptivities are `a` and `b` by turns: each pulse of `a` then `b` moves every token two steps
/// on. A multiple of eight steps, at least 16.
std::string ring_chart(std::size_t steps);

/// One graph: parallel and selection structures nested in each other, each of four branches, down
/// to short sequences; the end leads back to the beginning. About so many steps.
std::string tree_chart(std::size_t steps);

/// The exercise of nine steps with more of its plain sequences side by side: two sequences are the
/// exercise itself.
std::string nine_steps_chart(std::size_t sequences);

}  // namespace bench
