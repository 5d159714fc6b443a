#include "s7/io_assignment.h"

namespace grafwire::s7 {

const Operand* IoAssignment::operand_of(std::string_view name) const {
    for (const Entry& entry : entries) {
        if (entry.name == name) return &entry.operand;
    }
    return nullptr;
}

}  // namespace grafwire::s7
