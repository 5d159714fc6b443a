// BLIF has no gates: a cover is a list of products, from which the reader works out what the gate
// was when it was written. One product, or products of one literal each, are an AND, OR, NAND or
// NOR; inverted literals only turn it into its dual by De Morgan's laws. All rows of one parity are
// an exclusive or. Whatever is left becomes a sum of products, with an inverter for each inverted
// input, made once in the whole netlist.

#include "formats/shared/cover.h"

#include <algorithm>

namespace grafwire {

namespace {

/// An input as it is or inverted.
struct Literal {
    NetId net = no_net;
    bool inverted = false;
};

/// The gates for one cover; the last of them drives its output.
class CoverGates {
  public:
    CoverGates(NetlistAssembly& assembly, NetId output, Location where)
        : assembly_(assembly), output_(output), where_(where) {}

    void add(const Cover& cover);

  private:
    bool add_parity(const Cover& cover);
    void add_product(const std::vector<Literal>& literals, bool complemented);
    void add_sum(const std::vector<Literal>& literals, bool complemented);
    void drive(CellType type, const std::vector<NetId>& pins);
    std::vector<NetId> nets_of(const std::vector<Literal>& literals);

    NetlistAssembly& assembly_;
    NetId output_;
    Location where_;
};

/// The product that a row stands for: `1-0` is a./c.
std::vector<Literal> literals_of(const Cover& cover, const std::string& row) {
    std::vector<Literal> literals;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != '-') literals.push_back({cover.inputs[i], row[i] == '0'});
    }
    return literals;
}

/// A gate of one pin is a buffer or an inverter.
CellType gate_of(CellType type, std::size_t pin_count) {
    if (pin_count != 1 || type == CellType::inverter) return type;
    const bool inverts = type == CellType::nand_gate || type == CellType::nor_gate;
    return inverts ? CellType::inverter : CellType::buffer;
}

bool all_inverted(const std::vector<Literal>& literals) {
    return std::all_of(literals.begin(), literals.end(),
                       [](Literal item) { return item.inverted; });
}

void CoverGates::drive(CellType type, const std::vector<NetId>& pins) {
    assembly_.add_cell(gate_of(type, pins.size()), output_, pins, where_);
}

std::vector<NetId> CoverGates::nets_of(const std::vector<Literal>& literals) {
    std::vector<NetId> nets;
    for (const Literal literal : literals) {
        nets.push_back(literal.inverted ? assembly_.inverted(literal.net, where_) : literal.net);
    }
    return nets;
}

std::vector<NetId> plain_nets_of(const std::vector<Literal>& literals) {
    std::vector<NetId> nets;
    for (const Literal literal : literals) nets.push_back(literal.net);
    return nets;
}

/// A product, or its complement. All inverted: /a./b is a NOR.
void CoverGates::add_product(const std::vector<Literal>& literals, bool complemented) {
    if (all_inverted(literals)) {
        return drive(complemented ? CellType::or_gate : CellType::nor_gate,
                     plain_nets_of(literals));
    }
    drive(complemented ? CellType::nand_gate : CellType::and_gate, nets_of(literals));
}

/// A sum, or its complement. All inverted: /a + /b is a NAND.
void CoverGates::add_sum(const std::vector<Literal>& literals, bool complemented) {
    if (all_inverted(literals)) {
        return drive(complemented ? CellType::and_gate : CellType::nand_gate,
                     plain_nets_of(literals));
    }
    drive(complemented ? CellType::nor_gate : CellType::or_gate, nets_of(literals));
}

/// All rows of odd, or all of even, parity: an exclusive or.
bool CoverGates::add_parity(const Cover& cover) {
    const std::size_t width = cover.inputs.size();
    if (width < 2 || width > 20 || cover.rows.size() != std::size_t{1} << (width - 1)) return false;
    std::vector<std::string> rows = cover.rows;
    std::sort(rows.begin(), rows.end());
    if (std::adjacent_find(rows.begin(), rows.end()) != rows.end()) return false;
    const auto is_odd = [](const std::string& row) {
        return std::count(row.begin(), row.end(), '1') % 2 == 1;
    };
    for (const std::string& row : rows) {
        if (row.find('-') != std::string::npos || is_odd(row) != is_odd(rows[0])) return false;
    }
    if (is_odd(rows[0]) == cover.value) {
        drive(CellType::xor_gate, cover.inputs);
    } else {
        drive(CellType::inverter,
              {assembly_.gate(CellType::xor_gate, cover.inputs, output_, where_)});
    }
    return true;
}

void CoverGates::add(const Cover& cover) {
    std::vector<std::vector<Literal>> products;
    bool is_sum = true;
    for (const std::string& row : cover.rows) {
        products.push_back(literals_of(cover, row));
        if (products.back().empty()) {  // fits always
            return drive(cover.value ? CellType::high : CellType::low, {});
        }
        is_sum &= products.back().size() == 1;
    }
    if (products.empty()) return drive(cover.value ? CellType::low : CellType::high, {});
    if (products.size() == 1) return add_product(products[0], !cover.value);
    if (is_sum) {
        std::vector<Literal> literals;
        for (const std::vector<Literal>& product : products) literals.push_back(product[0]);
        return add_sum(literals, !cover.value);
    }
    if (add_parity(cover)) return;
    std::vector<NetId> terms;
    for (const std::vector<Literal>& product : products) {
        const std::vector<NetId> nets = nets_of(product);
        terms.push_back(
            nets.size() == 1 ? nets[0] : assembly_.gate(CellType::and_gate, nets, output_, where_));
    }
    drive(cover.value ? CellType::or_gate : CellType::nor_gate, terms);
}

}  // namespace

void add_cover(NetlistAssembly& assembly, const Cover& cover, NetId output, Location where) {
    CoverGates(assembly, output, where).add(cover);
}

}  // namespace grafwire
