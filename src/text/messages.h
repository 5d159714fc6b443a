#pragma once

#include "text/message.h"

namespace grafwire {

/// The words around every diagnostic.
namespace messages::text {

inline constexpr Message<> error{"error", "erreur"};
inline constexpr Message<> warning{"warning", "avertissement"};
inline constexpr Message<> note{"note", "note"};

inline constexpr CountedMessage<> more_errors{
    {"{} more error not shown", "{} erreur de plus n'est pas affichée"},
    {"{} more errors not shown", "{} erreurs de plus ne sont pas affichées"}};
inline constexpr CountedMessage<> more_warnings{
    {"{} more warning not shown", "{} avertissement de plus n'est pas affiché"},
    {"{} more warnings not shown", "{} avertissements de plus ne sont pas affichés"}};

}  // namespace messages::text

}  // namespace grafwire
