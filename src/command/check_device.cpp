#include "command/check_device.h"

#include <fmt/format.h>

#include "check/ladder_device.h"
#include "ladder/read_plcopen_ladder.h"

namespace grafwire {

namespace {

class LadderToCheck : public DeviceToCheck {
  public:
    LadderToCheck(const Grafcet& grafcet, ladder::Ladder ladder, LadderNames names)
        : ladder_(std::move(ladder)), device_(grafcet, ladder_, std::move(names)) {}

    const ScannedDevice& device() const override { return device_; }
    std::string tell(const Witness& witness, Language language) const override {
        return device_.tell(witness, language);
    }

  private:
    ladder::Ladder ladder_;
    LadderDevice device_;
};

std::unique_ptr<DeviceToCheck> load_ladder(const std::string& path, const std::string& program,
                                           const LoadedGrafcet& loaded, Language language) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<ladder::Ladder> ladder;
    if (!diagnostics.has_errors()) {
        ladder = ladder::read_plcopen_ladder(source, diagnostics, program);
    }
    diagnostics.sort_by_place();
    std::fputs(format_diagnostics(diagnostics, source, 20).c_str(), stderr);
    if (!ladder) return nullptr;
    LadderNames names = find_names(loaded.grafcet, *ladder);
    const bool french = language == Language::french;
    if (!names.missing.empty()) {
        complain(fmt::format(
            fmt::runtime(french
                             ? "{}: pas de variable BOOL de ce nom : {} ; chaque étape (X...) et "
                               "chaque sortie doit avoir la sienne"
                             : "{}: no BOOL variable of this name: {}; every step (X...) and "
                               "every output must have its own"),
            path, fmt::join(names.missing, ", ")));
        return nullptr;
    }
    if (!names.missing_inputs.empty()) {
        warn(fmt::format(fmt::runtime(french ? "{}: sans l'entrée {}" : "{}: has no input {}"),
                         path, fmt::join(names.missing_inputs, ", ")));
    }
    return std::make_unique<LadderToCheck>(loaded.grafcet, std::move(*ladder), std::move(names));
}

}  // namespace

bool is_device_file(const std::string& path) {
    return path.ends_with(".xml");
}

std::unique_ptr<DeviceToCheck> load_device(const std::string& path, const std::string& program,
                                           const LoadedGrafcet& loaded, Language language) {
    return load_ladder(path, program, loaded, language);
}

}  // namespace grafwire
