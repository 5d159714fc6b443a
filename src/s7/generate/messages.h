#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::s7_generate {

// What the tables of the method hold.
inline constexpr Message<Localized, std::uint32_t> beyond_tables{
    "the chart has {}, and the tables of the method hold {}: wide tables (--tables wide) hold them "
    "all",
    "le GRAFCET a {}, et les tables de la méthode en contiennent {} : les tables étendues "
    "(--tables wide) suffisent à tout GRAFCET"};

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
    "dans les tables étendues, la place d'un grafcet partiel se déduit du GRAFCET ; supprimez "
    "cette "
    "ligne"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_step{
    "a step is a bit of the table Ts, V{}.0 … V{}.7",
    "une étape est un bit de la table Ts, V{}.0 … V{}.7"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_transition{
    "a transition is a bit of the table Tt, V{}.0 … V{}.7",
    "une transition est un bit de la table Tt, V{}.0 … V{}.7"};
inline constexpr Message<std::int32_t, std::int32_t> place_of_graph{
    "a graph is a bit of the table Tfig, V{}.0 … V{}.7",
    "un grafcet partiel est un bit de la table Tfig, V{}.0 … V{}.7"};

// Timers.
inline constexpr Message<Localized, Localized> uncountable{
    "no timer of an S7-200 counts {} of '{}': the timers count up to 32767 times 1 ms, 10 ms or "
    "100 ms; choose a delay that is a multiple of one of these, or divide a long one between two "
    "steps",
    "aucune temporisation d'un S7-200 ne compte {} de « {} » : les temporisations comptent "
    "jusqu'à 32767 fois 1 ms, 10 ms ou 100 ms ; choisissez un retard qui en soit un multiple, ou "
    "partagez un long retard entre deux étapes"};
inline constexpr Message<Localized> or_finer{"{} or finer", "{} ou moins"};
inline constexpr Message<Localized, std::string_view, Localized, Localized> no_timer_left{
    "no timer of {} is left on a {} for {} of '{}'; round delays to 100 ms, of which there "
    "are most timers",
    "il ne reste aucune temporisation de {} dans une {} pour {} de « {} » ; arrondissez les "
    "retards à 100 ms, base de la plupart des temporisations"};
inline constexpr Message<Localized, std::string_view, Localized, Localized> no_timer_left_on_212{
    "no timer of {} is left on a {} for {} of '{}'; round delays to 100 ms, of which there "
    "are most timers, or take a CPU 214, which has twice as many",
    "il ne reste aucune temporisation de {} dans une {} pour {} de « {} » ; arrondissez les "
    "retards à 100 ms, base de la plupart des temporisations, ou prenez une CPU 214, qui en "
    "a deux fois plus"};

// Integers.
inline constexpr Message<Localized> counter_too_wide{
    "counter '{}' can reach beyond the 32 bits that an S7-200 counts with; narrow the ranges of "
    "the counters",
    "le compteur « {} » peut dépasser les 32 bits avec lesquels compte un S7-200 ; réduisez les "
    "plages des compteurs"};
inline constexpr Message<Localized> sum_too_wide{
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
/// Of more than one.
inline constexpr Message<std::string_view, std::size_t> no_room_for_input{
    "input '{}' finds no room: an S7-200 has {} inputs, E0.0 … E7.7; give some of them addresses "
    "in M or V with an assignment (--io) and carry them over to another controller",
    "il n'y a plus de place pour l'entrée « {} » : un S7-200 a {} entrées, E0.0 … E7.7 ; donnez "
    "à certaines des adresses dans M ou V par une affectation (--io) et confiez-les à un autre "
    "automate"};
/// Of more than one.
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
/// Of more than one.
inline constexpr Message<std::uint32_t, std::string_view, std::int32_t> too_much_v_memory{
    "the program needs {} bytes of V memory, and a {} has {}: divide the chart between two "
    "controllers",
    "le programme demande {} octets de mémoire V, et une {} en a {} : partagez le GRAFCET entre "
    "deux automates"};
/// Of more than one.
inline constexpr Message<std::uint32_t, std::string_view, std::int32_t> too_much_v_memory_of_212{
    "the program needs {} bytes of V memory, and a {} has {}: divide the chart between two "
    "controllers, or take a CPU 214",
    "le programme demande {} octets de mémoire V, et une {} en a {} : partagez le GRAFCET entre "
    "deux automates, ou prenez une CPU 214"};
/// Of more than one.
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

// The head of a listing.
inline constexpr Message<> what_it_is{
    "A GRAFCET by the table method of Cordier (1998) for Siemens S7-200.",
    "GRAFCET par la méthode des tables de Cordier (1998), pour Siemens S7-200."};
/// Of more than one.
inline constexpr Message<std::uint32_t, std::uint32_t> program_memory{
    "Program memory: {} bytes; {} of them are the skeleton of the method.",
    "Mémoire de programme : {} octets, dont {} pour le squelette de la méthode."};
/// Of more than one.
inline constexpr Message<std::uint32_t, std::string, std::uint32_t> bytes_of_chart{
    "The chart takes {} bytes, {} a step (usual: {}).",
    "Le GRAFCET occupe {} octets, soit {} par étape (en général : {})."};
/// Of more than one.
inline constexpr Message<std::string_view, std::uint32_t, std::int32_t> fits{
    "{}, {} bytes of program, {} of V memory: fits.",
    "{}, {} octets de programme, {} de mémoire V : suffisant."};
/// Of more than one.
inline constexpr Message<std::string_view, std::uint32_t, std::int32_t> does_not_fit{
    "{}, {} bytes of program, {} of V memory: does not fit.",
    "{}, {} octets de programme, {} de mémoire V : insuffisant."};
inline constexpr Message<> tables{"Tables:", "Tables :"};
inline constexpr Message<> table_of_graphs{"0: the graph is frozen",
                                           "0 : le grafcet partiel est figé"};
inline constexpr Message<> accumulator{"accumulator", "accumulateur"};
inline constexpr Message<> free_bits{"free bits", "bits libres"};
inline constexpr Message<> steps_before{"steps, the scan before", "étapes, scrutation précédente"};
inline constexpr Message<> steps{"steps", "étapes"};
inline constexpr Message<> steps_just_activated{"steps that have become active",
                                                "étapes venant d'être activées"};
inline constexpr Message<> steps_to_activate{"steps to activate", "étapes à activer"};
inline constexpr Message<> steps_to_deactivate{"steps to deactivate", "étapes à désactiver"};
inline constexpr Message<> steps_forced_on{"steps forced to 1", "étapes forcées à 1"};
inline constexpr Message<> steps_forced_off{"steps forced to 0", "étapes forcées à 0"};
inline constexpr Message<> table_of_transitions{"transitions: transition condition and Tfig",
                                                "transitions : réceptivité et Tfig"};
inline constexpr Message<> more_memory{"more bits, words", "autres bits et mots"};
inline constexpr Message<> addresses{"Addresses:", "Adresses :"};

// The main program, by the subroutine that it calls.
inline constexpr Message<> first_scan_only{"First scan only: SBR 0, initialisation",
                                           "Première scrutation seulement : SBR 0, initialisation"};
inline constexpr Message<> call_1{"Tables of the scan before",
                                  "Tables de la scrutation précédente"};
inline constexpr Message<> call_2{"Preliminary calculations", "Calculs préliminaires"};
inline constexpr Message<> call_3{"Transition conditions", "Réceptivités"};
inline constexpr Message<> call_4{"Evolution", "Évolution"};
inline constexpr Message<> call_5{"Forcing", "Forçages"};
inline constexpr Message<> call_6{"Timers and counters", "Temporisations et compteurs"};
inline constexpr Message<> call_8{"Outputs", "Sorties"};

// The subroutines.
inline constexpr Message<> subroutine_0{"SBR 0: initialisation", "SBR 0 : initialisation"};
inline constexpr Message<> subroutine_1{"SBR 1: tables of the scan before",
                                        "SBR 1 : tables de la scrutation précédente"};
inline constexpr Message<> subroutine_2{"SBR 2: preliminary calculations, edges",
                                        "SBR 2 : calculs préliminaires, fronts"};
inline constexpr Message<> subroutine_3{
    "SBR 3: transition conditions, Tt = transition condition and Tfig",
    "SBR 3 : réceptivités des transitions, Tt = réceptivité et Tfig"};
inline constexpr Message<> subroutine_4{"SBR 4: evolution of the graphs",
                                        "SBR 4 : évolution des grafcets partiels"};
inline constexpr Message<> subroutine_5{"SBR 5: forcing", "SBR 5 : forçages"};
inline constexpr Message<> subroutine_6{"SBR 6: timers and counters",
                                        "SBR 6 : temporisations et compteurs"};
inline constexpr Message<> subroutine_8{"SBR 8: outputs, freezing", "SBR 8 : sorties, figeages"};
inline constexpr Message<> subroutine_10{"SBR 10: Tpulse, the steps that have become active",
                                         "SBR 10 : Tpulse, étapes venant d'être activées"};

// Networks that are the same in every listing.
inline constexpr Message<> no_graph_frozen{"Tfig = 1: no graph is frozen",
                                           "Tfig = 1 : aucun grafcet partiel n'est figé"};
inline constexpr Message<> other_tables_cleared{"All other tables = 0",
                                                "Toutes les autres tables = 0"};
inline constexpr Message<> initial_steps{"Initial steps", "Étapes initiales"};
inline constexpr Message<> no_initial_steps{"There are no initial steps", "Pas d'étape initiale"};
inline constexpr Message<> memories_cleared{"Memories of the chart = 0", "Mémoires du GRAFCET = 0"};
inline constexpr Message<> timers{"Timers", "Temporisations"};
inline constexpr Message<> no_memories{"There are no memories, counters and timers",
                                       "Ni mémoire, ni compteur, ni temporisation"};
inline constexpr Message<> no_transitions{"There are no transitions", "Pas de transition"};
inline constexpr Message<> no_forcing_orders{"There are no forcing orders",
                                             "Pas d'ordre de forçage"};
inline constexpr Message<> formula_of_evolution{"Ts = (Tp and not Td) or Ta",
                                                "Ts = (Tp et non Td) ou Ta"};
inline constexpr Message<> formula_of_forcing{"Ts = (Ts and not Tf0) or Tf1",
                                              "Ts = (Ts et non Tf0) ou Tf1"};
inline constexpr Message<> formula_of_pulse{"Tpulse = Ts and not Tp", "Tpulse = Ts et non Tp"};

// Networks of one statement; the argument says what that is for.
inline constexpr Message<Localized> sum_of{"{}: the sum", "{} : la somme"};
inline constexpr Message<Localized> sums_of{"{}: the sums", "{} : les sommes"};
inline constexpr Message<Localized> part_of{"a part of {}", "une partie de {}"};
inline constexpr Message<Localized> value_of{"value of {}", "valeur de {}"};
inline constexpr Message<Localized> off_delay_of{"off-delay of {}",
                                                 "retard au déclenchement de {}"};
inline constexpr Message<std::int64_t> not_above{"not above {}", "{} au plus"};
inline constexpr Message<std::int64_t> not_below{"not below {}", "{} au moins"};

}  // namespace grafwire::messages::s7_generate
