#include "ladder/ladder.h"

#include <fmt/format.h>

#include <utility>

#include "iec/literals.h"
#include "program/bit_names.h"

namespace grafwire::ladder {

namespace {

Power combined(Power::Kind kind, std::vector<Power> parts) {
    Power whole;
    whole.kind = kind;
    for (Power& part : parts) {
        if (part.kind == Power::Kind::wire && kind == Power::Kind::series) continue;
        if (part.kind != kind) {
            whole.parts.push_back(std::move(part));
            continue;
        }
        for (Power& inner : part.parts) whole.parts.push_back(std::move(inner));
    }
    if (whole.parts.empty()) return {};
    if (whole.parts.size() > 1) return whole;
    Power only = std::move(whole.parts.front());
    return only;
}

}  // namespace

Power contact(VariableId variable, ContactKind kind) {
    Power power;
    power.kind = Power::Kind::contact;
    power.variable = variable;
    power.contact = kind;
    return power;
}

Power series(std::vector<Power> parts) {
    return combined(Power::Kind::series, std::move(parts));
}

Power parallel(std::vector<Power> parts) {
    return combined(Power::Kind::parallel, std::move(parts));
}

std::string heading_of(const Ladder& ladder, Language language) {
    return titled_name(ladder.name, ladder.title, language);
}

std::string operand_text(const Ladder& ladder, const Operand& operand) {
    switch (operand.kind) {
        case Operand::Kind::number:
            return fmt::format("{}", operand.value);
        case Operand::Kind::time:
            return iec::time_literal(operand.value);
        case Operand::Kind::variable:
            break;
    }
    const Variable& variable = ladder.variable(operand.variable);
    return variable.type == Type::block ? variable.name + ".CV" : variable.name;
}

}  // namespace grafwire::ladder
