#pragma once

#include <cstdint>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on S7-200 listings are about.
namespace code {
inline constexpr Code unknown_instruction{"unknown-instruction"};
inline constexpr Code bad_network{"bad-network"};
inline constexpr Code bad_control_flow{"bad-control-flow"};
inline constexpr Code bad_stack{"bad-stack"};
inline constexpr Code bad_offset{"bad-offset"};
inline constexpr Code program_too_long{"program-too-long"};
inline constexpr Code read_leniently{"read-leniently"};
}  // namespace code

namespace messages::s7 {

// Lines and words.
inline constexpr Message<> unterminated_name{
    "the quoted name is not ended on its line",
    "le nom entre guillemets droits ne se termine pas sur sa ligne"};
inline constexpr Message<> continued_comment{
    "a line is read as the continuation of the comment before it",
    "une ligne est lue comme la suite du commentaire qui la précède"};
inline constexpr CountedMessage<Localized> and_elsewhere{
    {"{1}, here and in {0} more place", "{1}, ici et à {0} autre endroit"},
    {"{1}, here and in {0} more places", "{1}, ici et à {0} autres endroits"}};
inline constexpr Message<> only_comment_after_network{
    "nothing may follow the number of a network but a comment (//)",
    "seul un commentaire (//) peut suivre le numéro d'un réseau"};
inline constexpr CountedMessage<std::string_view> operands_missing{
    {"{1} takes {0} operand, and there are none", "{1} demande {0} opérande, il n'y en a aucun"},
    {"{1} takes {0} operands, and there are none", "{1} demande {0} opérandes, il n'y en a aucun"}};
inline constexpr CountedMessage<std::string_view, std::size_t> some_operands_missing{
    {"{1} takes {2} operands, and there is {0}", "{1} demande {2} opérandes, il n'y en a que {0}"},
    {"{1} takes {2} operands, and there are {0}",
     "{1} demande {2} opérandes, il n'y en a que {0}"}};
inline constexpr CountedMessage<std::string_view, std::string_view> one_operand_too_many{
    {"{1} takes {0} operand: '{2}' is one too many",
     "{1} demande {0} opérande : « {2} » est de trop"},
    {"{1} takes {0} operands: '{2}' is one too many",
     "{1} demande {0} opérandes : « {2} » est de trop"}};
inline constexpr Message<std::string_view> read_as_k1{"'{}' is read as 'K1'",
                                                      "« {} » est lu « K1 »"};
inline constexpr Message<std::uint32_t, std::uint32_t> offset_deviates{
    "offset {}: the instruction before it ends at {}",
    "adresse relative {} : l'instruction précédente se termine à {}"};

inline constexpr Message<std::string_view> unknown_instruction{"unknown instruction '{}'",
                                                               "instruction « {} » inconnue"};
inline constexpr Message<std::string_view, std::string_view> unknown_instruction_near{
    "unknown instruction '{}'; did you mean '{}'?",
    "instruction « {} » inconnue ; vouliez-vous dire « {} » ?"};
inline constexpr Message<std::string_view> malformed_address{
    "'{}' is no address: bits are written as V20.1 with bits 0 … 7, bytes, words and double words "
    "as VB20, VW20 and VD20",
    "« {} » n'est pas une adresse : un bit s'écrit comme V20.1, le bit allant de 0 à 7, un octet, "
    "un mot et un double mot comme VB20, VW20 et VD20"};
inline constexpr Message<std::string_view> no_operand_without_table{
    "'{}' is no address, no constant and no name with an address; names are given addresses by a "
    "table of assignment (--io)",
    "« {} » n'est ni une adresse, ni une constante, ni un nom qui a une adresse ; une table "
    "d'affectation (--io) donne des adresses aux noms"};
inline constexpr Message<std::string_view> no_operand{
    "'{}' is no address, no constant and no name with an address",
    "« {} » n'est ni une adresse, ni une constante, ni un nom qui a une adresse"};
inline constexpr Message<std::string_view, std::string_view> no_operand_near{
    "'{}' is no address, no constant and no name with an address; did you mean '{}'?",
    "« {} » n'est ni une adresse, ni une constante, ni un nom qui a une adresse ; vouliez-vous "
    "dire « {} » ?"};

// The order of networks and offsets.
inline constexpr Message<> offset_missing{
    "the offsets of the listing do not ascend, and this instruction has none: write all of them, "
    "or none",
    "les adresses relatives de la liste ne sont pas croissantes, et cette instruction n'en a pas : "
    "écrivez-les toutes, ou aucune"};
inline constexpr Message<std::uint32_t> offset_repeated{
    "another instruction has the offset {} too",
    "une autre instruction a elle aussi l'adresse relative {}"};
inline constexpr Message<std::uint32_t> network_lost{
    "the offsets do not tell where network {} begins",
    "les adresses relatives ne disent pas où commence le réseau {}"};
inline constexpr Message<> put_in_order{
    "the offsets do not ascend: from here on the instructions are put in their order",
    "les adresses relatives ne sont pas croissantes : à partir d'ici, les instructions sont "
    "rangées dans leur ordre"};
inline constexpr Message<std::uint32_t, std::uint32_t> networks_descend{
    "network {} comes after network {}: their numbers do not ascend",
    "le réseau {} vient après le réseau {} : leurs numéros ne sont pas croissants"};
inline constexpr Message<> outside_a_network{
    "an instruction outside a network: begin it with a line NETWORK 1",
    "une instruction est hors de tout réseau : mettez avant elle une ligne NETWORK 1"};

// Operands.
inline constexpr Message<> byte_or_constant{"a byte such as VB100 or a constant",
                                            "un octet tel que VB100 ou une constante"};
inline constexpr Message<> word_or_constant{"a word such as VW100 or a constant",
                                            "un mot tel que VW100 ou une constante"};
inline constexpr Message<> dword_or_constant{"a double word such as VD100 or a constant",
                                             "un double mot tel que VD100 ou une constante"};
inline constexpr Message<> writable_byte{"a byte such as VB100 that can be written",
                                         "un octet accessible en écriture, tel que VB100"};
inline constexpr Message<> writable_word{"a word such as VW100 that can be written",
                                         "un mot accessible en écriture, tel que VW100"};
inline constexpr Message<> writable_dword{"a double word such as VD100 that can be written",
                                          "un double mot accessible en écriture, tel que VD100"};
inline constexpr Message<> any_bit{"a bit such as E0.4, V20.1 or T37",
                                   "un bit tel que E0.4, V20.1 ou T37"};
inline constexpr Message<> writable_bit{"a bit that can be written, such as A0.0 or V20.1",
                                        "un bit accessible en écriture, tel que A0.0 ou V20.1"};
inline constexpr Message<> resettable_bit{
    "a bit that can be written, a timer or a counter",
    "un bit accessible en écriture, une temporisation ou un compteur"};
inline constexpr Message<> constant_or_word{"a constant or a word", "une constante ou un mot"};
inline constexpr Message<> timer{"a timer such as T37", "une temporisation telle que T37"};
inline constexpr Message<> counter{"a counter such as Z0", "un compteur tel que Z0"};
inline constexpr Message<> count_constant{"a constant, the number of bits, bytes or words",
                                          "une constante, le nombre de bits, d'octets ou de mots"};
inline constexpr Message<> subroutine_number{"the number of a subroutine, such as K10",
                                             "le numéro d'un sous-programme, tel que K10"};
inline constexpr Message<> label_number{"the number of a label, such as K10",
                                        "le numéro d'un repère, tel que K10"};
inline constexpr Message<> constant{"a constant", "une constante"};
inline constexpr Message<> nothing{"nothing", "rien"};

inline constexpr Message<> bound_of_count{"a count", "un nombre"};
inline constexpr Message<> bound_of_preset{"a preset", "une présélection"};
inline constexpr Message<> bound_of_subroutine{"the number of a subroutine",
                                               "le numéro d'un sous-programme"};
inline constexpr Message<> bound_of_label{"the number of a label", "le numéro d'un repère"};
inline constexpr Message<> bound_of_number{"the number", "le numéro"};
inline constexpr Message<> bound_of_byte{"a byte", "un octet"};
inline constexpr Message<> bound_of_word{"a word", "un mot"};
inline constexpr Message<> bound_of_dword{"a double word", "un double mot"};

inline constexpr Message<> not_in_the_set{"the instruction is not in the set",
                                          "l'instruction ne fait pas partie du jeu d'instructions"};
inline constexpr Message<std::size_t, std::string_view, std::string_view, Localized> wrong_operand{
    "operand {} of {} is {}, and {} is wanted", "l'opérande {} de {} est {}, alors qu'il faut {}"};
inline constexpr Message<std::string_view, Localized, std::int64_t, std::int64_t, std::string_view>
    out_of_bounds{"{}: {} is between {} and {} (the {})", "{} : {} va de {} à {} (pour la {})"};
/// Of more than one.
inline constexpr Message<std::string_view, std::string_view, std::int64_t> beyond_bytes{
    "{}: the {} has {} bytes of this area", "{} : dans cette zone, la {} a {} octets"};
/// Of more than one.
inline constexpr Message<std::string_view, std::string_view, std::int64_t> beyond_places{
    "{}: the {} has {} places of this area", "{} : dans cette zone, la {} a {} emplacements"};
inline constexpr CountedMessage<std::string_view, std::string_view, std::int64_t> run_beyond_bytes{
    {"{1} and the {0} behind it: the {2} has {3} bytes of this area",
     "{1} et le suivant : dans cette zone, la {2} a {3} octets"},
    {"{1} and the {0} behind it: the {2} has {3} bytes of this area",
     "{1} et les {0} suivants : dans cette zone, la {2} a {3} octets"}};
inline constexpr CountedMessage<std::string_view, std::string_view, std::int64_t> run_beyond_places{
    {"{1} and the {0} behind it: the {2} has {3} places of this area",
     "{1} et le suivant : dans cette zone, la {2} a {3} emplacements"},
    {"{1} and the {0} behind it: the {2} has {3} places of this area",
     "{1} et les {0} suivants : dans cette zone, la {2} a {3} emplacements"}};
inline constexpr Message<std::int32_t, std::string_view, std::string_view, int, int> wrong_timer{
    "T{} is a timer for {}: {} takes T{} … T{}",
    "T{} est une temporisation pour {} : {} demande T{} … T{}"};
inline constexpr Message<std::int32_t, std::string_view, std::string_view, int, int, int, int>
    wrong_timer_of_214{"T{} is a timer for {}: {} takes T{} … T{} and T{} … T{}",
                       "T{} est une temporisation pour {} : {} demande T{} … T{} ou T{} … T{}"};

// The stack, and the flow of control.
inline constexpr CountedMessage<std::string_view, std::size_t> stack_too_low{
    {"{1} works on {0} level of the stack, and the network has loaded {2}",
     "{1} porte sur {0} niveau de la pile, et le réseau en a chargé {2}"},
    {"{1} works on {0} levels of the stack, and the network has loaded {2}",
     "{1} porte sur {0} niveaux de la pile, et le réseau en a chargé {2}"}};
/// Of more than one.
inline constexpr Message<std::string_view, std::size_t> pushed_out{
    "{} comes too late: the stack has {} levels, and what it needs has been pushed out by later "
    "loads",
    "{} vient trop tard : la pile a {} niveaux, et les chargements suivants en ont fait sortir ce "
    "qu'il faut à cette instruction"};
inline constexpr Message<std::size_t, std::size_t> calls_too_deep{
    "subroutines are called {} deep: {} is the limit",
    "les appels de sous-programmes s'imbriquent sur {} niveaux : la limite est {}"};
inline constexpr Message<> main_program{"the main program", "le programme principal"};
inline constexpr Message<std::int32_t> subroutine{"subroutine {}", "le sous-programme {}"};
inline constexpr Message<std::string_view, Localized> foreign_instruction{
    "{} does not belong into {}", "{} n'a pas sa place dans {}"};
inline constexpr Message<Localized, std::string_view> ends_without{"{} ends here without {}",
                                                                   "{} se termine ici sans {}"};
inline constexpr Message<Localized> unreachable{
    "nothing can reach this instruction: {} has ended",
    "rien ne mène à cette instruction : {} est terminé"};
inline constexpr Message<> here{"here", "ici"};
inline constexpr Message<std::int32_t> subroutine_twice{"subroutine {} is there already",
                                                        "le sous-programme {} existe déjà"};
inline constexpr Message<std::int32_t> label_twice{"label {} is there already",
                                                   "le repère {} existe déjà"};
inline constexpr Message<std::int32_t> no_subroutine{
    "there is no subroutine {0}: SBR K{0}", "il n'y a pas de sous-programme {0} : SBR K{0}"};
inline constexpr Message<std::int32_t, Localized> label_elsewhere{
    "label {} is in {}: a jump stays where it is",
    "le repère {} est dans {} : un saut ne quitte pas le programme où il se trouve"};
inline constexpr Message<> label{"label", "le repère"};
inline constexpr Message<std::int32_t> no_label{"there is no label {0}: LBL K{0}",
                                                "il n'y a pas de repère {0} : LBL K{0}"};
inline constexpr Message<std::int32_t> calls_itself{"subroutine {} would call itself",
                                                    "le sous-programme {} s'appellerait lui-même"};

inline constexpr Message<> no_instruction{"the listing holds no instruction",
                                          "la liste d'instructions ne contient aucune instruction"};
/// Of more than one.
inline constexpr Message<std::uint32_t, std::string_view, std::uint32_t> program_too_long{
    "the program takes {} bytes, and the {} holds {}",
    "le programme occupe {} octets, et la {} n'en a que {}"};

}  // namespace messages::s7

}  // namespace grafwire
