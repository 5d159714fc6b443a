#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "text/time.h"

namespace grafwire::testing {

/// A sequential function chart as a PLCopen project has it, with no knowledge of what wrote it.
/// Names are in lower case: case does not matter in IEC 61131-3.
struct SfcPou {
    struct Variable {
        std::string name;
        std::string type;
        std::int64_t initial = 0;
        bool is_input = false;
    };
    struct Step {
        std::string name;
        bool initial = false;
    };
    struct Transition {
        std::string condition;  ///< in Structured Text
        int x = 0;              ///< how far to the right it stands
        std::vector<std::size_t> preceding;
        std::vector<std::size_t> following;
    };
    struct Action {
        std::size_t step = 0;
        std::string qualifier;
        Time duration = 0;
        std::string reference;  ///< a BOOL variable; empty: statements
        std::string statements;
    };
    std::vector<Variable> variables;
    std::vector<Step> steps;
    std::vector<Transition> transitions;
    std::vector<Action> actions;  ///< in the order of the file
    std::vector<std::string> comments;
};

std::string lower_case(std::string text);

/// Reads the program of a name; throws a PlcError where it is none, or not understood.
SfcPou read_sfc(const std::string& xml, const std::string& name);

}  // namespace grafwire::testing
