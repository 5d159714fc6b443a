// The roles that the makers of netlists give to inner nets, in one table: the files that are
// written explain those that they hold.

#include "netlist/net_roles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "text/utf8.h"

namespace grafwire {

namespace {

using Tail = NetRole::Tail;

/// In the order of names, a name without a tail first. `edge$` and `timer$` are named after nothing
/// else.
constexpr auto roles = std::to_array<NetRole>({
    {"", Tail::number, "a gate of a condition of the owner"},
    {"a", Tail::number, "a gate of the arithmetic that works out a value"},
    {"after", Tail::number, "N scans have been counted"},
    {"arm", Tail::nothing,
     "takes a part of a step to the other: the level before the edge was seen"},
    {"armed", Tail::nothing, "the step, or the source, once the level before the edge was seen"},
    {"back", Tail::nothing, "the owner inverted"},
    {"buf", Tail::nothing, "the owner, a gate delay later"},
    {"carry", Tail::number, "the carry out of bit N of the count"},
    {"cdx", Tail::nothing, "CDX of the step"},
    {"cdx", Tail::number, "term N of CDX"},
    {"clear", Tail::nothing, "of a transition: it is cleared; of a step: Init deactivates it"},
    {"count", Tail::number, "bit N of the count of scans"},
    {"disarm", Tail::nothing, "takes a part of a step back: the edge came and cleared nothing"},
    {"edge$", Tail::number, "edge N of the chart, counted from 0"},
    {"enclose", Tail::nothing, "of the enclosure of the graph"},
    {"enclosed", Tail::nothing, "the step, as far as the enclosing step is active"},
    {"evolved", Tail::nothing, "the step after the transitions, before any order"},
    {"fall", Tail::number, "falling edge of the owner, edge N of the chart"},
    {"falling", Tail::nothing, "the operand is 0, and the off-delay is running"},
    {"force", Tail::nothing, "of the forcing orders to the graph"},
    {"forced", Tail::nothing, "a forcing order activates the step"},
    {"fork", Tail::number, "0 while follower N of the transition, counted from 0, is being set"},
    {"free", Tail::nothing, "no forcing order stands against it"},
    {"free_of_init", Tail::nothing, "Init does not stand against it"},
    {"freeze", Tail::nothing, "of the freezing orders to the graph"},
    {"give", Tail::nothing, "0 while what follows is being set"},
    {"give", Tail::number, "0 while product N of the transition sets what follows"},
    {"held", Tail::nothing, "the owner as it was before the writes of this instant"},
    {"high", Tail::nothing, "always 1"},
    {"hold", Tail::nothing, "keeps the owner as it is"},
    {"idle", Tail::nothing, "nothing is being written to the owner"},
    {"init", Tail::nothing, "Init activates the step"},
    {"join", Tail::number, "0 while step N before the transition, counted from 0, is being reset"},
    {"link", Tail::nothing, "an enclosing step that becomes active activates what it is linked to"},
    {"linked", Tail::nothing, "the step, or activated by the step that encloses it"},
    {"low", Tail::nothing, "always 0"},
    {"may_evolve", Tail::nothing, "no order freezes the graph"},
    {"memory", Tail::nothing, "the operand of the edge, a scan ago"},
    {"merged", Tail::nothing, "0 while a token goes on into a step that is active already"},
    {"next", Tail::nothing, "the owner as it is from the next clock on"},
    {"not", Tail::nothing, "the owner inverted"},
    {"not_fallen", Tail::nothing, "the off-delay is running"},
    {"not_risen", Tail::nothing, "the on-delay is running"},
    {"off", Tail::nothing, "the operand of the timer inverted"},
    {"off", Tail::number, "0 while an order of the step switches a step off"},
    {"on", Tail::nothing, "the operand is 1, and the on-delay has passed"},
    {"on", Tail::number, "0 while an order of the step switches a step on"},
    {"or", Tail::nothing, "all that makes the step active, or keeps it so"},
    {"q", Tail::nothing, "the other gate of the latch"},
    {"q", Tail::number, "bit N of the counter"},
    {"reset", Tail::nothing, "resets the owner"},
    {"reset", Tail::number, "resets the owner: term N of CDX, or write N"},
    {"rise", Tail::number, "rising edge of the owner, edge N of the chart"},
    {"risen", Tail::nothing, "the on-delay has passed"},
    {"rising", Tail::nothing, "the operand is 1, and the on-delay is running"},
    {"run", Tail::nothing, "the count goes on"},
    {"running", Tail::nothing, "1 from the second scan on"},
    {"set", Tail::nothing, "sets the owner"},
    {"set", Tail::transition, "sets the owner: of a step, by transition T; of others, write T"},
    {"start", Tail::nothing, "0 while the initial situation is set up"},
    {"sum", Tail::number, "bit N of the count plus 1"},
    {"timer", Tail::number, "time condition N of the chart, counted from 0, of the owner"},
    {"timer$", Tail::number, "time condition N of the chart, counted from 0"},
    {"to", Tail::number, "a hidden step on the way to follower N of the transition"},
    {"unarmed", Tail::nothing, "the step, as long as the level before the edge was not seen"},
    {"unforced", Tail::nothing, "a forcing order deactivates the step"},
    {"value", Tail::nothing, "of the value of the counter"},
    {"via", Tail::nothing, "a hidden step between the two halves of the transition"},
    {"waiting", Tail::nothing, "the source, as long as the level before the edge was not seen"},
    {"when", Tail::number, "something is written to the owner"},
    {"write", Tail::number, "0 while a value is being written: write N of the transition"},
});

/// The row of that name and tail; the number of rows if there is none.
constexpr std::size_t find(std::string_view name, Tail tail) {
    const auto row = std::lower_bound(
        roles.begin(), roles.end(), name,
        [](const NetRole& role, std::string_view wanted) { return role.name < wanted; });
    for (auto at = row; at != roles.end() && at->name == name; ++at) {
        if (at->tail == tail) return static_cast<std::size_t>(at - roles.begin());
    }
    return roles.size();
}

/// The place of role_of() in the table; the number of rows if there is none.
std::size_t place_of(std::string_view owner, std::string_view part) {
    std::size_t digits = part.size();
    while (digits != 0 && is_digit(part[digits - 1])) --digits;
    const std::string_view name = part.substr(0, digits);
    if (digits == part.size()) {
        const std::size_t plain = find(name, Tail::nothing);
        if (plain != roles.size()) return plain;
    } else if (name.empty()) {
        if (owner == "edge") return find("edge$", Tail::number);
        return find(owner == "timer" ? "timer$" : name, Tail::number);
    } else {
        const std::size_t numbered = find(name, Tail::number);
        if (numbered != roles.size()) return numbered;
    }
    return part.starts_with("set") ? find("set", Tail::transition) : roles.size();
}

/// How the legend shows a role: `$setT`.
std::string shown(const NetRole& role) {
    constexpr std::string_view tails[] = {"", "N", "T"};
    return fmt::format("{}{}{}", role.name.ends_with('$') ? "" : "$", role.name,
                       tails[static_cast<std::size_t>(role.tail)]);
}

}  // namespace

const NetRole* role_of(std::string_view owner, std::string_view part) {
    const std::size_t place = place_of(owner, part);
    return place == roles.size() ? nullptr : &roles[place];
}

std::vector<std::string> legend_of_roles(const Netlist& netlist) {
    std::array<bool, roles.size() + 1> occurs{};
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const std::string_view name = netlist.names[static_cast<NetId>(i)];
        for (std::size_t at = name.find('$'); at != std::string_view::npos;) {
            const std::size_t end = name.find('$', at + 1);
            const std::string_view part = name.substr(at + 1, end - at - 1);
            occurs[place_of(name.substr(0, at), part)] = true;
            at = end;
        }
    }
    std::size_t longest = 0;
    for (std::size_t place = 0; place < roles.size(); ++place) {
        if (occurs[place]) longest = std::max(longest, shown(roles[place]).size());
    }
    std::vector<std::string> lines;
    for (std::size_t place = 0; place < roles.size(); ++place) {
        if (!occurs[place]) continue;
        lines.push_back(
            fmt::format("{:<{}}  {}", shown(roles[place]), longest, roles[place].meaning));
    }
    return lines;
}

}  // namespace grafwire
