#include "explain/named_chain.h"

#include <string>
#include <utility>

namespace grafwire {

std::vector<Explanation::Link> named_chain(const Netlist& netlist, const NetHistory& history,
                                           const std::vector<CausalLink>& links, Time instant) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::vector<Explanation::Link> chain;
    for (const CausalLink& link : links) {
        const NetChange& change = history.changes[link.change];
        Explanation::Link shown;
        shown.after = change.at - instant;
        shown.cell = drivers[change.net];
        shown.net = std::string(netlist.names[change.net]);
        shown.value = change.value;
        shown.is_begin = link.causes.empty();
        for (const std::size_t cause : link.causes) {
            shown.causes.emplace_back(netlist.names[history.changes[cause].net]);
        }
        chain.push_back(std::move(shown));
    }
    return chain;
}

}  // namespace grafwire
