#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "ladder/ladder.h"
#include "plcopen/source.h"

namespace grafwire::plcopen {

/// The variables of a program that is read, by name; names are compared without regard to case.
class LadderVariables {
  public:
    LadderVariables(const Source& source, ladder::Ladder& ladder)
        : source_(source), ladder_(ladder) {}

    /// The interface of a pou, then what the project declares for all programs.
    void read(pugi::xml_node project, pugi::xml_node pou);

    /// What `name` or `instance.Q` stands for, of a wanted type; what is wrong with it is reported
    /// at `where`.
    std::optional<ladder::VariableId> bit(std::string_view name, pugi::xml_node where) const;
    std::optional<ladder::VariableId> integer(std::string_view name, pugi::xml_node where) const;
    std::optional<ladder::VariableId> instance(std::string_view name, ladder::BlockType type,
                                               pugi::xml_node where) const;
    /// A literal or a variable; an instance's CV where a number is wanted.
    std::optional<ladder::Operand> operand(std::string_view text, ladder::Operand::Kind wanted,
                                           bool of_bits, pugi::xml_node where) const;
    bool is_integer(std::string_view name) const;
    /// A variable of the reader's own.
    ladder::VariableId add_hidden(std::string name, ladder::Type type);

  private:
    void read_list(pugi::xml_node list, ladder::Role role);
    void read_variable(pugi::xml_node variable, ladder::Role role);
    std::optional<ladder::VariableId> find(std::string_view name, pugi::xml_node where) const;

    const Source& source_;
    ladder::Ladder& ladder_;
    std::map<std::string, ladder::VariableId> ids_;  ///< by name in capitals
    std::map<std::string, Time> times_;              ///< TIME variables that are constants
    std::map<std::string, std::string> foreign_;     ///< names of other types, with their type
};

}  // namespace grafwire::plcopen
