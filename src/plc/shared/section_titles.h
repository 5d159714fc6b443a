#pragma once

#include <string_view>

#include "program/program.h"

namespace grafwire {

/// What a section of the scan does, with the subroutine of the method that it is (Cordier, "Méthode
/// d'implémentation du GRAFCET" (1998), section 5): `SBR 3: receptivities`.
std::string_view section_title(SectionKind kind);

}  // namespace grafwire
