#include "plc/compile.h"

#include <stdexcept>

#include "support/run_program.h"

namespace grafwire::testing {

void compile(const std::vector<std::string>& command) {
    const Ran ran = run_program(command);
    if (ran.status != 0 || !ran.err.empty()) {
        throw std::runtime_error("compiler: " + ran.err + ran.out);
    }
}

std::vector<std::string> run_on(const std::vector<std::string>& command,
                                const std::vector<std::string>& scans) {
    std::vector<std::string> traces;
    for (const std::string& text : scans) {
        Ran ran = run_program(command, text);
        if (ran.status != 0 || !ran.err.empty()) throw std::runtime_error("program: " + ran.err);
        traces.push_back(std::move(ran.out));
    }
    return traces;
}

}  // namespace grafwire::testing
