#include "playground/asked.h"

#include "support/files.h"

namespace grafwire::testing {

Json ask(playground::Core& core, const std::string& name, const Json& args,
         const playground::CheckProgress& progress) {
    const Json request{{"name", name}, {"args", args}};
    return Json::parse(core.call(request.dump(), progress));
}

Json ask(const std::string& name, const Json& args) {
    playground::Core core;
    return ask(core, name, args);
}

std::string chart_text(const std::string& name) {
    return example_text(name + ".grafcet");
}

}  // namespace grafwire::testing
