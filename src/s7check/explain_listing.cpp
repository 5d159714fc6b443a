// A witness against a listing explained: the difference, the bit of the tables that it comes from,
// and the instructions in question.
//
// Which instructions of a network to show: a network is a run of logic, then what is done with its
// result, then perhaps further logic. Of that the part is wanted which ends in a certain write:
// back from it over what else is done with the same result, then over the logic.

#include "s7check/explain_listing.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/explanation_writer.h"
#include "s7/addresses/operand_text.h"
#include "s7/write_listing.h"
#include "s7check/candidate_networks.h"

namespace grafwire {

namespace {

using s7::Instruction;
using s7::Operation;

/// Works on the stack alone.
bool is_logic(const Instruction& instruction) {
    return instruction.operation < Operation::assign ||
           (instruction.operation > Operation::reset && instruction.operation < Operation::move);
}

bool leaves(const Instruction& instruction) {
    return instruction.operation == Operation::jump ||
           instruction.operation == Operation::conditional_return ||
           instruction.operation == Operation::call;
}

/// Marks the logic whose result an instruction uses, and the instruction.
void mark_with_logic(const std::vector<Instruction>& instructions, std::size_t index,
                     std::vector<bool>& marked) {
    marked[index] = true;
    std::size_t at = index;
    while (at > 0 && !is_logic(instructions[at - 1])) --at;
    for (; at > 0 && is_logic(instructions[at - 1]); --at) marked[at - 1] = true;
}

}  // namespace

std::vector<const Instruction*> excerpt(const s7::Network& network,
                                        const std::vector<s7::Operand>& places, std::size_t most) {
    const std::vector<Instruction>& instructions = network.instructions;
    std::vector<bool> marked(instructions.size(), false);
    const auto mark_all = [&](const auto& is_wanted) {
        bool found = false;
        for (std::size_t i = 0; i < instructions.size(); ++i) {
            if (!is_wanted(instructions[i])) continue;
            mark_with_logic(instructions, i, marked);
            found = true;
        }
        return found;
    };
    const bool found =
        mark_all([&](const Instruction& instruction) {
            return std::any_of(places.begin(), places.end(), [&](const s7::Operand& place) {
                return may_write(instruction, place);
            });
        }) ||
        mark_all([](const Instruction& instruction) {
            return leaves(instruction) || instruction.operation == Operation::set;
        });
    std::vector<const Instruction*> shown;
    for (std::size_t i = 0; i < instructions.size() && shown.size() < most; ++i) {
        if (marked[i] || !found) shown.push_back(&instructions[i]);
    }
    return shown;
}

namespace {

using Kind = Diagnosis::Kind;

constexpr std::size_t most_networks = 6;
constexpr std::size_t most_instructions = 10;  ///< of a network

std::string place_text(const s7::Operand& place) {
    return s7::write_operand(place, s7::Mnemonics::simatic);
}

/// What a bit of the tables is.
std::string bit_text(const Diagnosis& diagnosis, const ExplanationWriter& writer) {
    const auto of_step = [&](std::string_view table) {
        return fmt::format("{} {} {}", table, writer.localized("of", "de"), diagnosis.name);
    };
    switch (diagnosis.kind) {
        case Kind::receptivity:
            return fmt::format("{} ({})",
                               writer.localized("Tt of transition", "Tt de la transition"),
                               diagnosis.name);
        case Kind::timer:
            return fmt::format("{}", writer.localized("the timer", "la temporisation"));
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
            return diagnosis.name;
        case Kind::may_evolve:
            return fmt::format("{} {}", writer.localized("Tfig of graph", "Tfig du graphe"),
                               diagnosis.name);
        case Kind::var:
        case Kind::output:
            return diagnosis.name;
    }
    return {};
}

std::string network_text(const s7::Listing& listing, std::uint32_t number,
                         const ExplanationWriter& writer) {
    std::string text = fmt::format("{} {}", writer.localized("network", "réseau"), number);
    for (const s7::Network& network : listing.networks) {
        if (network.number != number) continue;
        if (!network.comment.empty()) text += fmt::format(" ({})", network.comment);
        if (network.where.is_known()) {
            text += fmt::format(", {} {}", writer.localized("line", "ligne"), network.where.line);
        }
        break;
    }
    return text;
}

/// The instructions of the networks in question, with their lines.
void explain_instructions(ExplanationWriter& writer, const s7::Listing& listing,
                          const Diagnosis& diagnosis) {
    std::vector<s7::Operand> places{diagnosis.place};
    for (const Diagnosis::Read& read : diagnosis.reads) places.push_back(read.place);
    writer.add(writer.localized("The instructions:\n", "Les instructions :\n"));
    for (std::size_t i = 0; i < diagnosis.networks.size(); ++i) {
        if (i == most_networks) {
            writer.add("  …\n");
            return;
        }
        for (const s7::Network& network : listing.networks) {
            if (network.number != diagnosis.networks[i]) continue;
            writer.add(fmt::format("  {}\n", network_text(listing, network.number, writer)));
            const auto shown = excerpt(network, places, most_instructions + 1);
            for (std::size_t k = 0; k < shown.size(); ++k) {
                if (k == most_instructions) {
                    writer.add("    …\n");
                    break;
                }
                writer.add(fmt::format("    {:>5}  {}\n", shown[k]->where.line,
                                       s7::write_instruction(*shown[k], s7::Mnemonics::simatic)));
            }
            break;
        }
    }
}

void explain_diagnosis(ExplanationWriter& writer, const s7::Listing& listing,
                       const Diagnosis& diagnosis) {
    writer.add(writer.localized("Where it comes from in the listing:\n",
                                "D'où cela vient dans le programme :\n"));
    writer.add(fmt::format(fmt::runtime(writer.localized(
                               "  {} ({}) is {} after the scan at {} ms, and should be {}\n",
                               "  {} ({}) vaut {} après le cycle à {} ms, et devrait valoir {}\n")),
                           bit_text(diagnosis, writer), place_text(diagnosis.place),
                           diagnosis.expected ? 0 : 1, format_milliseconds(diagnosis.at),
                           diagnosis.expected ? 1 : 0));
    if (diagnosis.networks.empty()) {
        writer.add(writer.localized("  no network writes it\n", "  aucun réseau ne l'écrit\n"));
        return;
    }
    writer.add(fmt::format(
        "  {} {}\n",
        diagnosis.should_have_written
            ? writer.localized("it should have been written by:", "aurait dû l'écrire :")
            : writer.localized("it was written by:", "l'a écrit :"),
        network_text(listing, diagnosis.networks[0], writer)));
    for (const Diagnosis::Read& read : diagnosis.reads) {
        writer.add(fmt::format(
            "  {} {} {} {} = {}, {}\n", writer.localized("network", "réseau"), read.network,
            writer.localized("reads", "lit"), place_text(read.place), read.value,
            read.writer ? fmt::format("{} {}",
                                      writer.localized("written by network", "écrit par le réseau"),
                                      *read.writer)
                        : std::string(writer.localized("which nobody has written",
                                                       "que personne n'a écrit"))));
    }
    std::vector<std::uint32_t> others;
    for (std::size_t i = 1; i < diagnosis.networks.size(); ++i) {
        others.push_back(diagnosis.networks[i]);
    }
    if (!others.empty()) {
        const bool is_one = others.size() == 1;
        writer.add(fmt::format("  {} {} {}\n",
                               writer.localized("if it is right, look at", "s'il est juste, voir"),
                               is_one ? writer.localized("network", "le réseau")
                                      : writer.localized("networks", "les réseaux"),
                               fmt::join(others, ", ")));
    }
    explain_instructions(writer, listing, diagnosis);
}

}  // namespace

std::string explain_listing_witness(const Grafcet& grafcet, const s7::Listing& listing,
                                    const Witness& witness,
                                    const std::optional<Diagnosis>& diagnosis,
                                    const std::optional<s7::RunError>& error, Language language) {
    ExplanationWriter writer(grafcet, witness, language);
    writer.explain_changes();
    writer.explain_reference();
    if (error) {
        writer.add(fmt::format("{} ({} {}, {} {}){} {}\n",
                               writer.localized("The listing stops", "Le programme s'arrête"),
                               writer.localized("network", "réseau"), error->network,
                               writer.localized("line", "ligne"), error->where.line,
                               writer.localized(":", " :"), error->message));
        return writer.take();
    }
    writer.explain_difference(writer.localized("the listing", "le programme"));
    if (diagnosis) explain_diagnosis(writer, listing, *diagnosis);
    return writer.take();
}

}  // namespace grafwire
