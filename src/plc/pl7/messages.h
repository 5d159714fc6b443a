#pragma once

#include <cstddef>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::plc_pl7 {

inline constexpr Message<> integer_too_wide{
    "an integer needs more than the 16 bits of a word of PL7-2; make the range of the counter "
    "smaller",
    "un entier demande plus que les 16 bits d'un mot de PL7-2 ; réduisez la plage du compteur"};
inline constexpr Message<std::string_view> no_timer_holds{
    "no timer of PL7-2 holds {}: it counts up to 9999 times 10 ms, 100 ms, 1 s or 1 min; choose "
    "another time",
    "aucun temporisateur de PL7-2 ne contient {} : il compte jusqu'à 9999 fois 10 ms, 100 ms, "
    "1 s ou 1 min ; choisissez une autre durée"};

// What the program needs, and what there is of it.
inline constexpr Message<std::size_t, std::size_t> too_many_inputs{
    "the program needs {} inputs, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} entrées, et PL7-2 en a {} ; partagez le GRAFCET"};
inline constexpr Message<std::size_t, std::size_t> too_many_outputs{
    "the program needs {} outputs, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} sorties, et PL7-2 en a {} ; partagez le GRAFCET"};
inline constexpr Message<std::size_t, std::size_t> too_many_steps{
    "the program needs {} steps, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} étapes, et PL7-2 en a {} ; partagez le GRAFCET"};
inline constexpr Message<std::size_t, std::size_t> too_many_bits{
    "the program needs {} internal bits, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} bits internes, et PL7-2 en a {} ; partagez le GRAFCET"};
inline constexpr Message<std::size_t, std::size_t> too_many_words{
    "the program needs {} words, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} mots, et PL7-2 en a {} ; partagez le GRAFCET"};
inline constexpr Message<std::size_t, std::size_t> too_many_timers{
    "the program needs {} timers, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {} temporisateurs, et PL7-2 en a {} ; partagez le GRAFCET"};

}  // namespace grafwire::messages::plc_pl7
