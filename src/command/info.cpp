#include "command/command.h"
#include "command/exit_status.h"
#include "command/inputs.h"
#include "grafcet/describe_grafcet.h"

namespace grafwire {

std::function<int()> declare_info(const CommandLine& line, const Language& language) {
    const auto path = std::make_shared<std::string>();
    line.add("FILE", *path, "the GRAFCET, - for standard input").required();
    return [path, &language] {
        // Read and check; errors and warnings go to standard error.
        const auto loaded = load_grafcet(*path);
        if (!loaded) return static_cast<int>(bad_request);
        show_wiring_warnings(*loaded, CdxForm::successor);
        // Describe it.
        OutputFiles files({*path});
        files.add("-", describe_grafcet(loaded->grafcet, language));
        return finish(files, done);
    };
}

}  // namespace grafwire
