// The table of the netlist styles, and the way from equations to an annotated netlist in one of
// them. The help of the program, its "did you mean" and the tests go through the rows.

#include "netlist/styles/styles.h"

#include <array>
#include <cassert>

#include "netlist/styles/annotate.h"
#include "netlist/styles/messages.h"

namespace grafwire {

namespace {

// A new style is a file style_NAME.cpp, its name and its maker in styles.h, and a row here.
constexpr auto rows = std::to_array<StyleRow>({
    {Style::gates,
     "gates",
     {"phase modules of AND, OR and NOT gates", "modules de phase en portes ET, OU et NON"},
     CdxForm::successor,
     false,
     make_gates},
    {Style::nand,
     "nand",
     {"set-priority latches of NAND gates", "bascules de portes NON-ET, priorité à l'activation"},
     CdxForm::successor,
     false,
     make_nand},
    {Style::nor,
     "nor",
     {"reset-priority latches of NOR gates",
      "bascules de portes NON-OU, priorité à la désactivation"},
     CdxForm::successor,
     false,
     make_nor},
    {Style::clocked,
     "clocked",
     {"a D flip-flop per step on a common clock",
      "une bascule D par étape, sur une horloge commune"},
     CdxForm::transition,
     true,
     make_clocked},
    {Style::rs,
     "rs",
     {"RS latches of two NAND gates, set and reset at once",
      "bascules RS de deux portes NON-ET, sans blocage"},
     CdxForm::successor,
     false,
     make_rs},
    {Style::handshake,
     "handshake",
     {"NAND gates, right under any delay of the gates",
      "portes NON-ET, juste quels que soient les temps des portes"},
     CdxForm::successor,
     false,
     make_handshake,
     refuse_handshake},
});

constexpr bool stand_in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (static_cast<std::size_t>(rows[i].style) != i) return false;
    }
    return true;
}
static_assert(stand_in_order());

void refuse_counters(const Grafcet& grafcet, const StyleRow& row, Diagnostics& diagnostics) {
    for (const Counter& counter : grafcet.counters) {
        diagnostics.error(code::unsupported_by_style, counter.where,
                          messages::netlist_styles::no_registers(row.name, counter.name));
    }
}

}  // namespace

constinit const std::span<const StyleRow> style_table = rows;

std::optional<Netlist> netlist_from(const Grafcet& grafcet, const Equations& equations, Style style,
                                    Diagnostics& diagnostics, const DelayModel& delays) {
    const StyleRow& row = style_table[static_cast<std::size_t>(style)];
    if (!row.has_registers) refuse_counters(grafcet, row, diagnostics);
    if (row.refuse != nullptr && !diagnostics.has_errors())
        row.refuse(grafcet, equations, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    Netlist netlist = row.make(grafcet, equations, delays);
    annotate(netlist, grafcet, equations);
    assert(fault_of(netlist).empty());
    return netlist;
}

}  // namespace grafwire
