// The library that writes FST, by the author of GTKWave. Debian has no package of it; its source
// comes with Verilator, which includes it in a file of C++ in the same way.

#ifdef GRAFWIRE_HAS_FST

#define FST_CONFIG_INCLUDE "gtkwave/fst_config.h"
#include "gtkwave/fastlz.c"  // NOLINT(bugprone-suspicious-include)
#include "gtkwave/fstapi.c"  // NOLINT(bugprone-suspicious-include)
#include "gtkwave/lz4.c"     // NOLINT(bugprone-suspicious-include)

#endif
