#pragma once

#include <string>

#include "text/message.h"

namespace grafwire::messages::draw {

// What a viewer shows of the parts of a picture, and reads aloud.

inline constexpr Message<std::string> step{"step {}", "étape {}"};
inline constexpr Message<std::string> active_step{"step {}, active", "étape {}, active"};
inline constexpr Message<std::string> macro_step{"macro-step {}", "macro-étape {}"};

// Headings.

inline constexpr Message<std::string> expansion{"Expansion of {}", "Expansion de {}"};

/// The page, and how many there are.
inline constexpr Message<std::size_t, std::size_t> sheet{"sheet {} of {}", "folio {} sur {}"};
/// At a cut link: the step, and the page that it stands on.
inline constexpr Message<std::string, std::size_t> on_sheet{"{}, sheet {}", "{}, folio {}"};

// What a sheet shows, for those who hear a picture: how many there are, and their names.

inline constexpr CountedMessage<std::string> shown_steps{{"{} step: {}.", "{} étape : {}."},
                                                         {"{} steps: {}.", "{} étapes : {}."}};
inline constexpr CountedMessage<std::string> shown_active_steps{
    {"{} active step: {}.", "{} étape active : {}."},
    {"{} active steps: {}.", "{} étapes actives : {}."}};
inline constexpr CountedMessage<std::string> shown_macro_steps{
    {"{} macro-step: {}.", "{} macro-étape : {}."},
    {"{} macro-steps: {}.", "{} macro-étapes : {}."}};
inline constexpr CountedMessage<std::string> shown_transitions{
    {"{} transition: {}.", "{} transition : {}."}, {"{} transitions: {}.", "{} transitions : {}."}};
inline constexpr CountedMessage<std::string> shown_modules{
    {"Schematic of {} module: {}.", "Schéma de {} module : {}."},
    {"Schematic of {} modules: {}.", "Schéma de {} modules : {}."}};
inline constexpr CountedMessage<std::string> shown_signals{
    {"Timing diagram of {} signal: {}.", "Chronogramme de {} signal : {}."},
    {"Timing diagram of {} signals: {}.", "Chronogramme de {} signaux : {}."}};

// Schematics.

/// Above modules that are made for a part of the chart and have no equation.
inline constexpr Message<std::string> step_module{"Step {}", "Étape {}"};
/// The same in both languages.
inline constexpr Message<std::string> transition{"Transition {}", "Transition {}"};
inline constexpr Message<std::string> output{"Output {}", "Sortie {}"};
/// The same in both languages.
inline constexpr Message<std::string> var{"Variable {}", "Variable {}"};
inline constexpr Message<std::string> counter{"Counter {}", "Compteur {}"};
inline constexpr Message<std::string> graph{"Graph {}", "Grafcet partiel {}"};
inline constexpr Message<std::string> time_condition{"Time condition {}", "Temporisation {}"};
inline constexpr Message<> complements{"Inputs", "Entrées"};
inline constexpr Message<> edges{"Edges", "Fronts"};
/// Output ports that are joined to a net of another name.
inline constexpr Message<> ports{"Outputs", "Sorties"};
/// The second part of a module, and so on.
inline constexpr Message<std::string, std::size_t> continued{"{} (part {})", "{} (partie {})"};
inline constexpr Message<> gate_delay_later{"X′ is X a gate delay later.",
                                            "X′ est X retardé du temps d'une porte."};
inline constexpr Message<> index_of_names{"Index of names", "Index des noms"};
/// The sheets on which a name is made, and read.
inline constexpr Message<> made_on{"from sheet", "du folio"};
inline constexpr Message<> read_on{"to sheets", "aux folios"};
/// In the index, where a name comes from outside.
inline constexpr Message<> input{"input", "entrée"};

// Timing diagrams.

/// The line that shows it; the same in both languages.
inline constexpr Message<> situation{"Situation", "Situation"};
/// The second line of a signal that two runs do not have in common.
inline constexpr Message<std::string> found{"{} found", "{} constaté"};
inline constexpr Message<> time{"time", "temps"};
inline constexpr Message<> inputs{"inputs", "entrées"};
inline constexpr Message<> steps{"steps", "étapes"};
inline constexpr Message<> outputs{"outputs", "sorties"};
/// On an axis within an instant, and what was there before it.
inline constexpr Message<std::string> nanoseconds{"{}ns", "{} ns"};
inline constexpr Message<> before{"before", "avant"};
/// Vars and counters; inner nets.
inline constexpr Message<> internals{"internal", "internes"};
inline constexpr Message<> not_to_scale{
    "Only moments at which something changes are shown; time is not to scale.",
    "Seuls les instants où quelque chose change sont montrés ; le temps n'est pas à l'échelle."};

}  // namespace grafwire::messages::draw
