#include <fmt/format.h>

#include "command/check_request.h"
#include "laddercheck/ladder_device.h"
#include "plcopen/read_plcopen_ladder.h"

namespace grafwire {

namespace {

std::optional<ladder::Ladder> load_ladder(const std::string& path, const std::string& program) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<ladder::Ladder> ladder;
    if (!diagnostics.has_errors()) {
        ladder = ladder::read_plcopen_ladder(source, diagnostics, program);
    }
    diagnostics.sort_by_place();
    show_diagnostics(diagnostics, source);
    return ladder;
}

/// Whether every step and output has its variable; shows what is missing.
bool can_compare(const std::string& path, const LadderNames& names, Language language) {
    const bool french = language == Language::french;
    if (!names.missing.empty()) {
        complain(fmt::format(
            fmt::runtime(french
                             ? "{}: pas de variable BOOL de ce nom : {} ; chaque étape (X...) et "
                               "chaque sortie doit avoir la sienne"
                             : "{}: no BOOL variable of this name: {}; every step (X...) and "
                               "every output must have its own"),
            path, fmt::join(names.missing, ", ")));
        return false;
    }
    if (!names.missing_inputs.empty()) {
        warn(fmt::format(fmt::runtime(french ? "{}: sans l'entrée {}" : "{}: has no input {}"),
                         path, fmt::join(names.missing_inputs, ", ")));
    }
    return true;
}

}  // namespace

std::optional<Judgement> judge_ladder(const CheckRequest& request, const LoadedGrafcet& loaded,
                                      Language language) {
    const Grafcet& grafcet = loaded.grafcet;
    // Read the diagram, and find everything the GRAFCET names in it.
    const auto ladder = load_ladder(request.against, request.program);
    if (!ladder) return std::nullopt;
    const LadderNames names = find_names(grafcet, *ladder);
    if (!can_compare(request.against, names, language)) return std::nullopt;
    // Compare it with the reference after every scan, in every reachable state.
    const LadderDevice device(grafcet, *ladder, names);
    const auto period = scan_period(request, grafcet, device);
    if (!period) return std::nullopt;
    Judgement judgement{program_subject(request, loaded, device, *period), {}, {}, {}};
    if (!can_check(request, grafcet, judgement.subject, device.has_modes())) return std::nullopt;
    judgement.result = compare_scans(request, grafcet, device, *period);
    // Report, with the networks that a difference comes from.
    if (const auto& witness = judgement.result.witness) {
        judgement.told = told_by([&](Language in) { return device.tell(*witness, in); }, language);
        judgement.witness_files = files_of_scans(grafcet, device, *witness, judgement.told.text);
    }
    return judgement;
}

}  // namespace grafwire
