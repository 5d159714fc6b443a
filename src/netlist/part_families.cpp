// How cells are composed of the parts that a family has
//
// A gate is the narrowest part of its kind with enough inputs; those that are left over are tied. A
// gate that is wider than every part is a tree: the widest part of its kind last, its inputs from
// gates that share out the inputs as evenly as can be. Before an AND or a NAND these are ANDs,
// before an OR or a NOR they are ORs, before an XOR XORs. So an AND of 10 inputs from parts of up
// to 4 is an AND of 4 after two ANDs of 2 and two of 3.
//
//     buffer          two inverters
//     constant        never changes: the band of a buffer, for the time before the first instant
//     latch           an inverter at each input, and two NAND gates (set wins, as it must)
//     latch with enable   four NAND gates, and an inverter at its data
//     pulse cell      an AND or a NOR of the input and of the input delayed: its band is that to
//                     the start of the pulse; how long the pulse lasts, no family says
//     timer           a buffer behind what keeps the time (R and C, say), whose error no family
//     says
//
// Through several parts the least times add up, and the greatest: the band is that from the least
// over all paths to the greatest over all paths. Where a part inverts, the rise of its output
// follows the fall of what is before it.

#include "netlist/part_families.h"

#include <algorithm>
#include <array>

namespace grafwire {

namespace {

using Bands = std::optional<EdgeBands>;

constexpr std::array<PartFamily, 6> families{{
    {"74HC",
     {"74HC, as far as its data sheets let gates differ",
      "74HC, autant que ses notices laissent "
      "les portes différer"},
     parts_74hc},
    {"74HC-typical",
     {"74HC, 0.4 to 1.6 times the typical delays", "74HC, de 0.4 à 1.6 fois les temps typiques"},
     parts_74hc,
     true},
    {"74LS",
     {"74LS, as far as its data sheets let gates differ",
      "74LS, autant que ses notices laissent "
      "les portes différer"},
     parts_74ls},
    {"74LS-typical",
     {"74LS, 0.4 to 1.6 times the typical delays", "74LS, de 0.4 à 1.6 fois les temps typiques"},
     parts_74ls,
     true},
    {"4000",
     {"4000B at 5 V, as far as its data sheets let gates differ",
      "4000B sous 5 V, autant que ses notices laissent les portes différer"},
     parts_4000},
    {"4000-typical",
     {"4000B at 5 V, 0.4 to 1.6 times the typical delays",
      "4000B sous 5 V, de 0.4 à 1.6 fois les temps typiques"},
     parts_4000,
     true},
}};

DelayBand sum(DelayBand a, DelayBand b) {
    return {a.min + b.min, a.max + b.max};
}

DelayBand around(DelayBand a, DelayBand b) {
    return {std::min(a.min, b.min), std::max(a.max, b.max)};
}

EdgeBands around(const EdgeBands& a, const EdgeBands& b) {
    return {around(a.rise, b.rise), around(a.fall, b.fall)};
}

/// A part behind another; where it does not invert, and where it does.
EdgeBands follow(const EdgeBands& first, const EdgeBands& last) {
    return {sum(first.rise, last.rise), sum(first.fall, last.fall)};
}
EdgeBands follow_inverted(const EdgeBands& first, const EdgeBands& last) {
    return {sum(first.fall, last.rise), sum(first.rise, last.fall)};
}

bool inverts(CellType type) {
    return type == CellType::nand_gate || type == CellType::nor_gate;
}

/// What stands before the last gate of a tree.
CellType before_last(CellType type) {
    if (type == CellType::nand_gate) return CellType::and_gate;
    return type == CellType::nor_gate ? CellType::or_gate : type;
}

/// A band of 0.4 to 1.6 times these.
DelayBand spread(DelayBand typical) {
    return {typical.min * 2 / 5, typical.max * 8 / 5};
}

class Composer {
  public:
    explicit Composer(const PartFamily& family) : family_(family) {}

