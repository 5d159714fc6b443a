#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::s7_generate {

// What the tables of the method hold.
inline constexpr Message<std::size_t, std::uint32_t> too_many_steps{
    "the chart has {} steps, and the tables of the method hold {}: wide tables (--tables wide) "
    "hold them all",
    "le GRAFCET a {} étapes, et les tables de la méthode en contiennent {} : les tables étendues "
    "(--tables wide) les contiennent toutes"};
inline constexpr Message<std::size_t, std::uint32_t> too_many_transitions{
    "the chart has {} transitions, and the tables of the method hold {}: wide tables (--tables "
    "wide) hold them all",
    "le GRAFCET a {} transitions, et les tables de la méthode en contiennent {} : les tables "
    "étendues (--tables wide) les contiennent toutes"};
inline constexpr Message<std::size_t, std::uint32_t> too_many_graphs{
    "the chart has {} graphs, and the tables of the method hold {}: wide tables (--tables wide) "
    "hold them all",
    "le GRAFCET a {} graphes partiels, et les tables de la méthode en contiennent {} : les tables "
    "étendues (--tables wide) les contiennent tous"};

// Assignments.
inline constexpr Message<std::string_view> not_in_the_chart{"the chart has no '{}'",
                                                            "le GRAFCET n'a pas de « {} »"};
inline constexpr Message<std::string_view, std::string_view> not_in_the_chart_near{
    "the chart has no '{}'; did you mean '{}'?",
    "le GRAFCET n'a pas de « {} » ; vouliez-vous dire « {} » ?"};
inline constexpr Message<std::string_view, std::string_view, Localized> wrong_address{
    "{} cannot be the address of '{}': {}", "{} ne peut pas être l'adresse de « {} » : {}"};
inline constexpr Message<> bit_wanted{"a bit is wanted, like E0.0 or V6.0",
                                      "il faut un bit, tel que E0.0 ou V6.0"};
inline constexpr Message<> areas_of_inputs{"an input is a bit of E, M, V or SM",
                                           "une entrée est un bit de E, M, V ou SM"};
inline constexpr Message<> areas_of_outputs{"what is written is a bit of A, M or V",
                                            "ce qui est écrit est un bit de A, M ou V"};
inline constexpr Message<> used_by_the_method{"the method uses it itself",
                                              "la méthode l'utilise elle-même"};
inline constexpr Message<> areas_of_counters{
    "a counter is a word or double word of V or M, like VW100",
    "un compteur est un mot ou un double mot de V ou M, tel que VW100"};
inline constexpr Message<> wide_step{
    "in wide tables the place of a step follows from the chart; leave it out",
    "dans les tables étendues, la place d'une étape se déduit du GRAFCET ; supprimez cette ligne"};
inline constexpr Message<> wide_transition{
    "in wide tables the place of a transition follows from the chart; leave it out",
    "dans les tables étendues, la place d'une transition se déduit du GRAFCET ; supprimez cette "
    "ligne"};
