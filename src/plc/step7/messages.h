#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::plc_step7 {

inline constexpr Message<> integer_too_wide{
    "an integer needs more than the 32 bits of DINT, the widest of an S7-300 or S7-400; make the "
    "range of the counter smaller",
    "un entier demande plus que les 32 bits de DINT, le plus grand d'un S7-300 ou S7-400 ; "
    "réduisez la plage du compteur"};
inline constexpr Message<> too_many_labels{
    "the program needs more than 999 jump labels; divide the GRAFCET",
    "le programme demande plus de 999 repères de saut ; partagez le GRAFCET"};
inline constexpr Message<Localized> no_timer_holds{
    "no timer of an S7-300 or S7-400 holds {}: S5 timers and the IEC timers count whole "
    "milliseconds, up to 24 days; choose another time",
    "aucune temporisation d'un S7-300 ou S7-400 ne contient {} : les temporisations S5 et CEI "
    "comptent des millisecondes entières, jusqu'à 24 jours ; choisissez une autre durée"};
inline constexpr Message<std::uint32_t, std::uint32_t> too_much_bit_memory{
    "the program needs bit memory up to MB {}, and no S7-300 or S7-400 has more than MB {}; divide "
    "the GRAFCET",
    "le programme demande des mémentos jusqu'à MB {}, et aucun S7-300 ou S7-400 ne va au-delà de "
    "MB {} ; partagez le GRAFCET"};
inline constexpr Message<std::string_view> input_elsewhere{
    "'{}' is to be a bit of the inputs, E0.0 and so on",
    "« {} » doit être un bit des entrées, E0.0 et suivants"};
inline constexpr Message<std::string_view> output_elsewhere{
    "'{}' is to be a bit of the outputs, A0.0 and so on",
    "« {} » doit être un bit des sorties, A0.0 et suivants"};

// The head of a source file.
inline constexpr Message<> what_it_is{
    "A GRAFCET (IEC 60848) in Statement List for STEP 7 (S7-300, S7-400), by the table\n"
    "method. FC 1 is one scan; OB 1 calls it; OB 100 has the first scan after a restart\n"
    "begin in the initial situation.",
    "GRAFCET (CEI 60848) en liste d'instructions (LIST) pour STEP 7 (S7-300, S7-400), par\n"
    "la méthode des tables. FC 1 est une scrutation ; OB 1 l'appelle ; après un redémarrage,\n"
    "OB 100 fait partir la première scrutation de la situation initiale."};
inline constexpr Message<> modes{
    "Init: initial situation; AUdur: no step active; AUdoux: outputs off, the situation\n"
    "stays.",
    "Init : situation initiale ; AUdur : aucune étape active ; AUdoux : sorties à 0, la\n"
    "situation est conservée."};
inline constexpr Message<std::uint32_t, std::uint32_t> memory_used{
    "Uses MB {} to MB {}.", "Occupe les mémentos MB {} à MB {}."};
inline constexpr Message<> assignment{"Assignment:", "Affectation :"};

// Blocks.
inline constexpr Message<> one_scan{"one scan", "une scrutation"};
inline constexpr Message<> every_cycle{"every cycle", "à chaque cycle"};
inline constexpr Message<> restart{"restart", "redémarrage"};

// Instructions.
inline constexpr Message<> not_first_scan{"not the first scan after a restart",
                                          "pas la première scrutation après un redémarrage"};
inline constexpr Message<> everything_is_0{"everything is 0, no timer runs",
                                           "tout à 0, aucune temporisation en cours"};
inline constexpr Message<> next_scan_is_first{"the next scan is the first",
                                              "la prochaine scrutation est la première"};
inline constexpr Message<> timer_stopped{"stopped", "arrêtée"};

// What operands are.
inline constexpr Message<std::string> edge_memory{"memory of {}", "mémoire de {}"};
inline constexpr Message<std::string> held_bit{"held {}", "valeur gardée {}"};
inline constexpr Message<std::uint32_t> held_integer{"held value {}", "entier gardé {}"};
inline constexpr Message<> auxiliary{"auxiliary", "auxiliaire"};

}  // namespace grafwire::messages::plc_step7
