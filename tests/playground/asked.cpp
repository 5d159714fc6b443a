#include "playground/asked.h"

#include <cstdlib>
#include <fstream>

#include "support/files.h"

namespace grafwire::testing {

namespace {

int next_number() {
    static int number = 0;
    return ++number;
}

/// Where GRAFWIRE_ANSWERS names a file, every question goes there with its answer, a line of JSON
/// each: tools/playground/compare.mjs puts the same questions to the WebAssembly module.
void record(int core, const Json& request, const Json& answer) {
    static std::ofstream file;
    const char* path = std::getenv("GRAFWIRE_ANSWERS");
    if (path == nullptr) return;
    if (!file.is_open()) file.open(path);
    file << Json{{"core", core}, {"request", request}, {"answer", answer}}.dump() << '\n';
}

}  // namespace

AskedCore::AskedCore() : number_(next_number()) {}

Json AskedCore::ask(const std::string& name, const Json& args,
                    const playground::CheckProgress& progress) {
    const Json request{{"name", name}, {"args", args}};
    Json answer = Json::parse(core_.call(request.dump(), progress));
    if (!progress) record(number_, request, answer);
    return answer;
}

std::string AskedCore::call(const std::string& request) {
    return core_.call(request);
}

Json ask(AskedCore& core, const std::string& name, const Json& args,
         const playground::CheckProgress& progress) {
    return core.ask(name, args, progress);
}

Json ask(const std::string& name, const Json& args) {
    AskedCore core;
    return core.ask(name, args);
}

std::string chart_text(const std::string& name) {
    return example_text(name + ".grafcet");
}

}  // namespace grafwire::testing
