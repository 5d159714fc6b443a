// An instant of a simulation, gate by gate: which nets, when, and what made them change.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> zooming(const std::string& chart, const std::string& stimuli,
                                 const std::string& at, const std::vector<std::string>& more) {
    std::vector<std::string> request = {"simulate", chart, stimuli, "--zoom", at};
    request.insert(request.end(), more.begin(), more.end());
    return request;
}

/// UTF-8, a character each.
std::vector<std::string> characters_of(const std::string& text) {
    std::vector<std::string> characters;
    for (const char c : text) {
        const bool goes_on = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;
        if (!goes_on) characters.emplace_back();
        characters.back() += c;
    }
    return characters;
}

/// The picture for WaveDrom, read.
class Zoomed {
  public:
    explicit Zoomed(std::vector<std::string> request, int status = 0) {
        request.insert(request.end(), {"--to", "wavedrom"});
        const Ran ran = grafwire_with(request);
        CHECK(ran.status == status);
        const Json json = Json::parse(ran.out);
        title = json["head"]["text"];
        for (const Json& time : json["signal"][0]["data"]) times.push_back(time);
        for (const Json& item : json["signal"]) {
            if (!item.is_array()) {
                note_nodes(item);
                continue;
            }
            for (std::size_t i = 1; i < item.size(); ++i) {
                names.push_back(item[i]["name"]);
                waves.push_back(item[i]["wave"]);
                note_nodes(item[i]);
            }
        }
        if (json.contains("edge")) {
            for (const Json& edge : json["edge"]) note_edge(edge);
        }
    }

    std::string wave(const std::string& name) const {
        const auto found = std::find(names.begin(), names.end(), name);
        REQUIRE(found != names.end());
        return waves[static_cast<std::size_t>(found - names.begin())];
    }
    /// `m 0ns > X1$set0 1ns`.
    bool has_cause(const std::string& cause) const {
        return std::find(causes.begin(), causes.end(), cause) != causes.end();
    }

    std::string title;
    std::vector<std::string> times, names, waves, causes;

  private:
    void note_nodes(const Json& signal) {
        if (!signal.contains("node")) return;
        const std::vector<std::string> nodes = characters_of(signal["node"]);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (nodes[i] == ".") continue;
            places[nodes[i]] = signal["name"].get<std::string>() + ' ' + times.at(i);
        }
    }
    /// `A|->B`, and what stands beside the arrow.
    void note_edge(const std::string& edge) {
        const std::size_t end = edge.find('>') + 1;
        const std::string to = characters_of(edge.substr(end)).at(0);
        causes.push_back(places.at(characters_of(edge).at(0)) + " > " + places.at(to) +
                         edge.substr(end + to.size()));
    }

    std::map<std::string, std::string> places;  ///< by the names of nodes
};

const std::vector<std::string> nand = {"--style", "nand"};

}  // namespace

TEST_CASE("zoom: the nets that change in the order of the chart, and what made them change") {
    const Zoomed zoomed(zooming(sequence_chart, sequence_stimuli, "300ms", nand));
    CHECK(zoomed.title == "Séquence unique – gates at 300ms");
    CHECK(zoomed.times ==
          std::vector<std::string>{"before", "0ns", "1ns", "2ns", "3ns", "4ns", "5ns", "6ns"});
    CHECK(zoomed.names == std::vector<std::string>{"m", "X0", "X0$reset0", "X0$q", "X1", "X1$set0",
                                                   "X1$q", "X2$reset0"});
    CHECK(zoomed.wave("m") == "01......");
    CHECK(zoomed.wave("X1$set0") == "1.0....1");
    CHECK(zoomed.wave("X1") == "0..1....");
    CHECK(zoomed.wave("X0") == "1.....0.");
    // The gate of the latch follows its own input; X0 falls because X1 has risen.
    CHECK(zoomed.causes == std::vector<std::string>{"m 0ns > X1$set0 1ns", "X1$set0 1ns > X1 2ns",
                                                    "X1 2ns > X0$reset0 3ns", "X1 2ns > X1$q 3ns",
                                                    "X0$reset0 3ns > X0$q 4ns", "X0$q 4ns > X0 5ns",
                                                    "X0 5ns > X1$set0 6ns",
                                                    "X0 5ns > X2$reset0 6ns"});
}

TEST_CASE("zoom: the end of a delay, an edge and an instant in which nothing changes") {
    const std::string chart = example("manipulator.grafcet");
    const std::string stimuli = example("manipulator.stim");
    const Zoomed delay(zooming(chart, stimuli, "8750ms", nand));
    CHECK(delay.has_cause("time 0ns > 5s/X13 0ns 5s/X13"));
    CHECK(delay.wave("H+") == "0...1....");
    const Zoomed edge(zooming(chart, stimuli, "300ms", nand));
    CHECK(edge.has_cause("dcy 0ns > ↑dcy 1ns"));
    CHECK(edge.wave("↑dcy") == "0.1.0.......");
    const Zoomed quiet(zooming(chart, stimuli, "21900ms", nand));
    CHECK(quiet.names.empty());
    CHECK(quiet.title == "Manipulateur en L – gates at 21.9s: nothing changes");
}

TEST_CASE("zoom: scan by scan, what one scan does; flip-flops change with the clock") {
    const std::vector<std::string> clocked = {"--style", "clocked", "--scan", "10ms"};
    const Zoomed scan(zooming(sequence_chart, sequence_stimuli, "300ms", clocked));
    CHECK(scan.names.front() == "clk");
    CHECK(scan.wave("clk") == "0......1...0");
    CHECK(scan.has_cause("clk 6ns > X0 7ns"));
    CHECK(scan.has_cause("clk 6ns > X1 7ns"));
    CHECK(grafwire_with(zooming(sequence_chart, sequence_stimuli, "305ms",
                                {"--style", "clocked", "--scan", "10ms", "--to", "svg"}))
              .status == 2);
}

