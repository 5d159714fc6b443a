#pragma once

// Propagation delays of logic families, as data sheets print them, in nanoseconds. Rise and fall
// are those of the output (tPLH, tPHL). 74HC at 4.5 V and 50 pF, typical figures also at 5 V and
// 15 pF; 74LS at 5 V, its sheets at 15 pF; 4000B at 5 V and 50 pF.
//
// What is derived:
// - No sheet gives a least delay. It is taken as a quarter of the smallest typical one, rounded
//   down: sheets that do print one (Fairchild DM74LS00 and DM74LS32, Philips 74F30, onsemi
//   MC74VHC04) have 0.19 to 0.43 of the typical.
// - 74HC: the maximum is that for -40 to 85 degrees. Where only that for 25 degrees is printed, it
//   is 1.25 times that, the ratio in every sheet that prints both.
// - 74LS: the maximum is 1.5 times that for 15 pF, for a load of 50 pF (Fairchild DM74LS00).
//   Each edge has its own.
// - A gate without a maximum takes that of the next wider of its kind, and is marked as a guess.
//
// The sources: TI-HC is the Texas Instruments HC data book of 1989, TI-LS their TTL data book of
// 1985, each as entered in open simulator libraries (Digital_HC.lib of qucs_s, lsttl_verilog);
// LT the typical figures of Philips in the 74HC library of LTspice; M the data books of Motorola
// (1991) and National (1988) in Digital_CD.lib of qucs_s. Other names are those of data sheets.

#include <array>
#include <cstdint>
#include <string_view>

#include "netlist/cell_types.h"
#include "netlist/messages.h"
#include "text/message.h"
#include "text/time.h"

