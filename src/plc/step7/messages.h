#pragma once

#include <cstdint>
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
inline constexpr Message<std::string_view> no_timer_holds{
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

}  // namespace grafwire::messages::plc_step7
