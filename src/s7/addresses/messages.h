#pragma once

#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on operands and tables of assignment are about.
namespace code {
inline constexpr Code bad_operand{"bad-operand"};
inline constexpr Code address_out_of_range{"address-out-of-range"};
inline constexpr Code bad_address{"bad-address"};
inline constexpr Code unassigned_name{"unassigned-name"};  ///< a warning
}  // namespace code

namespace messages::s7_addresses {

inline constexpr Message<> name_expected_after_address{
    "expected '=' and a name after the address, as in 'E0.0 = v0'",
    "« = » et un nom sont attendus après l'adresse, comme dans « E0.0 = v0 »"};
inline constexpr Message<> only_comment_after_name{"nothing may follow the name but a comment (#)",
                                                   "seul un commentaire (#) peut suivre le nom"};
inline constexpr Message<std::string_view> not_an_address{
    "'{}' is not an address: write one such as E0.4, A0.0, V21.0 or VW100 (bits are 0 … 7)",
    "« {} » n'est pas une adresse : écrivez par exemple E0.4, A0.0, V21.0 ou VW100 (les bits vont "
    "de 0 à 7)"};
inline constexpr Message<> unterminated_name{"the name is not ended on its line",
                                             "le nom ne se termine pas sur sa ligne"};
inline constexpr Message<> name_expected{
    "expected a name (quoted, if it holds other characters than letters, digits and '_'), or a "
    "transition's label in parentheses",
    "un nom est attendu (entre guillemets droits s'il contient d'autres caractères que des "
    "lettres, des chiffres et « _ »), ou le repère d'une transition entre parenthèses"};
inline constexpr Message<std::string_view> has_an_address{"'{}' has an address already",
                                                          "« {} » a déjà une adresse"};
inline constexpr Message<> here{"it is here", "elle est ici"};
inline constexpr Message<std::string_view> address_taken{
    "{} is taken, wholly or in part", "{} est déjà pris, en totalité ou en partie"};
inline constexpr Message<> by_this_address{"by this address", "par cette adresse"};

}  // namespace messages::s7_addresses

}  // namespace grafwire