    Bands cell(CellType type, std::size_t inputs) const {
        switch (type) {
            case CellType::and_gate:
            case CellType::or_gate:
            case CellType::nand_gate:
            case CellType::nor_gate:
            case CellType::xor_gate:
                return gate(type, inputs);
            case CellType::inverter:
                return gate(type, 1);
            case CellType::flip_flop:
                return gate(type, 2);
            case CellType::low:
            case CellType::high:
            case CellType::buffer:
            case CellType::timer:
                return buffer();
            case CellType::latch:
                return latch();
            case CellType::hold_latch:
                return hold_latch();
            case CellType::rise_pulse:
                return gate(CellType::and_gate, 2);
            case CellType::fall_pulse:
                return gate(CellType::nor_gate, 2);
            case CellType::scan_timer:
            case CellType::scan_timer_next:
                return std::nullopt;
        }
        return std::nullopt;
    }

  private:
    EdgeBands figures_of(const PartFigures& part) const {
        if (!family_.is_typical) return part.bounds;
        return {spread(part.typical.rise), spread(part.typical.fall)};
    }

    Bands gate(CellType type, std::size_t inputs) const {
        if (const PartFigures* part = part_for(family_, type, inputs)) return figures_of(*part);
        const PartFigures* widest = nullptr;
        for (const PartFigures& part : family_.parts) {
            if (part.type == type) widest = &part;
        }
        if (widest == nullptr) return std::nullopt;
        const EdgeBands last = figures_of(*widest);
        const std::size_t least = inputs / widest->inputs;
        const std::size_t most = least + (inputs % widest->inputs == 0 ? 0 : 1);
        const Bands fewer = branch(before_last(type), least);
        const Bands more = branch(before_last(type), most);
        if (!fewer || !more) return std::nullopt;
        const EdgeBands before = around(*fewer, *more);
        return inverts(type) ? follow_inverted(before, last) : follow(before, last);
    }

    /// An input of the last gate of a tree: a gate, or a wire.
    Bands branch(CellType type, std::size_t inputs) const {
        return inputs == 1 ? EdgeBands{} : gate(type, inputs);
    }

    Bands buffer() const {
        const Bands inverter = gate(CellType::inverter, 1);
        if (!inverter) return std::nullopt;
        return follow_inverted(*inverter, *inverter);
    }

    /// Rises by S, an inverter and the NAND of the output; falls by R, through both NAND gates.
    Bands latch() const {
        const Bands inverter = gate(CellType::inverter, 1);
        const Bands nand = gate(CellType::nand_gate, 2);
        if (!inverter || !nand) return std::nullopt;
        const EdgeBands direct = follow_inverted(*inverter, *nand);
        return EdgeBands{direct.rise, follow_inverted(direct, *nand).fall};
    }

    /// Rises through the NAND at its input and that of the output; falls through three NAND gates,
    /// with the inverter before them where the data has changed.
    Bands hold_latch() const {
        const Bands inverter = gate(CellType::inverter, 1);
        const Bands nand = gate(CellType::nand_gate, 2);
        if (!inverter || !nand) return std::nullopt;
        const EdgeBands two = follow_inverted(*nand, *nand);
        const DelayBand by_enable = follow_inverted(two, *nand).fall;
        const DelayBand by_data = sum(by_enable, around(inverter->rise, inverter->fall));
        return EdgeBands{two.rise, around(by_enable, by_data)};
    }

    const PartFamily& family_;
};

}  // namespace

std::span<const PartFamily> part_families() {
    return families;
}

const PartFamily* part_family_named(std::string_view name) {
    for (const PartFamily& family : families) {
        if (family.name == name) return &family;
    }
    return nullptr;
}

const PartFigures* part_for(const PartFamily& family, CellType type, std::size_t inputs) {
    for (const PartFigures& part : family.parts) {
        if (part.type == type && part.inputs >= inputs) return &part;
    }
    return nullptr;
}

std::optional<EdgeBands> bands_of(const PartFamily& family, CellType type, std::size_t inputs) {
    return Composer(family).cell(type, inputs);
}

}  // namespace grafwire
