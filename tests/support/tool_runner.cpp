#include "support/tool_runner.h"

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace grafwire::testing {

ToolRunner::ToolRunner() {
    std::string pattern = (std::filesystem::temp_directory_path() / "grafwire-XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    directory_ = pattern;
}

ToolRunner::~ToolRunner() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
}

void ToolRunner::write(const std::string& file, std::string_view text) {
    std::ofstream out(directory_ + "/" + file, std::ios::binary);
    out << text;
    REQUIRE(out.good());
}

std::string ToolRunner::read(const std::string& file) const {
    std::ifstream in(directory_ + "/" + file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

ToolRunner::Result ToolRunner::run(const std::string& command) const {
    const std::string line = "cd '" + directory_ + "' && ( ulimit -c 0; timeout 60 sh -c \"" +
                             command + "\" ) > output.txt 2>&1 < /dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("output.txt")};
}

}  // namespace grafwire::testing
