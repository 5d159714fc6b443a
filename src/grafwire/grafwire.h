#pragma once

// The library of grafwire: from a GRAFCET (IEC 60848) to wiring, and a proof that the wiring is
// right. Everything is a function from values to values; nothing reads or writes a file, prints,
// ends the program or keeps a state between two calls.

#include "grafwire/check.h"
#include "grafwire/equations.h"
#include "grafwire/netlist.h"
#include "grafwire/read.h"
#include "grafwire/simulate.h"
#include "grafwire/version.h"
#include "grafwire/write.h"
