#pragma once

#include <string_view>

#include "text/message.h"

/// What manual pages say besides what --help says.
namespace grafwire::messages::describe {

// Headings.

inline constexpr Message<> manual{"User Commands", "Commandes"};
inline constexpr Message<> name{"NAME", "NOM"};
inline constexpr Message<> synopsis{"SYNOPSIS", "SYNOPSIS"};
inline constexpr Message<> commands{"COMMANDS", "COMMANDES"};
inline constexpr Message<> arguments{"ARGUMENTS", "ARGUMENTS"};
inline constexpr Message<> options{"OPTIONS", "OPTIONS"};
inline constexpr Message<> exit_status{"EXIT STATUS", "CODE DE RETOUR"};
inline constexpr Message<> example{"EXAMPLE", "EXEMPLE"};
inline constexpr Message<> see_also{"SEE ALSO", "VOIR AUSSI"};

// Parts of a synopsis.

inline constexpr Message<> command{"COMMAND", "COMMANDE"};
inline constexpr Message<> option{"OPTION", "OPTION"};

// Sentences.

inline constexpr Message<std::string_view> one_of{"One of: {}.", "Au choix : {}."};
inline constexpr Message<std::string_view> by_default{"Default: {}.", "Par défaut : {}."};
inline constexpr Message<> required{"It must be given.", "À donner obligatoirement."};
inline constexpr Message<> repeatable{"May be given several times.",
                                      "Peut être donné plusieurs fois."};

}  // namespace grafwire::messages::describe