namespace grafwire {

/// A delay lies between these.
struct DelayBand {
    Time min = 0;
    Time max = 0;
    bool operator==(const DelayBand&) const = default;
};

struct EdgeBands {
    DelayBand rise;
    DelayBand fall;
    bool operator==(const EdgeBands&) const = default;
};

/// What is known of a part.
struct PartFigures {
    CellType type = CellType::buffer;
    std::uint32_t inputs = 1;
    std::string_view part;
    EdgeBands bounds;   ///< what it may take
    EdgeBands typical;  ///< the least and the greatest typical figure
    std::string_view source;
    const Message<>* note = nullptr;  ///< what else is to be said of the figures
};

/// Both edges alike, in nanoseconds.
constexpr EdgeBands either_edge(Time min, Time max) {
    return {{min * nanosecond, max * nanosecond}, {min * nanosecond, max * nanosecond}};
}
/// Rise, then fall.
constexpr EdgeBands edges(Time rise_min, Time rise_max, Time fall_min, Time fall_max) {
    return {{rise_min * nanosecond, rise_max * nanosecond},
            {fall_min * nanosecond, fall_max * nanosecond}};
}

// Per type, the narrower gates first.

inline constexpr std::array<PartFigures, 16> parts_74hc{{
    {CellType::inverter, 1, "74HC04", either_edge(2, 24), either_edge(9, 9), "TI-HC, LT"},
    {CellType::nand_gate, 2, "74HC00", either_edge(1, 23), either_edge(7, 9),
     "Philips 74HC/HCT00, TI-HC, LT"},
    {CellType::nand_gate, 3, "74HC10", either_edge(2, 33), either_edge(11, 11), "LT",
     &messages::netlist::maximum_is_guessed},
    {CellType::nand_gate, 4, "74HC20", either_edge(2, 33), either_edge(10, 10), "LT",
     &messages::netlist::maximum_is_guessed},
    {CellType::nand_gate, 8, "74HC30", either_edge(2, 38), either_edge(12, 15),
     "Philips 74HC/HCT30, Philips 74HC133", &messages::netlist::maximum_is_widened},
    {CellType::nand_gate, 13, "74HC133", either_edge(2, 38), either_edge(9, 13),
     "Philips 74HC133, Hitachi HD74HC133"},
    {CellType::nor_gate, 2, "74HC02", either_edge(1, 23), either_edge(7, 9),
     "Philips 74HC/HCT02, TI-HC, LT"},
    {CellType::nor_gate, 3, "74HC27", either_edge(2, 33), either_edge(8, 10),
     "Philips 74HC/HCT27, LT", &messages::netlist::maximum_is_guessed},
    {CellType::nor_gate, 4, "74HC4002", either_edge(2, 33), either_edge(8, 8), "TI CD74HC4002",
     &messages::netlist::maximum_is_widened},
    {CellType::and_gate, 2, "74HC08", either_edge(1, 25), either_edge(7, 10),
     "TI CD74HC08, TI-HC, LT"},
    {CellType::and_gate, 3, "74HC11", either_edge(2, 28), either_edge(12, 12), "LT",
     &messages::netlist::maximum_is_guessed},
    {CellType::and_gate, 4, "74HC21", either_edge(2, 28), either_edge(9, 12),
     "NXP 74HC21, TI CD74HC21"},
    {CellType::or_gate, 2, "74HC32", either_edge(1, 25), either_edge(8, 10), "TI-HC, LT"},
    {CellType::or_gate, 3, "74HC4075", either_edge(2, 33), either_edge(8, 8),
     "Philips 74HC/HCT4075", &messages::netlist::maximum_is_guessed},
    {CellType::xor_gate, 2, "74HC86", either_edge(3, 25), either_edge(12, 14), "TI-HC, LT"},
    {CellType::flip_flop, 2, "74HC74", either_edge(3, 44), either_edge(17, 20), "TI-HC, LT"},
}};

inline constexpr std::array<PartFigures, 13> parts_74ls{{
    {CellType::inverter, 1, "74LS04", either_edge(2, 23), edges(9, 9, 10, 10), "TI-LS"},
    {CellType::nand_gate, 2, "74LS00", either_edge(2, 23), edges(9, 9, 10, 10), "TI-LS"},
    {CellType::nand_gate, 3, "74LS10", either_edge(2, 23), edges(9, 9, 10, 10), "TI-LS"},
    {CellType::nand_gate, 4, "74LS20", either_edge(2, 23), edges(9, 9, 10, 10), "TI-LS"},
    {CellType::nand_gate, 8, "74LS30", edges(2, 23, 3, 30), edges(8, 8, 13, 13), "TI-LS"},
    {CellType::nor_gate, 2, "74LS02", either_edge(2, 23), either_edge(10, 10), "TI-LS"},
    {CellType::nor_gate, 3, "74LS27", either_edge(2, 23), either_edge(10, 10), "TI-LS"},
    {CellType::and_gate, 2, "74LS08", edges(2, 23, 2, 30), edges(8, 8, 10, 10), "TI-LS"},
    {CellType::and_gate, 3, "74LS11", edges(2, 23, 2, 30), edges(8, 8, 10, 10), "TI-LS"},
    {CellType::and_gate, 4, "74LS21", edges(2, 23, 2, 30), edges(8, 8, 10, 10), "TI-LS"},
    {CellType::or_gate, 2, "74LS32", either_edge(3, 33), either_edge(14, 14),
     "TI-LS, Fairchild DM74LS32"},
    {CellType::xor_gate, 2, "74LS86", edges(5, 45, 3, 33), edges(20, 20, 13, 13), "TI-LS"},
    {CellType::flip_flop, 2, "74LS74", edges(3, 38, 6, 60), edges(13, 13, 25, 25), "TI-LS"},
}};

inline constexpr std::array<PartFigures, 16> parts_4000{{
    {CellType::inverter, 1, "4069", either_edge(12, 90), either_edge(50, 50), "M",
     &messages::netlist::is_not_buffered},
    {CellType::nand_gate, 2, "4011", either_edge(27, 250), either_edge(110, 125),
     "Motorola MC14001B, National CD4011BC, M", &messages::netlist::is_not_of_ub_parts},
    {CellType::nand_gate, 3, "4023", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::nand_gate, 4, "4012", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::nand_gate, 8, "4068", either_edge(50, 350), either_edge(200, 200),
     "Motorola MC14001B"},
    {CellType::nor_gate, 2, "4001", either_edge(27, 250), either_edge(110, 125),
     "Motorola MC14001B, National CD4001BC, M", &messages::netlist::is_not_of_ub_parts},
    {CellType::nor_gate, 3, "4025", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::nor_gate, 4, "4002", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::nor_gate, 8, "4078", either_edge(50, 350), either_edge(200, 200),
     "Motorola MC14001B"},
    {CellType::and_gate, 2, "4081", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::and_gate, 3, "4073", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::and_gate, 4, "4082", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::or_gate, 2, "4071", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::or_gate, 4, "4072", either_edge(40, 300), either_edge(160, 160),
     "Motorola MC14001B, M"},
    {CellType::xor_gate, 2, "4070", either_edge(27, 185), either_edge(110, 110), "M"},
    {CellType::flip_flop, 2, "4013", either_edge(43, 350), either_edge(175, 175), "M"},
}};

}  // namespace grafwire
