// Yosys JSON after the help text of Yosys's write_json; yosys_cell_writer.cpp has its cells.

#include "formats/yosys/write_yosys_json.h"

#include <array>

#include "formats/shared/append.h"
#include "formats/shared/helper_pins.h"
#include "formats/shared/net_spelling.h"
#include "formats/yosys/yosys_cell_writer.h"

namespace grafwire {

namespace {

/// A name within a JSON string. Yosys has no white space and control characters in names.
void spell_json(std::string& out, std::string_view name) {
    std::string safe;
    append_percent_escaped(safe, name, is_control_or_blank);
    for (const char c : safe) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
}

class JsonWriter {
  public:
    explicit JsonWriter(const Netlist& netlist)
        : netlist_(netlist),
          nets_(netlist, spell_json),
          suffix_(cell_suffix(netlist)),
          initial_(netlist.net_count(), Logic::unknown) {
        while (std::string_view(netlist.name).starts_with(prefix_)) prefix_ += '_';
        for (const Netlist::InitialValue& item : netlist.initial_values) {
            initial_[index_of(item.net)] = logic_of(item.value);
        }
        for (const Cell& cell : netlist.cells) {
            const bool is_box = is_yosys_black_box(cell.type);
            if (is_box) used_boxes_[static_cast<std::size_t>(cell.type)] = true;
            if (row_of(cell.type).has_memory && !is_box)
                initial_[index_of(cell.output)] = cell.initial;
        }
    }

    std::string write();

  private:
    void write_ports();
    void write_cells();
    void write_net_names();
    void write_black_box_module(const CellTypeRow& row);
    void write_bit(NetId net) { append(out_, YosysCellWriter::bit_of(net)); }

    const Netlist& netlist_;
    NetSpelling nets_;
    std::string suffix_;
    std::string prefix_ = "grafwire_";
    std::vector<Logic> initial_;
    std::array<bool, cell_table.size()> used_boxes_{};
    std::string out_;
};

std::string JsonWriter::write() {
    out_.reserve(netlist_.cells.size() * 400);
    out_ += "{\n  \"creator\": \"grafwire\",\n  \"modules\": {\n    \"";
    spell_json(out_, netlist_.name);
    out_ += "\": {\n      \"attributes\": { \"top\": ";
    out_ += "1 },\n";
    write_ports();
    write_cells();
    write_net_names();
    out_ += "    }";
    for (const CellTypeRow& row : cell_table) {
        if (used_boxes_[static_cast<std::size_t>(row.type)]) write_black_box_module(row);
    }
    out_ += "\n  }\n}\n";
    return std::move(out_);
}

void JsonWriter::write_ports() {
    out_ += "      \"ports\": {";
    std::string_view separator = "\n";
    const auto write_all = [&](const std::vector<Port>& ports, std::string_view direction) {
        for (const Port& port : ports) {
            append(out_, separator, "        \"");
            spell_json(out_, port.name);
            append(out_, "\": { \"direction\": \"", direction, "\", \"bits\": [ ");
            write_bit(port.net);
            out_ += " ] }";
            separator = ",\n";
        }
    };
    write_all(netlist_.inputs, "input");
    write_all(netlist_.outputs, "output");
    out_ += "\n      },\n";
}

void JsonWriter::write_cells() {
    out_ += "      \"cells\": {";
    YosysCellWriter cells(out_, netlist_, prefix_);
    std::string_view separator = "\n";
    for (const Module& module : netlist_.modules) {
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            const Cell& cell = netlist_.cells.items()[module.first_cell + i];
            append(out_, separator, "        \"", nets_[cell.output], suffix_, "\": ");
            cells.write(cell, module);
            separator = ",\n";
        }
    }
    out_ += "\n      },\n";
}

void JsonWriter::write_net_names() {
    out_ += "      \"netnames\": {";
    std::string_view separator = "\n";
    const auto write_net = [&](NetId net) {
        out_ += "\": { \"hide_name\": 0, \"bits\": [ ";
        write_bit(net);
        out_ += " ], \"attributes\": {";
        const Logic initial = initial_[index_of(net)];
        if (initial != Logic::unknown) {
            append(out_, " \"init\": \"", initial == Logic::one ? '1' : '0', "\" ");
        }
        out_ += "} }";
        separator = ",\n";
    };
    for (std::size_t i = 0; i < netlist_.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        append(out_, separator, "        \"", nets_[net]);
        write_net(net);
    }
    std::string name;
    for (const Port& port : netlist_.outputs) {
        name.clear();
        spell_json(name, port.name);
        if (name == nets_[port.net]) continue;
        append(out_, separator, "        \"", name);
        write_net(port.net);
    }
    out_ += "\n      }\n";
}

void JsonWriter::write_black_box_module(const CellTypeRow& row) {
    append(out_, ",\n    \"", prefix_, row.name,
           "\": {\n      \"attributes\": { \"blackbox\": 1 },\n      \"ports\": {\n");
    std::uint32_t bit = 2;
    for (std::uint32_t pin = 0; pin < row.min_pins; ++pin) {
        append(out_, "        \"", helper_pin_name(row.type, pin),
               "\": { \"direction\": \"input\", \"bits\": [ ", bit++, " ] },\n");
    }
    append(out_, "        \"q\": { \"direction\": \"output\", \"bits\": [ ", bit,
           " ] }\n      },\n      \"cells\": {},\n      \"netnames\": {}\n    }");
}

}  // namespace

std::string write_yosys_json(const Netlist& netlist) {
    return JsonWriter(netlist).write();
}

}  // namespace grafwire