inline constexpr Message<> wide_graph{
    "in wide tables the place of a graph follows from the chart; leave it out",
    "dans les tables étendues, la place d'un graphe partiel se déduit du GRAFCET ; supprimez cette "
    "ligne"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_step{
    "a step is a bit of the table Ts, V{}.0 … V{}.7",
    "une étape est un bit de la table Ts, V{}.0 … V{}.7"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_transition{
    "a transition is a bit of the table Tt, V{}.0 … V{}.7",
    "une transition est un bit de la table Tt, V{}.0 … V{}.7"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_graph{
    "a graph is a bit of the table Tfig, V{}.0 … V{}.7",
    "un graphe partiel est un bit de la table Tfig, V{}.0 … V{}.7"};

// Timers.
inline constexpr Message<std::string_view, std::string_view> uncountable{
    "no timer of an S7-200 counts {} of '{}': the timers count up to 32767 times 1 ms, 10 ms or "
    "100 ms; choose a delay that is a multiple of one of these, or divide a long one between two "
    "steps",
    "aucune temporisation d'un S7-200 ne compte {} de « {} » : les temporisations comptent "
    "jusqu'à 32767 fois 1 ms, 10 ms ou 100 ms ; choisissez un retard qui en soit un multiple, ou "
    "partagez un long retard entre deux étapes"};
inline constexpr Message<std::string_view> or_finer{"{} or finer", "{} ou moins"};
inline constexpr Message<Localized, std::string_view, std::string_view, std::string_view>
    no_timer_left{
        "no timer of {} is left on a {} for {} of '{}'; round delays to 100 ms, of which there "
        "are most timers",
        "il ne reste aucune temporisation de {} dans une {} pour {} de « {} » ; arrondissez les "
        "retards à 100 ms, base de la plupart des temporisations"};
inline constexpr Message<Localized, std::string_view, std::string_view, std::string_view>
    no_timer_left_on_212{
        "no timer of {} is left on a {} for {} of '{}'; round delays to 100 ms, of which there "
        "are most timers, or take a CPU 214, which has twice as many",
        "il ne reste aucune temporisation de {} dans une {} pour {} de « {} » ; arrondissez les "
        "retards à 100 ms, base de la plupart des temporisations, ou prenez une CPU 214, qui en "
        "a deux fois plus"};

// Integers.
inline constexpr Message<std::string_view> counter_too_wide{
    "counter '{}' can reach beyond the 32 bits that an S7-200 counts with; narrow the ranges of "
    "the counters",
    "le compteur « {} » peut dépasser les 32 bits avec lesquels compte un S7-200 ; réduisez les "
    "plages des compteurs"};
inline constexpr Message<std::string_view> sum_too_wide{
    "a sum in '{}' can reach beyond the 32 bits that an S7-200 counts with; narrow the ranges of "
    "the counters",
    "une somme de « {} » peut dépasser les 32 bits avec lesquels compte un S7-200 ; réduisez les "
    "plages des compteurs"};
inline constexpr Message<std::string_view> double_word_needed{
    "counter '{}' needs a double word in the assignment (VD instead of VW): a counter or sum of "
    "this chart needs more than 16 bits, or another counter has a double word",
    "le compteur « {} » doit avoir un double mot dans l'affectation (VD au lieu de VW) : un "
    "compteur ou une somme de ce GRAFCET demande plus de 16 bits, ou un autre compteur a un "
    "double mot"};

// Inputs and outputs.
inline constexpr Message<std::string_view, std::size_t> no_room_for_input{
    "input '{}' finds no room: an S7-200 has {} inputs, E0.0 … E7.7; give some of them addresses "
    "in M or V with an assignment (--io) and carry them over to another controller",
    "il n'y a plus de place pour l'entrée « {} » : un S7-200 a {} entrées, E0.0 … E7.7 ; donnez "
    "à certaines des adresses dans M ou V par une affectation (--io) et confiez-les à un autre "
    "automate"};
inline constexpr Message<std::string_view, std::size_t> no_room_for_output{
    "output '{}' finds no room: an S7-200 has {} outputs, A0.0 … A7.7; give some of them "
    "addresses in M or V with an assignment (--io) and carry them over to another controller",
    "il n'y a plus de place pour la sortie « {} » : un S7-200 a {} sorties, A0.0 … A7.7 ; donnez "
    "à certaines des adresses dans M ou V par une affectation (--io) et confiez-les à un autre "
    "automate"};
inline constexpr Message<std::string_view, std::string_view> unassigned{
    "'{}' has no address in the assignment; it takes {}",
    "« {} » n'a pas d'adresse dans l'affectation ; {} lui est attribué"};

// Memory.
inline constexpr Message<std::uint32_t, std::string_view, std::int32_t> too_much_v_memory{
    "the program needs {} bytes of V memory, and a {} has {}: divide the chart between two "
    "controllers",
    "le programme demande {} octets de mémoire V, et une {} en a {} : partagez le GRAFCET entre "
    "deux automates"};
inline constexpr Message<std::uint32_t, std::string_view, std::int32_t> too_much_v_memory_of_212{
    "the program needs {} bytes of V memory, and a {} has {}: divide the chart between two "
    "controllers, or take a CPU 214",
    "le programme demande {} octets de mémoire V, et une {} en a {} : partagez le GRAFCET entre "
    "deux automates, ou prenez une CPU 214"};
inline constexpr Message<std::uint32_t, std::string_view, std::uint32_t, Localized>
    program_too_long{
        "the program takes {} bytes, and the program memory of a {} holds {}: {}",
        "le programme occupe {} octets, et la mémoire de programme d'une {} en contient {} : {}"};
inline constexpr Message<> take_a_214{"take a CPU 214", "prenez une CPU 214"};
inline constexpr Message<> divide_the_chart{"divide the chart between two controllers",
                                            "partagez le GRAFCET entre deux automates"};
inline constexpr Message<> without_modes_or_214{
    "leave out the modes (--modes off), or take a CPU 214",
    "supprimez les modes (--modes off), ou prenez une CPU 214"};
inline constexpr Message<> without_modes_or_divide{
    "leave out the modes (--modes off), or divide the chart between two controllers",
    "supprimez les modes (--modes off), ou partagez le GRAFCET entre deux automates"};

}  // namespace grafwire::messages::s7_generate
