#pragma once

#include <cstdint>
#include <string>

#include "text/message.h"

namespace grafwire {

/// The words around every diagnostic, and what readers of all languages say.
namespace messages::text {

inline constexpr Message<std::string> quoted_name{"'{}'", "« {} »"};

inline constexpr Message<std::string> error{"error: {}", "erreur : {}"};
inline constexpr Message<std::string> warning{"warning: {}", "avertissement : {}"};
inline constexpr Message<std::string> note{"note: {}", "note : {}"};

inline constexpr CountedMessage<> more_errors{
    {"{} more error not shown", "{} erreur de plus n'est pas affichée"},
    {"{} more errors not shown", "{} erreurs de plus ne sont pas affichées"}};
inline constexpr CountedMessage<> more_warnings{
    {"{} more warning not shown", "{} avertissement de plus n'est pas affiché"},
    {"{} more warnings not shown", "{} avertissements de plus ne sont pas affichés"}};

inline constexpr Message<Localized, Localized> did_you_mean{"{}; did you mean {}?",
                                                            "{} ; vouliez-vous dire {} ?"};
inline constexpr Message<Localized, std::uint32_t> control_in_name{
    "{} holds the control character U+{:04X}, which no name or title may hold; remove it",
    "{} contient le caractère de commande U+{:04X}, interdit dans un nom ou un titre ; "
    "supprimez-le"};
inline constexpr Message<std::uint32_t> not_utf8{
    "the byte 0x{:02X} is not UTF-8 here; save the file in the encoding UTF-8",
    "l'octet 0x{:02X} n'est pas de l'UTF-8 à cet endroit ; enregistrez le fichier en UTF-8"};

}  // namespace messages::text

}  // namespace grafwire
