#include "plc/shared/headings.h"

#include "plc/shared/messages.h"

namespace grafwire {

Localized section_title(SectionKind kind) {
    namespace say = messages::plc_shared;
    switch (kind) {
        case SectionKind::start:
            return say::section_start();
        case SectionKind::begin:
            return say::section_begin();
        case SectionKind::edges:
            return say::section_edges();
        case SectionKind::conditions:
            return say::section_conditions();
        case SectionKind::evolution:
            return say::section_evolution();
        case SectionKind::orders:
            return say::section_orders();
        case SectionKind::stored:
            return say::section_stored();
        case SectionKind::times:
            return say::section_times();
        case SectionKind::outputs:
            return say::section_outputs();
    }
    return {};
}

}  // namespace grafwire
