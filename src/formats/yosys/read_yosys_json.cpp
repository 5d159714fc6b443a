// Yosys JSON after the help text of Yosys's write_json.

#include "formats/yosys/read_yosys_json.h"

#include <fmt/format.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "formats/shared/messages.h"
#include "formats/shared/net_spelling.h"
#include "formats/shared/netlist_assembly.h"
#include "formats/yosys/json_tree.h"
#include "formats/yosys/read_yosys_cell.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::formats;

using Kind = JsonValue::Kind;

/// Yosys writes a flag as a number or as 32 bits.
bool is_set(const JsonValue* attribute) {
    return attribute != nullptr && attribute->text.find('1') != std::string::npos;
}

/// Reads the top module. Bits are numbers; their names come from three places, of which the first
/// counts: ports, names that the source had, names that Yosys made up.
class YosysReader {
  public:
    explicit YosysReader(Diagnostics& diagnostics)
        : diagnostics_(diagnostics), assembly_(diagnostics) {}

    std::optional<Netlist> read(const JsonValue& root);

  private:
    const JsonMember* choose_module(const JsonValue& modules);
    void read_net_names(const JsonValue& net_names, bool hidden);
    void read_initial_values(const JsonValue& net_names);
    void read_ports(const JsonValue& ports, std::string_view direction);
    void read_port(const std::string& name, const JsonValue& port);
    void read_cells(const JsonValue& cells);
    bool read_connections(const JsonValue& connections, YosysCell& cell);
    void add_cell(YosysCell cell, const JsonValue& connections);
    void set_initial_values();
    NetId net_of(const JsonValue& bit, Location where);
    void name_bit(const JsonValue& bit, const std::string& name);
    void refuse(Location where, Localized message) {
        diagnostics_.error(code::bad_netlist, where, std::move(message));
    }

    Diagnostics& diagnostics_;
    NetlistAssembly assembly_;
    // All per bit number, as written.
    std::unordered_map<std::string, std::string> names_;
    std::unordered_map<std::string, NetId> nets_;
    std::unordered_map<std::string, Logic> initial_;
    std::vector<std::string> initial_order_;
};

/// The top module, else the only one that is no black box.
const JsonMember* YosysReader::choose_module(const JsonValue& modules) {
    const JsonMember* chosen = nullptr;
    std::size_t count = 0;
    for (const auto& module : modules.members) {
        const JsonValue* attributes = module.value.find("attributes");
        const auto has = [&](std::string_view name) {
            return attributes != nullptr && is_set(attributes->find(name));
        };
        if (has("top")) return &module;
        if (has("blackbox") || has("whitebox")) continue;
        chosen = &module;
        ++count;
    }
    if (count == 1) return chosen;
    refuse(modules.where, count == 0 ? say::no_module() : say::several_modules());
    return nullptr;
}

void YosysReader::name_bit(const JsonValue& bit, const std::string& name) {
    if (bit.kind == Kind::number && !name.empty()) names_.try_emplace(bit.text, name);
}

/// The net of a bit, made when it is first needed, at `where`: words often have bits that nothing
/// uses.
NetId YosysReader::net_of(const JsonValue& bit, Location where) {
    const auto found = nets_.find(bit.text);
    if (found != nets_.end()) return found->second;
    const auto name = names_.find(bit.text);
    const NetId net = name != names_.end() ? assembly_.net(percent_decoded(name->second), where)
                                           : assembly_.inner_net(no_net, where);
    nets_.emplace(bit.text, net);
    return net;
}

/// `hidden`: those that Yosys made up. A word gives its bits names such as `w[3]`.
void YosysReader::read_net_names(const JsonValue& net_names, bool hidden) {
    for (const auto& [name, value] : net_names.members) {
        const JsonValue* hide = value.find("hide_name");
        if ((hide != nullptr && hide->text == "1") != hidden) continue;
        const JsonValue* bits = value.find("bits");
        if (bits == nullptr) continue;
        for (std::size_t i = 0; i < bits->items.size(); ++i) {
            name_bit(bits->items[i],
                     bits->items.size() == 1 ? name : fmt::format("{}[{}]", name, i));
        }
    }
}

/// The attribute `init` has a character a bit, the highest first.
void YosysReader::read_initial_values(const JsonValue& net_names) {
    for (const auto& [name, value] : net_names.members) {
        const JsonValue* bits = value.find("bits");
        const JsonValue* attributes = value.find("attributes");
        const JsonValue* init = attributes != nullptr ? attributes->find("init") : nullptr;
        if (bits == nullptr || init == nullptr) continue;
        for (std::size_t i = 0; i < bits->items.size() && i < init->text.size(); ++i) {
            const char digit = init->text[init->text.size() - 1 - i];
            if (bits->items[i].kind != Kind::number || (digit != '0' && digit != '1')) continue;
            const Logic logic = logic_of(digit == '1');
            const std::string& bit = bits->items[i].text;
            if (initial_.emplace(bit, logic).second) initial_order_.push_back(bit);
        }
    }
}

