#include <fmt/format.h>

#include <algorithm>

#include "command/check_request.h"
#include "command/exit_status.h"
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

int check_listing_file(const CheckRequest& request, const LoadedGrafcet& loaded,
                       Language language) {
    const Grafcet& grafcet = loaded.grafcet;
    if (request.io.empty()) {
        complain(
            fmt::format("--io: {} needs a table that says which address is which input, "
                        "output and step",
                        request.against));
        return bad_request;
    }
    // Read the table of assignment and the listing, and find everything the GRAFCET names in it.
    const auto io = load_assignment(request.io);
    if (!io) return bad_request;
    const auto listing = load_listing(request.against, request.cpu, &io->assignment);
    if (!listing) return bad_request;
    const auto binding = bind_listing(grafcet, io->assignment, io->source);
    if (!binding || !has_all_modes_or_none(grafcet, *binding)) return bad_request;
    // Compare it with the reference after every scan, in every reachable state.
    const ListingDevice device(*listing, cpu_named(request.cpu), *binding);
    const auto period = scan_period(request, grafcet, device);
    if (!period || !can_check(request, grafcet, true, false, device.has_modes()))
        return bad_request;
    const CheckResult result = compare_scans(request, grafcet, device, *period);
    // Find the network that a difference comes from, and report.
    ToldWitness told;
    std::vector<WitnessFile> files;
    if (result.witness) {
        const auto finding =
            find_cause(grafcet, *listing, cpu_named(request.cpu), *binding, *result.witness);
        const auto tell = [&](Language in) {
            return tell_listing_witness(grafcet, *listing, *result.witness, finding, device.error(),
                                        in);
        };
        told.text = tell(language);
        told.story = lines_of(tell(Language::english));
        files = files_of_scans(grafcet, device, *result.witness, told.text);
    }
    return report_check(request, grafcet, device_subject(request.path, request.against, *period),
                        result, told, files, language);
}

}  // namespace grafwire
