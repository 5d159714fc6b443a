// A witness against a listing explained: the difference, the bit of the tables that it comes from,
// and the instructions in question.
//
// Which instructions of a network to show: a network is a run of logic, then what is done with its
// result, then perhaps further logic. Of that the part is wanted which ends in a certain write:
// back from it over what else is done with the same result, then over the logic:
//
//     LD    E0.3
//     =     A0.1
//     LD    V20.0      shown, if V70.0 is what is asked for
//     =     V1.0
//     S     V70.0 K4   shown
//     S     V80.0 K1

#include "s7check/explain_listing.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/explanation_writer.h"
#include "s7/addresses/operand.h"
#include "s7/write_listing.h"
#include "s7check/candidate_networks.h"
#include "s7check/messages.h"
#include "text/joined.h"

namespace grafwire {

namespace {

using s7::Instruction;
using s7::Operation;

/// Works on the stack alone.
bool is_logic(const Instruction& instruction) {
    return instruction.operation < Operation::assign ||
           (instruction.operation > Operation::reset && instruction.operation < Operation::move);
}

/// May go on elsewhere than with the next instruction.
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

namespace words = messages::s7check;
using Kind = Diagnosis::Kind;

constexpr std::size_t most_networks = 6;
constexpr std::size_t most_instructions = 10;  ///< of a network

/// A place in SIMATIC mnemonics: `E0.4`, `V70.0`.
std::string place_text(const s7::Operand& place) {
    return s7::write_operand(place, s7::Mnemonics::simatic);
}

/// What a bit of the tables is.
std::string bit_text(const Diagnosis& diagnosis, Language language) {
    const auto of_step = [&](const std::string& table) {
        return words::of_step.in(language, table, diagnosis.name);
    };
    switch (diagnosis.kind) {
        case Kind::receptivity:
            return words::of_transition.in(language, diagnosis.name);
        case Kind::timer:
            return words::the_timer.in(language);
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
            return words::of_graph.in(language, diagnosis.name);
        case Kind::var:
        case Kind::output:
            return diagnosis.name;
    }
    return {};
}

/// `network 49 (Traitement des forçages), line 187`
std::string network_text(const ExplanationWriter& writer, const s7::Listing& listing,
                         std::uint32_t number) {
    for (const s7::Network& network : listing.networks) {
        if (network.number == number) {
            return writer.network_text(number, network.comment, network.where);
        }
    }
    return writer.network_text(number, {}, {});
}

/// The instructions of the networks in question, with their lines.
void explain_instructions(ExplanationWriter& writer, const s7::Listing& listing,
                          const Diagnosis& diagnosis) {
    std::vector<s7::Operand> places{diagnosis.place};
    for (const Diagnosis::Read& read : diagnosis.reads) places.push_back(read.place);
    writer.say(words::the_instructions);
    for (std::size_t i = 0; i < diagnosis.networks.size(); ++i) {
        if (i == most_networks) {
            writer.add("  …\n");
            return;
        }
        for (const s7::Network& network : listing.networks) {
            if (network.number != diagnosis.networks[i]) continue;
            writer.add(fmt::format("  {}\n", network_text(writer, listing, network.number)));
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

/// The wrong bit, who wrote it or should have, what that network read, and where else to look.
void explain_diagnosis(ExplanationWriter& writer, const s7::Listing& listing,
                       const Diagnosis& diagnosis) {
    const Language language = writer.language();
    writer.say(words::where_it_comes_from);
    writer.say(words::bit_is_wrong, bit_text(diagnosis, language), place_text(diagnosis.place),
               diagnosis.expected ? 0 : 1, format_milliseconds(diagnosis.at),
               diagnosis.expected ? 1 : 0);
    if (diagnosis.networks.empty()) {
        writer.say(words::no_network_writes);
        return;
    }
    writer.say(
        diagnosis.should_have_written ? words::should_have_been_written_by : words::was_written_by,
        network_text(writer, listing, diagnosis.networks[0]));
    for (const Diagnosis::Read& read : diagnosis.reads) {
        if (read.writer) {
            writer.say(words::network_reads, read.network, place_text(read.place), read.value,
                       *read.writer);
        } else {
            writer.say(words::network_reads_unwritten, read.network, place_text(read.place),
                       read.value);
        }
    }
    const std::vector<std::uint32_t> others(diagnosis.networks.begin() + 1,
                                            diagnosis.networks.end());
    if (!others.empty()) {
        writer.add(words::look_at_networks.in(language, others.size(), joined(others, ", ")));
    }
    explain_instructions(writer, listing, diagnosis);
}

}  // namespace

std::string explain_listing_witness(const Grafcet& grafcet, const s7::Listing& listing,
                                    const Witness& witness,
                                    const std::optional<Diagnosis>& diagnosis,
                                    const std::optional<ScannedDevice::Stop>& stop,
                                    Language language) {
    ExplanationWriter writer(grafcet, witness, language);
    writer.explain_changes();
    writer.explain_reference();
    if (stop) {
        writer.say(words::listing_stops, stop->network, stop->where.line, stop->message);
        return writer.take();
    }
    writer.explain_difference(words::the_listing);
    if (diagnosis) explain_diagnosis(writer, listing, *diagnosis);
    return writer.take();
}

}  // namespace grafwire
