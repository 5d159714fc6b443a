// SBR 2 … SBR 8: the parts of the chart between those of the skeleton.

#include "s7/generate/listing_build.h"

namespace grafwire::s7 {

NetworkList ListingBuild::make_networks() {
    main_program();
    make_start();
    make_begin();
    subroutine(2, "SBR 2: preliminary calculations, edges");
    make_plain(SectionKind::edges);
    subroutine(3, "SBR 3: receptivities of the transitions, Tt = receptivity and Tfig");
    make_plain(SectionKind::receptivities);
    subroutine(4, "SBR 4: evolution of the graphs");
    make_evolution();
    subroutine(5, "SBR 5: forcing");
    make_orders();
    subroutine(6, "SBR 6: timers and counters");
    make_plain(SectionKind::times);
    subroutine(8, "SBR 8: outputs, freezing");
    make_plain(SectionKind::outputs);
    make_pulse();
    return std::move(networks_);
}

void ListingBuild::make_plain(SectionKind section) {
    for (const Statement& statement : program_.section(section)) write(statement);
    end_subroutine();
}

/// The transitions, Ts, then Init.
void ListingBuild::make_evolution() {
    const std::vector<Statement>& statements = program_.section(SectionKind::evolution);
    if (is_table(statements.front(), TableOperation::evolve)) nothing("There are no transitions");
    for (const Statement& statement : statements) {
        if (is_table(statement, TableOperation::evolve)) {
            formula("Ts = (Tp and not Td) or Ta", BitKind::previous, BitKind::deactivate,
                    BitKind::activate, BitKind::step);
        } else {
            write(statement);
        }
    }
    end_subroutine();
}

/// Orders, Ts, enclosures, AUdur, Tpulse, and stored actions. The formula of forcing stands in
/// every program, as in the skeleton; where nothing is forced it leaves Ts as it is.
void ListingBuild::make_orders() {
    call(10, "Tpulse");
    const std::vector<Statement>& statements = program_.section(SectionKind::orders);
    const auto force = [&] {
        formula("Ts = (Ts and not Tf0) or Tf1", BitKind::step, BitKind::forced_off,
                BitKind::forced_on, BitKind::step);
    };
    bool forces = false;
    for (const Statement& statement : statements) {
        forces = forces || is_table(statement, TableOperation::force);
    }
    if (!forces) {
        nothing("There are no forcing orders");
        force();
    }
    for (const Statement& statement : statements) {
        if (is_table(statement, TableOperation::force)) {
            force();
        } else if (is_table(statement, TableOperation::pulse)) {
            call(10, "Tpulse");
        } else {
            write(statement);
        }
    }
    make_plain(SectionKind::stored);
}

}  // namespace grafwire::s7
