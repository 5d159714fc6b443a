#pragma once

#include <cstddef>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::s7_machine {

inline constexpr Message<> an_input_bit{"an input bit such as E0.4",
                                        "un bit d'entrée tel que E0.4"};
inline constexpr Message<> a_bit{"a bit such as V20.1", "un bit tel que V20.1"};
inline constexpr Message<> a_word{"a word such as VW100", "un mot tel que VW100"};
inline constexpr Message<std::string_view, std::string_view, Localized> wrong_address{
    "{} is the address of '{}', which needs {}", "{} est l'adresse de « {} », auquel il faut {}"};

inline constexpr Message<std::string_view> not_in_the_grafcet{"the GRAFCET has no '{}'",
                                                              "le GRAFCET n'a pas de « {} »"};
inline constexpr Message<std::string_view, std::string_view> not_in_the_grafcet_near{
    "the GRAFCET has no '{}'; did you mean '{}'?",
    "le GRAFCET n'a pas de « {} » ; vouliez-vous dire « {} » ?"};

inline constexpr Message<std::string_view> input_without_address{
    "input '{}' of the GRAFCET has no address", "l'entrée « {} » du GRAFCET n'a pas d'adresse"};
inline constexpr Message<std::string_view> step_without_address{
    "step '{}' of the GRAFCET has no address", "l'étape « {} » du GRAFCET n'a pas d'adresse"};
inline constexpr Message<std::string_view> output_without_address{
    "output '{}' of the GRAFCET has no address", "la sortie « {} » du GRAFCET n'a pas d'adresse"};

/// Of more than one.
inline constexpr Message<std::size_t> scan_without_end{
    "the scan does not come to an end: more than {} instructions",
    "la scrutation ne se termine pas : plus de {} instructions"};

}  // namespace grafwire::messages::s7_machine
