#pragma once

#include <cstddef>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::plc_computer {

inline constexpr Message<std::string_view> sum_too_wide{
    "this sum can go beyond the 64 bits of integers in {}; give its counters smaller ranges, or "
    "write --to python",
    "cette somme peut dépasser les 64 bits des entiers en {} ; donnez à ses compteurs des plages "
    "plus petites, ou écrivez --to python"};
inline constexpr Message<std::size_t, std::size_t, std::size_t> too_many_steps{
    "this is step {} of {}, and a set of Free Pascal holds {}; write --to c or --to python",
    "c'est l'étape {} sur {}, et un ensemble de Free Pascal en contient {} ; écrivez --to c ou "
    "--to python"};
inline constexpr Message<std::size_t, std::size_t> too_many_pins{
    "{} inputs and outputs need a pin each, and the largest board, an Arduino Mega 2560, has {}; "
    "write --to c and connect them by yourself",
    "{} entrées et sorties demandent une broche chacune, et la plus grande carte, une Arduino "
    "Mega 2560, en a {} ; écrivez --to c et raccordez-les vous-même"};
inline constexpr Message<std::size_t, std::size_t> too_many_pins_with_modes{
    "{} inputs and outputs need a pin each, and the largest board, an Arduino Mega 2560, has {}; "
    "write --to c and connect them by yourself, or --modes off to save three",
    "{} entrées et sorties demandent une broche chacune, et la plus grande carte, une Arduino "
    "Mega 2560, en a {} ; écrivez --to c et raccordez-les vous-même, ou --modes off pour en "
    "économiser trois"};

}  // namespace grafwire::messages::plc_computer
