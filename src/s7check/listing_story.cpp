#include "s7check/listing_story.h"

#include <fmt/format.h>

#include "explain/story.h"
#include "s7/addresses/operand_text.h"
#include "s7/write_listing.h"
#include "s7check/listing_excerpt.h"

namespace grafwire {

namespace {

using Kind = Finding::Kind;

constexpr std::size_t most_networks = 6;
constexpr std::size_t most_instructions = 10;  ///< of a network

std::string place_text(const s7::Operand& place) {
    return s7::write_operand(place, s7::Mnemonics::simatic);
}

/// What a bit of the tables is.
std::string bit_text(const Finding& finding, const Story& story) {
    const auto of_step = [&](std::string_view table) {
        return fmt::format("{} {} {}", table, story.choose("of", "de"), finding.name);
    };
    switch (finding.kind) {
        case Kind::receptivity:
            return fmt::format("{} ({})", story.choose("Tt of transition", "Tt de la transition"),
                               finding.name);
        case Kind::timer:
            return fmt::format("{}", story.choose("the timer", "la temporisation"));
        case Kind::previous:
            return of_step("Tp");
        case Kind::activate:
            return of_step("Ta");
        case Kind::deactivate:
            return of_step("Td");
        case Kind::forced_on:
            return of_step("Tf1");
        case Kind::forced_off:
            return of_step("Tf0");
        case Kind::situation:
            return finding.name;
        case Kind::may_evolve:
            return fmt::format("{} {}", story.choose("Tfig of graph", "Tfig du graphe"),
                               finding.name);
        case Kind::var:
        case Kind::output:
            return finding.name;
    }
    return {};
}

std::string network_text(const s7::Listing& listing, std::uint32_t number, const Story& story) {
    std::string text = fmt::format("{} {}", story.choose("network", "réseau"), number);
    for (const s7::Network& network : listing.networks) {
        if (network.number != number) continue;
        if (!network.comment.empty()) text += fmt::format(" ({})", network.comment);
        if (network.where.is_known()) {
            text += fmt::format(", {} {}", story.choose("line", "ligne"), network.where.line);
        }
        break;
    }
    return text;
}

/// The instructions of the networks in question, with their lines.
void tell_instructions(Story& story, const s7::Listing& listing, const Finding& finding) {
    std::vector<s7::Operand> places{finding.place};
    for (const Finding::Read& read : finding.reads) places.push_back(read.place);
    story.add(story.choose("The instructions:\n", "Les instructions :\n"));
    for (std::size_t i = 0; i < finding.networks.size(); ++i) {
        if (i == most_networks) {
            story.add("  …\n");
            return;
        }
        for (const s7::Network& network : listing.networks) {
            if (network.number != finding.networks[i]) continue;
            story.add(fmt::format("  {}\n", network_text(listing, network.number, story)));
            const auto shown = excerpt(network, places, most_instructions + 1);
            for (std::size_t k = 0; k < shown.size(); ++k) {
                if (k == most_instructions) {
                    story.add("    …\n");
                    break;
                }
                story.add(fmt::format("    {:>5}  {}\n", shown[k]->where.line,
                                      s7::write_instruction(*shown[k], s7::Mnemonics::simatic)));
            }
            break;
        }
    }
}

void tell_finding(Story& story, const s7::Listing& listing, const Finding& finding) {
    story.add(story.choose("Where it comes from in the listing:\n",
                           "D'où cela vient dans le programme :\n"));
    story.add(fmt::format(fmt::runtime(story.choose(
                              "  {} ({}) is {} after the scan at {} ms, and should be {}\n",
                              "  {} ({}) vaut {} après le cycle à {} ms, et devrait valoir {}\n")),
                          bit_text(finding, story), place_text(finding.place),
                          finding.expected ? 0 : 1, format_milliseconds(finding.at),
                          finding.expected ? 1 : 0));
    if (finding.networks.empty()) {
        story.add(story.choose("  no network writes it\n", "  aucun réseau ne l'écrit\n"));
        return;
    }
    story.add(
        fmt::format("  {} {}\n",
                    finding.should_have_written
                        ? story.choose("it should have been written by:", "aurait dû l'écrire :")
                        : story.choose("it was written by:", "l'a écrit :"),
                    network_text(listing, finding.networks[0], story)));
    for (const Finding::Read& read : finding.reads) {
        story.add(fmt::format(
            "  {} {} {} {} = {}, {}\n", story.choose("network", "réseau"), read.network,
            story.choose("reads", "lit"), place_text(read.place), read.value,
            read.writer
                ? fmt::format("{} {}", story.choose("written by network", "écrit par le réseau"),
                              *read.writer)
                : std::string(story.choose("which nobody has written", "que personne n'a écrit"))));
    }
    std::vector<std::uint32_t> others;
    for (std::size_t i = 1; i < finding.networks.size(); ++i) {
        others.push_back(finding.networks[i]);
    }
    if (!others.empty()) {
        const bool is_one = others.size() == 1;
        story.add(fmt::format(
            "  {} {} {}\n", story.choose("if it is right, look at", "s'il est juste, voir"),
            is_one ? story.choose("network", "le réseau") : story.choose("networks", "les réseaux"),
            fmt::join(others, ", ")));
    }
    tell_instructions(story, listing, finding);
}

}  // namespace

std::string tell_listing_witness(const Grafcet& grafcet, const s7::Listing& listing,
                                 const Witness& witness, const std::optional<Finding>& finding,
                                 const std::optional<s7::RunError>& error, Language language) {
    Story story(grafcet, witness, language);
    story.tell_changes();
    story.tell_reference();
    if (error) {
        story.add(fmt::format(
            "{} ({} {}, {} {}){} {}\n", story.choose("The listing stops", "Le programme s'arrête"),
            story.choose("network", "réseau"), error->network, story.choose("line", "ligne"),
            error->where.line, story.choose(":", " :"), error->message));
        return story.take();
    }
    story.tell_difference(story.choose("the listing", "le programme"));
    if (finding) tell_finding(story, listing, *finding);
    return story.take();
}

}  // namespace grafwire