/// An output that is tied to a constant gets a cell for it, since a port needs a net.
void YosysReader::read_port(const std::string& name, const JsonValue& port) {
    const JsonValue* bits = port.find("bits");
    const std::string& direction = port.find("direction")->text;
    if (bits == nullptr || bits->items.size() != 1) {
        return refuse(port.where,
                      say::wide_port(bits == nullptr ? 0 : bits->items.size(), shortened(name)));
    }
    const JsonValue& bit = bits->items[0];
    const std::string port_name = percent_decoded(name);
    if (bit.kind == Kind::number) {
        name_bit(bit, name);
        const NetId net = net_of(bit, port.where);
        if (direction == "input") return assembly_.add_input(port_name, net, port.where);
        return assembly_.add_output(port_name, net, port.where);
    }
    if (direction == "input" || (bit.text != "0" && bit.text != "1")) {
        return refuse(port.where, say::port_connected_to(shortened(name), shortened(bit.text)));
    }
    const NetId net = assembly_.net(port_name, port.where);
    assembly_.add_cell(bit.text == "1" ? CellType::high : CellType::low, net, {}, port.where);
    assembly_.add_output(port_name, net, port.where);
}

void YosysReader::read_ports(const JsonValue& ports, std::string_view direction) {
    for (const auto& [name, port] : ports.members) {
        const JsonValue* actual = port.find("direction");
        const bool is_known =
            actual != nullptr && (actual->text == "input" || actual->text == "output");
        if (name.empty() || !is_known) {
            if (direction == "input") {
                refuse(port.where, say::port_without_direction(shortened(name)));
            }
        } else if (actual->text == direction) {
            read_port(name, port);
        }
    }
}

/// A bit is the number of a net, or a constant; `x` and `z` are refused.
bool YosysReader::read_connections(const JsonValue& connections, YosysCell& cell) {
    for (const auto& [port, bits] : connections.members) {
        YosysCell::Connection connection{port, {}, {}};
        for (const JsonValue& bit : bits.items) {
            if (bit.kind == Kind::number) {
                connection.bits.push_back(net_of(bit, cell.where));
                connection.constants += '-';
            } else if (bit.text == "0" || bit.text == "1") {
                connection.bits.push_back(no_net);
                connection.constants += bit.text;
            } else {
                refuse_yosys_cell(cell, say::pin_connected_to(port, shortened(bit.text)),
                                  diagnostics_);
                return false;
            }
        }
        cell.connections.push_back(std::move(connection));
    }
    return true;
}

/// An initial value at the output of a memory is that of the memory.
void YosysReader::add_cell(YosysCell cell, const JsonValue& connections) {
    Logic initial = Logic::unknown;
    const JsonValue* output = is_yosys_memory(cell.type) ? connections.find("Q") : nullptr;
    if (output != nullptr && output->items.size() == 1) {
        const auto found = initial_.find(output->items[0].text);
        if (found != initial_.end()) {
            initial = found->second;
            initial_.erase(found);
        }
    }
    add_yosys_cell(assembly_, std::move(cell), initial, diagnostics_);
}

/// What is left of the initial values belongs to nets that gates drive.
void YosysReader::set_initial_values() {
    for (const std::string& bit : initial_order_) {
        const auto value = initial_.find(bit);
        const auto net = nets_.find(bit);
        if (value != initial_.end() && net != nets_.end()) {
            assembly_.set_initial(net->second, value->second == Logic::one);
        }
    }
}

void YosysReader::read_cells(const JsonValue& cells) {
    for (const auto& [name, value] : cells.members) {
        YosysCell cell;
        cell.name = name;
        cell.where = value.where;
        if (const JsonValue* type = value.find("type")) cell.type = type->text;
        // What the black boxes say stands among the attributes.
        for (const std::string_view part : {"parameters", "attributes"}) {
            const JsonValue* figures = value.find(part);
            if (figures == nullptr) continue;
            for (const auto& [key, figure] : figures->members) {
                cell.parameters.emplace_back(key, figure.text);
            }
        }
        const JsonValue* connections = value.find("connections");
        if (connections == nullptr) {
            refuse(value.where, say::cell_without_connections(shortened(name)));
            continue;
        }
        if (!read_connections(*connections, cell)) continue;
        add_cell(std::move(cell), *connections);
    }
}

std::optional<Netlist> YosysReader::read(const JsonValue& root) {
    const JsonValue* modules = root.find("modules");
    if (modules == nullptr) {
        refuse(root.where, say::no_modules());
        return std::nullopt;
    }
    const auto* module = choose_module(*modules);
    if (module == nullptr) return std::nullopt;
    static const JsonValue nothing;
    const auto part = [&](std::string_view name) -> const JsonValue& {
        const JsonValue* value = module->value.find(name);
        return value != nullptr ? *value : nothing;
    };
    read_ports(part("ports"), "input");
    read_ports(part("ports"), "output");
    read_net_names(part("netnames"), false);
    read_net_names(part("netnames"), true);
    read_initial_values(part("netnames"));
    read_cells(part("cells"));
    set_initial_values();
    std::string name = percent_decoded(module->name);
    assembly_.check_name(name, module->value.where);
    return assembly_.finish(std::move(name));
}

}  // namespace

std::optional<Netlist> read_yosys_json(const SourceFile& source, Diagnostics& diagnostics) {
    const std::optional<JsonValue> root = parse_json(source.text, diagnostics);
    if (!root) return std::nullopt;
    return YosysReader(diagnostics).read(*root);
}

}  // namespace grafwire