TEST_CASE("zoom: gates that do not settle: the beginning, and status 1") {
    const ScratchFolder folder;
    const std::string chart =
        folder.file("loop.grafcet",
                    "input a\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : a\n  1 -> 0 : a\n}\n");
    const std::string stimuli = folder.file("loop.stim", "5ms : a=1\n9ms : end\n");
    const Zoomed zoomed(zooming(chart, stimuli, "5ms", {"--style", "clocked"}), 1);
    CHECK(zoomed.title == "grafcet – gates at 5ms, which do not settle");
    CHECK(zoomed.has_cause("a 0ns > (0) 1ns"));
    const Ran after =
        grafwire_with(zooming(chart, stimuli, "9ms", {"--style", "clocked", "--to", "svg"}));
    CHECK(after.status == 2);
    CHECK(contains(after.err, "does not settle at 5 ms"));
    CHECK(contains(after.err, "no instant at 9ms; nearest to it: 5ms"));
}

TEST_CASE("zoom: gates that do not settle at their start have no instants: a picture of none") {
    const ScratchFolder folder;
    // The first cycle, with Init at 1, lets the ring go.
    const std::string netlist =
        folder.file("ring.blif",
                    ".model ring\n.inputs clk m a b Init AUdur AUdoux\n.outputs X0 X1 X2\n"
                    ".latch Init X0 re clk 3\n.latch m X1 re clk 3\n.latch ring X2 re clk 3\n"
                    ".names Init ring ring\n0- 1\n-0 1\n.end\n");
    for (const std::string at : {"0s", "300ms", "1h"}) {
        const Zoomed zoomed(zooming(sequence_chart, sequence_stimuli, at, {"--against", netlist}),
                            1);
        CHECK(zoomed.title == "Séquence unique – gates at " + at + ", which do not settle");
        CHECK(zoomed.times.empty());
        CHECK(zoomed.names.empty());
    }
    const Ran picture = grafwire_with(
        zooming(sequence_chart, sequence_stimuli, "300ms", {"--against", netlist, "--to", "svg"}));
    CHECK(picture.status == 1);
    CHECK(contains(picture.err, "does not settle at 0 ms; these keep changing: NAND gate ring"));
    CHECK(contains(picture.out, "<svg "));
}

TEST_CASE("zoom: of gates that go round for long, 64 moments") {
    const ScratchFolder folder;
    std::string ring = ".model ring\n.inputs m a b\n.outputs X0 X1 X2\n.names m n70 X0\n11 0\n";
    for (int i = 1; i <= 70; ++i) {
        const std::string before = i == 1 ? "X0" : "n" + std::to_string(i - 1);
        ring += ".names " + before + " n" + std::to_string(i) + "\n0 1\n";
    }
    ring += ".names a X1\n1 1\n.names b X2\n1 1\n.end\n";
    const Zoomed zoomed(zooming(sequence_chart, sequence_stimuli, "300ms",
                                {"--against", folder.file("ring.blif", ring)}),
                        1);
    CHECK(zoomed.times.size() == 65);
    CHECK(zoomed.names.size() == 64);
}

TEST_CASE("zoom: a netlist from elsewhere is unknown where it starts unknown") {
    const ScratchFolder folder;
    const std::string netlist = folder.file(
        "bare.blif",
        ".model bare\n.inputs m a b\n.outputs X0 X1 X2\n.names X2 b X1 X0 X0\n11-- 1\n--01 1\n"
        ".names X0 m X2 X1 X1\n11-- 1\n--01 1\n.names X1 a X0 X2 X2\n11-- 1\n--01 1\n.end\n");
    const Zoomed zoomed(zooming(sequence_chart, sequence_stimuli, "300ms", {"--against", netlist}));
    REQUIRE(zoomed.waves.size() == 2);
    CHECK(zoomed.waves[1] == "0.x");
}

TEST_CASE("zoom: what is refused") {
    const auto refused = [](const std::string& at, const std::vector<std::string>& more) {
        std::vector<std::string> options = nand;
        options.insert(options.end(), more.begin(), more.end());
        const Ran ran = grafwire_with(zooming(sequence_chart, sequence_stimuli, at, options));
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        return ran.err;
    };
    CHECK(contains(refused("350ms", {"--to", "svg"}),
                   "the run has no instant at 350ms; nearest to it: 300ms, 400ms"));
    CHECK(contains(refused("1h", {"--to", "svg", "--lang", "fr"}),
                   "l'évolution n'a pas d'instant à 1h\u00a0; les plus proches\u00a0: "));
    CHECK(contains(refused("soon", {"--to", "svg"}), "'soon' is no moment"));
    CHECK(contains(refused("300ms", {}), "csv has no --zoom; it is for svg, wavedrom"));
    CHECK(grafwire_with({"run", sequence_chart, sequence_stimuli, "--zoom", "300ms"}).status == 2);
}

TEST_CASE("zoom: in words beside it, and the waveform of the whole run") {
    const ScratchFolder folder;
    const std::string picture = folder.path("picture.svg");
    const std::string vcd = folder.path("run.vcd");
    const Ran ran = grafwire_with(
        zooming(sequence_chart, sequence_stimuli, "300ms",
                {"--style", "nand", "--to", "svg", "--explain", "-o", picture, "--vcd", vcd}));
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, "At 400 ms:"));
    CHECK(contains(text_of(picture), "<g class=\"axis\">"));
    CHECK(contains(text_of(vcd), "$enddefinitions"));
}

}  // namespace grafwire::testing
