#pragma once

#include "text/message.h"

namespace grafwire::messages::plc_iec {

inline constexpr Message<> sum_too_wide{
    "a sum needs more than the 64 bits of LINT; make the ranges of its counters smaller",
    "une somme demande plus que les 64 bits de LINT ; réduisez les plages de ses compteurs"};

}  // namespace grafwire::messages::plc_iec
