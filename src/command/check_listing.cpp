#include <fmt/format.h>

#include <algorithm>

#include "command/check_request.h"
#include "s7check/blame.h"
#include "s7check/listing_device.h"
#include "s7check/listing_story.h"

namespace grafwire {

namespace {

/// Init, AUdur and AUdoux have addresses, all of them or none; AUdoux needs none where it has
/// nothing to switch off.
bool has_all_modes_or_none(const Grafcet& grafcet, const s7::Binding& binding) {
    const bool has_continuous =
        std::any_of(grafcet.actions.begin(), grafcet.actions.end(),
                    [](const Action& action) { return action.kind == ActionKind::continuous; });
    const auto first = binding.inputs.end() - control_input_count;
    const auto end = binding.inputs.end() - (has_continuous ? 0 : 1);
    const auto count =
        std::count_if(first, end, [](const auto& operand) { return operand.has_value(); });
    if (count == 0 || count == end - first) return true;
    complain("Init, AUdur and AUdoux: give all three an address, or none");
    return false;
}

}  // namespace

std::optional<Judgement> judge_listing(const CheckRequest& request, const LoadedGrafcet& loaded,
                                       Language language) {
    const Grafcet& grafcet = loaded.grafcet;
    if (request.io.empty()) {
        complain(
            fmt::format("--io: {} needs a table that says which address is which input, "
                        "output and step",
                        request.against));
        return std::nullopt;
    }
    // Read the table of assignment and the listing, and find everything the GRAFCET names in it.
    const auto io = load_assignment(request.io);
    if (!io) return std::nullopt;
    const auto listing = load_listing(request.against, request.cpu, &io->assignment);
    if (!listing) return std::nullopt;
    const auto binding = bind_listing(grafcet, io->assignment, io->source);
    if (!binding || !has_all_modes_or_none(grafcet, *binding)) return std::nullopt;
    // Compare it with the reference after every scan, in every reachable state.
    const ListingDevice device(*listing, cpu_named(request.cpu), *binding);
    const auto period = scan_period(request, grafcet, device);
    if (!period) return std::nullopt;
    Judgement judgement{program_subject(request, loaded, device, *period), {}, {}, {}};
    if (!can_check(request, grafcet, judgement.subject, device.has_modes())) return std::nullopt;
    judgement.result = compare_scans(request, grafcet, device, *period);
    // Find the network that a difference comes from, and report.
    if (const auto& witness = judgement.result.witness) {
        const auto finding =
            find_cause(grafcet, *listing, cpu_named(request.cpu), *binding, *witness);
        const auto tell = [&](Language in) {
            return tell_listing_witness(grafcet, *listing, *witness, finding, device.error(), in);
        };
        judgement.told = told_by(tell, language);
        judgement.witness_files = files_of_scans(grafcet, device, *witness, judgement.told.text);
    }
    return judgement;
}

}  // namespace grafwire
