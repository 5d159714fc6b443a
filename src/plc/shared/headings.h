#pragma once

#include "program/program.h"
#include "text/message.h"

namespace grafwire {

/// What a section of the scan does, with the subroutine of the method that it is (Cordier, "Méthode
/// d'implémentation du GRAFCET" (1998), section 5): `SBR 3: transition conditions`.
Localized section_title(SectionKind kind);

}  // namespace grafwire
