// A chart as a French teacher types it, with an accent composed in one place and decomposed in
// another, a var that steps hold, names for a condition and a duration: through every form.

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

constexpr const char* paper_chart = R"(# Tri de pièces
entrée dcy, présence, fc
sortie "V+", éjecteur
variable AUTO, m
durée T1 = 20ms
définir prêt = présence et non fc
graphe G1 {
  étape initiale 0
  étape 1 : "V+" si prêt, AUTO
  étape 2 : éjecteur, AUTO si présence, set m
  (départ) 0 → 1 : ↑dcy
  1 → 2 : prêt . T1/X1
  2 → 0 : AUTO et fc ou non présence
}
)";

/// With an e and a combining accent.
constexpr const char* paper_stimuli =
    "0ms : dcy=0 pre\u0301sence=1\n10ms : dcy=1\n100ms : fc=1\n200ms : end\n";

}  // namespace

TEST_CASE("the held var has its column, in the place where it is declared") {
    const ScratchFolder folder;
    const std::string file = folder.file("tri.grafcet", paper_chart);
    const Ran ran = grafwire_with({"run", file, folder.file("tri.stim", paper_stimuli)});
    CHECK(ran.err == "");
    CHECK(ran.out ==
          "time_ms,dcy,présence,fc,Init,AUdur,AUdoux,X0,X1,X2,V+,éjecteur,AUTO,m\n"
          "0,0,1,0,0,0,0,1,0,0,0,0,0,0\n"
          "10,1,1,0,0,0,0,0,1,0,1,0,1,0\n"
          "30,1,1,0,0,0,0,0,0,1,0,1,1,1\n"
          "100,1,1,1,0,0,0,1,0,0,0,0,0,1\n"
          "200,1,1,1,0,0,0,1,0,0,0,0,0,1\n");
}

TEST_CASE("gates have the held var as well") {
    const ScratchFolder folder;
    const std::string file = folder.file("tri.grafcet", paper_chart);
    const std::string stim = folder.file("tri.stim", paper_stimuli);
    for (const char* style : {"gates", "nand", "nor", "clocked"}) {
        INFO("style: " << style);
        const Ran ran = grafwire_with({"simulate", file, stim, "--style", style});
        CHECK(ran.status == 0);
        CHECK(ran.out == grafwire_with({"run", file, stim}).out);
    }
}

TEST_CASE("programs of such a chart do what it does") {
    const ScratchFolder folder;
    const std::string file = folder.file("tri.grafcet", paper_chart);
    const std::string ladder = folder.path("tri.xml");
    const std::string listing = folder.path("tri.awl");
    const std::string addresses = folder.path("tri.io");
    CHECK(grafwire_with({"plc", file, "--to", "plcopen", "-o", ladder}).status == 0);
    CHECK(grafwire_with({"plc", file, "--to", "s7-200", "-o", listing, "--addresses", addresses})
              .status == 0);
    const Ran of_ladder = grafwire_with({"check", file, "--against", ladder});
    CHECK_MESSAGE(of_ladder.status == 0, of_ladder.out << of_ladder.err);
    const Ran of_listing = grafwire_with({"check", file, "--against", listing, "--io", addresses});
    CHECK_MESSAGE(of_listing.status == 0, of_listing.out << of_listing.err);
}

TEST_CASE("a port with a decomposed accent is that of the chart") {
    const ScratchFolder folder;
    const std::string file = folder.file("p.grafcet",
                                         "entrée présence\ngraphe G {\n  étape initiale 0\n  étape "
                                         "1\n  0 -> 1 : présence\n  1 -> 0 : non présence\n}\n");
    const Ran written = grafwire_with({"netlist", file, "--style", "nand", "--to", "blif"});
    REQUIRE(written.status == 0);
    std::string blif = written.out;
    for (std::size_t at = blif.find("é"); at != blif.npos; at = blif.find("é", at)) {
        blif.replace(at, std::string("é").size(), "e\u0301");
    }
    const Ran ran = grafwire_with({"check", file, "--against", folder.file("p.blif", blif)});
    CHECK(ran.status == 0);
    CHECK(ran.err == "");
}

}  // namespace grafwire::testing
