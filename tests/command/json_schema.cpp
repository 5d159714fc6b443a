#include "command/json_schema.h"

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

const char* const validator = R"(
import json, sys
from jsonschema import Draft202012Validator
with open(sys.argv[1]) as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
for error in Draft202012Validator(schema).iter_errors(json.load(sys.stdin)):
    print("/".join(map(str, error.absolute_path)) + ": " + error.message)
)";

}  // namespace

std::string schema_problems(const std::string& json) {
    return schema_problems(json, "src/check/report.schema.json");
}

std::string schema_problems(const std::string& json, const std::string& schema) {
    // The Python of the system: its packages are those that tools/test installs.
    const Ran ran = run_program(
        {"/usr/bin/python3", "-c", validator, std::string(GRAFWIRE_ROOT) + "/" + schema}, json,
        {"LC_ALL=C.UTF-8"});
    INFO(ran.err);
    CHECK(ran.status == 0);
    return ran.out;
}

}  // namespace grafwire::testing
