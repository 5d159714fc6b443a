#pragma once

#include <functional>

namespace grafwire {

/// Asked every now and then during work that may take long, many times a second; the work is broken
/// off once it says no. An empty one lets everything run to its end.
using KeepGoing = std::function<bool()>;

}  // namespace grafwire
