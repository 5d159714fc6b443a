#include "plc/shared/section_titles.h"

namespace grafwire {

std::string_view section_title(SectionKind kind) {
    switch (kind) {
        case SectionKind::start:
            return "SBR 0: before the first scan, the initial situation";
        case SectionKind::begin:
            return "SBR 1: the situation the scan begins with; work tables cleared";
        case SectionKind::edges:
            return "SBR 2: edges";
        case SectionKind::receptivities:
            return "SBR 3: receptivities";
        case SectionKind::evolution:
            return "SBR 4: evolution, rules 2 to 5";
        case SectionKind::orders:
            return "SBR 5: orders and enclosures";
        case SectionKind::stored:
            return "SBR 5, end: stored actions";
        case SectionKind::times:
            return "SBR 6: time conditions";
        case SectionKind::outputs:
            return "SBR 8: outputs";
    }
    return {};
}

}  // namespace grafwire
