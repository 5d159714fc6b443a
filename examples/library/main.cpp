// Reads a chart, makes a netlist of it, checks that, and says what came of it.
//
//     verdict CHART.grafcet [STYLE]

#include <grafwire/grafwire.h>

#include <fstream>
#include <iostream>
#include <sstream>

namespace gw = grafwire::api;

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: verdict CHART.grafcet [STYLE]\n";
        return 2;
    }
    const std::string path = argv[1];
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();

    const auto chart = gw::read_chart(text.str(), path);
    std::cerr << gw::shown(chart.messages, path);
    if (!chart) return 2;

    gw::NetlistOptions options;
    if (argc > 2) options.style = argv[2];
    const auto netlist = gw::make_netlist(*chart.value, options);
    std::cerr << gw::shown(netlist.messages, path);
    if (!netlist) return 2;

    const auto checked = gw::check(*netlist.value);
    std::cerr << gw::shown(checked.messages, path);
    if (!checked) return 2;

    std::cout << chart.value->name() << ": " << chart.value->steps().size() << " steps, "
              << netlist.value->cell_count() << " cells, ";
    switch (checked.value->verdict) {
        case gw::Verdict::equivalent:
            std::cout << "equivalent in " << checked.value->coverage.cases << " cases\n";
            return 0;
        case gw::Verdict::different:
            std::cout << "different:\n";
            for (const gw::NamedText& witness : checked.value->witness) {
                if (witness.name == "witness.txt") std::cout << witness.text;
            }
            return 1;
        case gw::Verdict::undecided:
            std::cout << "undecided\n";
            return 3;
    }
}
