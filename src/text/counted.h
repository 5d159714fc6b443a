#pragma once

#include "text/message.h"

/// Counted nouns, for every sentence that says how many there are of something. A sentence with
/// several counts takes each as an argument:
///
///     inline constexpr Message<Localized, Localized> size{"{} and {}", "{} et {}"};
///     size(counted::steps(2), counted::transitions(1))   // 2 steps and 1 transition
namespace grafwire::messages::counted {

// Parts of a GRAFCET.
inline constexpr CountedMessage<> graphs{{"{} graph", "{} grafcet partiel"},
                                         {"{} graphs", "{} grafcets partiels"}};
inline constexpr CountedMessage<> steps{{"{} step", "{} étape"}, {"{} steps", "{} étapes"}};
inline constexpr CountedMessage<> initial_steps{{"{} initial step", "{} étape initiale"},
                                                {"{} initial steps", "{} étapes initiales"}};
/// The same in both languages.
inline constexpr CountedMessage<> transitions{{"{} transition", "{} transition"},
                                              {"{} transitions", "{} transitions"}};
inline constexpr CountedMessage<> macro_steps{{"{} macro-step", "{} macro-étape"},
                                              {"{} macro-steps", "{} macro-étapes"}};
inline constexpr CountedMessage<> inputs{{"{} input", "{} entrée"}, {"{} inputs", "{} entrées"}};
inline constexpr CountedMessage<> outputs{{"{} output", "{} sortie"}, {"{} outputs", "{} sorties"}};
inline constexpr CountedMessage<> vars{{"{} var", "{} variable interne"},
                                       {"{} vars", "{} variables internes"}};
inline constexpr CountedMessage<> counters{{"{} counter", "{} compteur"},
                                           {"{} counters", "{} compteurs"}};
inline constexpr CountedMessage<> edges{{"{} edge", "{} front"}, {"{} edges", "{} fronts"}};
inline constexpr CountedMessage<> time_conditions{{"{} time condition", "{} temporisation"},
                                                  {"{} time conditions", "{} temporisations"}};

// What a check has looked at.
/// The same in both languages.
inline constexpr CountedMessage<> situations{{"{} situation", "{} situation"},
                                             {"{} situations", "{} situations"}};
inline constexpr CountedMessage<> stable_situations{
    {"{} stable situation", "{} situation stable"},
    {"{} stable situations", "{} situations stables"}};
inline constexpr CountedMessage<> cases{{"{} case", "{} cas"}, {"{} cases", "{} cas"}};
inline constexpr CountedMessage<> compared_cases{{"{} case compared", "{} cas comparé"},
                                                 {"{} cases compared", "{} cas comparés"}};
inline constexpr CountedMessage<> compared_scans{{"{} scan compared", "{} scrutation comparée"},
                                                 {"{} scans compared", "{} scrutations comparées"}};
inline constexpr CountedMessage<> waiting_states{{"{} state waiting", "{} état en attente"},
                                                 {"{} states waiting", "{} états en attente"}};

// What a program takes up.
inline constexpr CountedMessage<> bytes{{"{} byte", "{} octet"}, {"{} bytes", "{} octets"}};
inline constexpr CountedMessage<> internal_bits{{"{} internal bit", "{} bit interne"},
                                                {"{} internal bits", "{} bits internes"}};
inline constexpr CountedMessage<> words{{"{} word", "{} mot"}, {"{} words", "{} mots"}};
inline constexpr CountedMessage<> timers{{"{} timer", "{} temporisateur"},
                                         {"{} timers", "{} temporisateurs"}};

}  // namespace grafwire::messages::counted
