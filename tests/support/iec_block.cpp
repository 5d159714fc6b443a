#include "support/iec_block.h"

#include <limits>
#include <map>

#include "iec/identifiers.h"

namespace grafwire::testing {

namespace {

void check_range(IecValue value, std::size_t line) {
    std::int64_t limit = std::numeric_limits<std::int64_t>::max();
    if (value.type == IecType::int16) limit = INT16_MAX;
    if (value.type == IecType::int32) limit = INT32_MAX;
    if (value.value > limit || value.value < -limit - 1) {
        throw PlcError(line, "a value out of the range of its type");
    }
}

/// The type that two operands share.
IecType common_type(IecValue left, IecValue right, std::size_t line) {
    if (left.type == right.type) return left.type;
    if (left.type == IecType::literal && is_integer(right.type)) return right.type;
    if (right.type == IecType::literal && is_integer(left.type)) return left.type;
    throw PlcError(line, "operands of different types");
}

}  // namespace

IecType iec_type_named(const std::string& name, std::size_t line) {
    static const std::map<std::string, IecType> types = {
        {"bool", IecType::boolean}, {"int", IecType::int16}, {"dint", IecType::int32},
        {"lint", IecType::int64},   {"ton", IecType::ton},   {"tof", IecType::tof}};
    const auto found = types.find(name);
    if (found == types.end()) throw PlcError(line, "the type '" + name + "'");
    return found->second;
}

bool is_integer(IecType type) {
    return type == IecType::literal || type == IecType::int16 || type == IecType::int32 ||
           type == IecType::int64;
}

IecValue add_integers(IecValue left, IecValue right, bool subtract, std::size_t line) {
    IecValue sum{common_type(left, right, line), 0};
    if (!is_integer(sum.type)) throw PlcError(line, "a sum of what are no integers");
    const bool overflow = subtract ? __builtin_sub_overflow(left.value, right.value, &sum.value)
                                   : __builtin_add_overflow(left.value, right.value, &sum.value);
    if (overflow) throw PlcError(line, "a sum beyond 64 bits");
    check_range(sum, line);
    return sum;
}

int compare_values(IecValue left, IecValue right, std::size_t line) {
    if (!is_integer(common_type(left, right, line))) {
        throw PlcError(line, "a comparison of what are no integers");
    }
    return left.value < right.value ? -1 : left.value > right.value ? 1 : 0;
}

void IecBlock::read_declarations(IecTokenCursor& cursor) {
    cursor.expect("function_block");
    const std::string name = cursor.identifier();
    if (iec::is_keyword(name)) cursor.fail("a block called '" + name + "'");
    while (cursor.is("var_input") || cursor.is("var_output") || cursor.is("var")) {
        std::string kind = cursor.take().text;
        if (cursor.accept("constant")) kind += " constant";
        read_section(cursor, kind);
    }
    if (variables.count(name) != 0) cursor.fail("a variable has the name of the block");
}

void IecBlock::declare(const std::string& name, const IecVariable& variable, std::size_t line) {
    if (!variables.emplace(name, variable).second) {
        throw PlcError(line, "'" + name + "' declared twice");
    }
}

void IecBlock::read_section(IecTokenCursor& cursor, const std::string& kind) {
    sections.push_back({kind, {}});
    do {
        const std::size_t line = cursor.peek().line;
        const std::string name = cursor.identifier();
        if (iec::is_keyword(name)) throw PlcError(line, "a variable called '" + name + "'");
        IecVariable variable;
        variable.is_constant = kind == "var constant";
        variable.is_input = kind == "var_input";
        cursor.expect(":");
        std::size_t size = 1;
        if (cursor.accept("array")) {
            variable.is_array = true;
            cursor.expect("[");
            variable.first_index = cursor.integer();
            cursor.expect("..");
            const std::int64_t last = cursor.integer();
            if (last < variable.first_index) throw PlcError(line, "an empty array");
            size = static_cast<std::size_t>(last - variable.first_index + 1);
            cursor.expect("]");
            cursor.expect("of");
        }
        variable.type = iec_type_named(cursor.identifier(), line);
        variable.values.assign(size, 0);
        if (cursor.accept(":=")) variable.values[0] = cursor.integer();
        cursor.expect(";");
        declare(name, variable, line);
        sections.back().second.push_back(name);
    } while (!cursor.accept("end_var"));
}

IecVariable& IecBlock::variable(const std::string& name, std::size_t line) {
    const auto found = variables.find(name);
    if (found == variables.end()) throw PlcError(line, "'" + name + "' is not declared");
    return found->second;
}

std::int64_t& IecBlock::cell(IecVariable& variable, const IecValue* index, std::size_t line) {
    if (variable.is_array != (index != nullptr)) throw PlcError(line, "an index too many, or none");
    if (index == nullptr) return variable.values.front();
    if (!is_integer(index->type)) throw PlcError(line, "an index that is no integer");
    const std::int64_t place = index->value - variable.first_index;
    if (place < 0 || place >= static_cast<std::int64_t>(variable.values.size())) {
        throw PlcError(line, "an index beyond the array");
    }
    return variable.values[static_cast<std::size_t>(place)];
}

IecValue IecBlock::load(const std::string& name, const IecValue* index, std::size_t line) {
    IecVariable& found = variable(name, line);
    if (found.type == IecType::ton || found.type == IecType::tof || found.type == IecType::step) {
        throw PlcError(line, "a timer or a step where a value is expected");
    }
    return {found.type, cell(found, index, line)};
}

void IecBlock::store(const std::string& name, const IecValue* index, IecValue value,
                     std::size_t line) {
    IecVariable& target = variable(name, line);
    if (target.is_constant || target.is_input) throw PlcError(line, "'" + name + "' is written");
    const bool fits =
        value.type == target.type || (value.type == IecType::literal && is_integer(target.type));
    if (!fits) throw PlcError(line, "'" + name + "' is of another type");
    check_range({target.type, value.value}, line);
    cell(target, index, line) = value.value;
}

bool IecBlock::timer_output(const std::string& name, std::size_t line) {
    const IecVariable& timer = variable(name, line);
    if (timer.type != IecType::ton && timer.type != IecType::tof) {
        throw PlcError(line, "'" + name + "' is no timer");
    }
    return timer.q;
}

IecValue IecBlock::field(const std::string& name, const std::string& field, std::size_t line) {
    const IecVariable& found = variable(name, line);
    const bool is_step = found.type == IecType::step;
    if (field != (is_step ? "x" : "q")) throw PlcError(line, "'" + name + "' has no " + field);
    const bool value = is_step ? found.values.front() != 0 : timer_output(name, line);
    return {IecType::boolean, value ? 1 : 0};
}

/// TON: Q once IN has been 1 for PT. TOF: Q with IN, and until IN has been 0 for PT.
void IecBlock::call_timer(const std::string& name, bool in, Time pt, Time now, std::size_t line) {
    timer_output(name, line);
    IecVariable& timer = variable(name, line);
    const bool rests = timer.type == IecType::ton ? !in : in;
    if (rests) {
        timer.q = timer.type == IecType::tof;
        timer.runs = false;
        return;
    }
    const bool to_come = timer.type == IecType::ton ? !timer.q : timer.q;
    if (!to_come) return;
    if (!timer.runs) timer.since = now;
    timer.runs = true;
    if (now - timer.since >= pt) timer.q = timer.type == IecType::ton;
}

const std::string& IecMachine::name_in(const std::string& section, std::size_t index) const {
    for (const auto& [kind, names] : block_.sections) {
        if (kind == section && index < names.size()) return names[index];
        if (kind == section) break;
    }
    throw PlcError(0, "no variable " + std::to_string(index) + " in " + section);
}

void IecMachine::set_input(std::uint32_t index, bool value) {
    block_.variables.at(name_in("var_input", index)).values.front() = value ? 1 : 0;
}

bool IecMachine::step(std::uint32_t index) const {
    return block_.variables.at("ts").values.at(index) != 0;
}

bool IecMachine::output(std::uint32_t index) const {
    return block_.variables.at(name_in("var_output", index)).values.front() != 0;
}

bool IecMachine::var(std::uint32_t index) const {
    return block_.variables.at(name_in("var", index)).values.front() != 0;
}

std::int64_t IecMachine::counter(std::uint32_t index) const {
    return block_.variables.at(name_in("var", grafcet_.vars.size() + index)).values.front();
}

}  // namespace grafwire::testing
