#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "text/message.h"

namespace grafwire::messages::explain {

// What every explanation begins with (explanation_writer).

inline constexpr Message<std::string, std::string> changes_at{"At {} ms: {}.\n", "À {} ms : {}.\n"};
inline constexpr Message<std::string> no_change_at{"At {} ms, no input changes.\n",
                                                   "À {} ms, aucune entrée ne change.\n"};
inline constexpr Message<> the_reference{"The reference:\n", "La référence :\n"};
inline constexpr Message<std::string> before{"  before: {}\n", "  avant : {}\n"};
inline constexpr Message<> no_step{"no step", "aucune étape active"};
/// Arguments: the scan, the transitions, the situation after it.
inline constexpr Message<std::size_t, std::string, std::string> scan_clears{
    "  scan {}: clears {}. Situation: {}\n", "  scrutation {} : franchit {}. Situation : {}\n"};
inline constexpr Message<std::size_t, std::string> scan_of_orders{
    "  scan {}: orders. Situation: {}\n", "  scrutation {} : ordres. Situation : {}\n"};
/// The same with the moment of the scan.
inline constexpr Message<std::string, std::string, std::string> scan_at_clears{
    "  scan at {} ms: clears {}. Situation: {}\n",
    "  scrutation à {} ms : franchit {}. Situation : {}\n"};
inline constexpr Message<std::string, std::string> scan_at_of_orders{
    "  scan at {} ms: orders. Situation: {}\n", "  scrutation à {} ms : ordres. Situation : {}\n"};
/// Between the transitions that a scan clears.
inline constexpr Message<> between_transitions{"; ", " ; "};
inline constexpr Message<> where_they_part{"Where they part:\n", "Écart constaté :\n"};
/// Arguments: the X or output, its value, the other side, its value there.
inline constexpr Message<std::string, char, Localized, char> values_differ{
    "  {}: the reference gives {}, {} {}\n", "  {} : la référence donne {}, {} {}\n"};

// The networks of a program: their numbers, comments and lines.

inline constexpr Message<std::uint32_t> network{"network {}", "réseau {}"};
inline constexpr Message<std::uint32_t, std::string> network_titled{"network {} ({})",
                                                                    "réseau {} ({})"};
inline constexpr Message<std::uint32_t, std::uint32_t> network_at{"network {}, line {}",
                                                                  "réseau {}, ligne {}"};
inline constexpr Message<std::uint32_t, std::string, std::uint32_t> network_titled_at{
    "network {} ({}), line {}", "réseau {} ({}), ligne {}"};

// The explanation of a netlist (write_explanation).

inline constexpr Message<> the_netlist{"the netlist", "le câblage"};
inline constexpr Message<> keeps_changing{"What keeps changing:\n", "Ce qui change sans cesse :\n"};
inline constexpr Message<std::string, char> value_expected{"  {}: the reference gives {}\n",
                                                           "  {} : la référence donne {}\n"};
inline constexpr Message<std::string> follows_from{"    that follows from {}\n",
                                                   "    cela découle de {}\n"};

/// An equation: its left-hand side, its right-hand side, and the values of its operands: `X2=1
/// X3=0`.
inline constexpr Message<std::string, std::string> equation{"    {} = {}\n", "    {} = {}\n"};
inline constexpr Message<std::string, std::string, std::string> equation_with_values{
    "    {} = {}   with {}\n", "    {} = {}   avec {}\n"};
/// As the netlist has it: the whole, what it lacks, what it has too many.
inline constexpr Message<> another_equation{"another equation", "une autre équation"};
inline constexpr Message<Localized> in_netlist{"    in the netlist {}\n",
                                               "    dans le câblage, {}\n"};
inline constexpr Message<Localized, std::string> in_netlist_without{
    "    in the netlist {}; it has no {}\n", "    dans le câblage, {} ; il y manque {}\n"};
inline constexpr Message<Localized, std::string> in_netlist_with{
    "    in the netlist {}; it should not have {}\n", "    dans le câblage, {} ; en trop : {}\n"};
inline constexpr Message<Localized, std::string, std::string> in_netlist_otherwise{
    "    in the netlist {}; it has no {}; it should not have {}\n",
    "    dans le câblage, {} ; il y manque {} ; en trop : {}\n"};

inline constexpr Message<> same_equations{
    "    its gates have the same equations: it is a matter of delays\n",
    "    ses portes ont les mêmes équations : c'est une question de retards\n"};
inline constexpr Message<> deactivation_wins{
    "    its gates have the same, but where CAX and CDX are both 1 deactivation wins\n",
    "    ses portes ont les mêmes, mais là où CAX et CDX valent 1 la désactivation l'emporte\n"};
inline constexpr Message<> gates_cannot_be_compared{
    "    what the gates make of it cannot be compared\n",
    "    ce qu'en font les portes ne se compare pas\n"};
inline constexpr Message<std::string> gates_read{
    "    what the gates make of it cannot be compared; they read {}\n",
    "    ce qu'en font les portes ne se compare pas ; elles lisent {}\n"};
inline constexpr Message<std::string> decided_at{"    it is decided at {}\n",
                                                 "    cela se décide à {}\n"};
/// Counted: the lines. Arguments: the lines; the file, where it is known.
inline constexpr CountedMessage<std::string> gates_in_lines{
    {"    its gates: line {1}\n", "    ses portes : ligne {1}\n"},
    {"    its gates: lines {1}\n", "    ses portes : lignes {1}\n"}};
inline constexpr CountedMessage<std::string, std::string> gates_in_lines_of{
    {"    its gates: {2}, line {1}\n", "    ses portes : {2}, ligne {1}\n"},
    {"    its gates: {2}, lines {1}\n", "    ses portes : {2}, lignes {1}\n"}};

inline constexpr Message<> gate_by_gate{"How it came about, gate by gate:\n",
                                        "Comment on en arrive là, porte par porte :\n"};
inline constexpr Message<> no_gate_changes{"  no gate changes\n", "  aucune porte ne change\n"};
inline constexpr CountedMessage<> links_in_file{
    {"  … {} link before these stands in witness.txt\n",
     "  … {} maillon avant ceux-ci : voir witness.txt\n"},
    {"  … {} links before these stand in witness.txt\n",
     "  … {} maillons avant ceux-ci : voir witness.txt\n"}};

// A link of the chain: when, what changes (a cell perhaps with its line), and because of what.
inline constexpr Message<std::string> input{"input {}", "entrée {}"};
inline constexpr Message<std::string, std::uint32_t> cell_in_line{"{} (line {})", "{} (ligne {})"};
/// When a change comes: by the time of the run; since the last instant.
inline constexpr Message<std::string> at_time{"{} ms", "{} ms"};
inline constexpr Message<std::string> after_instant{"+{} ns", "+{} ns"};

using LinkMessage = Message<std::string, std::string>;
using AfterMessage = Message<std::string, std::string, std::string>;
inline constexpr LinkMessage rises{"  {}  {} rises\n", "  {}  {} passe à 1\n"};
inline constexpr AfterMessage rises_after{"  {}  {} rises, after {}\n",
                                          "  {}  {} passe à 1, après {}\n"};
inline constexpr LinkMessage rises_as_delay_ends{"  {}  {} rises, its delay has ended\n",
                                                 "  {}  {} passe à 1, son retard est écoulé\n"};
inline constexpr LinkMessage rises_from_the_start{"  {}  {} rises, from the start\n",
                                                  "  {}  {} passe à 1, dès le départ\n"};
inline constexpr LinkMessage falls{"  {}  {} falls\n", "  {}  {} passe à 0\n"};
inline constexpr AfterMessage falls_after{"  {}  {} falls, after {}\n",
                                          "  {}  {} passe à 0, après {}\n"};
inline constexpr LinkMessage falls_as_delay_ends{"  {}  {} falls, its delay has ended\n",
                                                 "  {}  {} passe à 0, son retard est écoulé\n"};
inline constexpr LinkMessage falls_from_the_start{"  {}  {} falls, from the start\n",
                                                  "  {}  {} passe à 0, dès le départ\n"};
inline constexpr LinkMessage becomes_undefined{"  {}  {} becomes undefined\n",
                                               "  {}  {} prend une valeur indéterminée\n"};
inline constexpr AfterMessage becomes_undefined_after{
    "  {}  {} becomes undefined, after {}\n", "  {}  {} prend une valeur indéterminée, après {}\n"};
inline constexpr LinkMessage becomes_undefined_as_delay_ends{
    "  {}  {} becomes undefined, its delay has ended\n",
    "  {}  {} prend une valeur indéterminée, son retard est écoulé\n"};
inline constexpr LinkMessage becomes_undefined_from_the_start{
    "  {}  {} becomes undefined, from the start\n",
    "  {}  {} prend une valeur indéterminée, dès le départ\n"};

inline constexpr Message<> does_not_settle{
    "The netlist does not settle. These keep changing:\n",
    "Le câblage ne se stabilise pas. Changent sans cesse :\n"};
inline constexpr CountedMessage<> and_more{{"  and {} more\n", "  et {} autre\n"},
                                           {"  and {} more\n", "  et {} autres\n"}};

// What the gates do at an instant (write_gate_story).

/// Arguments: the step or output, the nanoseconds since the instant, the changes that led there.
using WayMessage = Message<std::string, std::string, std::string>;
inline constexpr WayMessage becomes_1_by{"{} becomes 1 after {} ns: {}\n",
                                         "{} passe à 1 au bout de {} ns : {}\n"};
inline constexpr WayMessage becomes_0_by{"{} becomes 0 after {} ns: {}\n",
                                         "{} passe à 0 au bout de {} ns : {}\n"};
inline constexpr WayMessage becomes_undefined_by{
    "{} becomes undefined after {} ns: {}\n",
    "{} prend une valeur indéterminée au bout de {} ns : {}\n"};
inline constexpr Message<> by_itself{"from the start", "dès le départ"};
/// A gate on the way: its type, its net, the value, the nanoseconds.
inline constexpr Message<Localized, std::string, char, std::string> gate_on_the_way{
    "{} {}={} (+{} ns)", "{} {}={} (+{} ns)"};
inline constexpr CountedMessage<> more_changes{
    {"… and {} more step or output changes\n", "… et {} autre étape ou sortie change\n"},
    {"… and {} more steps and outputs change\n", "… et {} autres étapes et sorties changent\n"}};
inline constexpr Message<std::string, std::string> stable_after{
    "stable situation after {} ns: {}\n", "situation stable au bout de {} ns : {}\n"};
inline constexpr Message<std::string> are_undefined{"undefined: {}\n", "indéterminées : {}\n"};
inline constexpr Message<std::string> nets_keep_changing{
    "the netlist does not settle: {} keep changing\n",
    "le câblage ne se stabilise pas : {} changent sans cesse\n"};

/// Arguments: two sentences, from the rows below.
inline constexpr Message<std::string, std::string> cause_and_remedy{
    "Cause:\n  {}\nWhat helps:\n  {}\n", "Cause :\n  {}\nRemède :\n  {}\n"};

// The known causes. Arguments: the step, the others, two transitions.

/// A list: all but the last, and the last.
inline constexpr Message<std::string, std::string> and_last{"{} and {}", "{} et {}"};

using CauseMessage = Message<std::string, std::string, std::string, std::string>;

inline constexpr CauseMessage two_step_loop{
    "{0} and {1} follow each other. In the successor form of CDX the very step from which another "
    "is set also resets it, and whether the token survives depends on the delays of the gates.",
    "{0} et {1} se suivent l'une l'autre. Dans la forme « successeur » de CDX, l'étape qui active "
    "l'autre est aussi celle qui la désactive, et le jeton ne survit que si les retards des portes "
    "s'y prêtent."};
inline constexpr CauseMessage two_step_loop_remedy{
    "Put a step between the two; or use style nand, which blocks the reset while a memory is being "
    "set, or the clocked style.",
    "Insérer une étape entre les deux ; ou choisir le style nand, qui bloque la désactivation "
    "pendant l'activation, ou le style synchrone (clocked)."};

inline constexpr CauseMessage two_tokens{
    "{0} is reset by a second token: {1} is active already, and in the successor form of CDX that "
    "resets {0} although transition ({2}) has not been cleared.",
    "{0} est désactivée par un second jeton : {1} est déjà active et, dans la forme « successeur » "
    "de CDX, cela désactive {0} sans que la transition ({2}) soit franchie."};
inline constexpr CauseMessage two_tokens_remedy{
    "Use --cdx transition with latches (style nand), or the clocked style.",
    "Choisir --cdx transition avec des bascules (style nand), ou le style synchrone (clocked)."};

inline constexpr CauseMessage long_pulse{
    "The pulse of {1} outlives the passage through {0}: it is still 1 when transition ({2}) has "
    "activated {0}, and clears ({3}) as well.",
    "L'impulsion de {1} dure plus longtemps que le passage par {0} : elle vaut encore 1 quand la "
    "transition ({2}) a activé {0}, et fait franchir aussi ({3})."};
inline constexpr CauseMessage long_pulse_remedy{
    "Let a step between the two wait for the input to fall, make the pulse shorter, or use the "
    "clocked style.",
    "Insérer une étape qui attend la retombée de l'entrée, raccourcir l'impulsion, ou choisir le "
    "style synchrone (clocked)."};

inline constexpr CauseMessage fleeting_follower{
    "{1}, which should reset {0}, is active only for as long as CAX of {0} is still 1, and has "
    "gone on before the reset could act.",
    "{1}, qui doit désactiver {0}, n'est active que pendant que CAX de {0} vaut encore 1 : elle "
    "est déjà quittée quand la désactivation pourrait agir."};
inline constexpr CauseMessage fleeting_follower_remedy{
    "Let {1} last (a condition in place of one that is 1 at once), or use the clocked style.",
    "Faire durer {1} (une réceptivité qui n'est pas aussitôt vraie), ou choisir le style synchrone "
    "(clocked)."};

inline constexpr CauseMessage reset_priority{
    "CAX and CDX of {0} are 1 together, and in this memory deactivation wins. By rule 5 of GRAFCET "
    "the step stays active.",
    "CAX et CDX de {0} valent 1 ensemble, et dans cette mémoire la désactivation l'emporte. "
    "D'après la règle 5 du GRAFCET, l'étape reste active."};
inline constexpr CauseMessage reset_priority_remedy{
    "Use a memory in which activation wins (style nand).",
    "Choisir une mémoire à activation prioritaire (style nand)."};

inline constexpr CauseMessage set_and_reset{
    "CAX and CDX of {0} are 1 together and fall together. The gates of its memory are then let go "
    "at the same moment, and which state it falls into depends on their delays.",
    "CAX et CDX de {0} valent 1 ensemble et retombent ensemble. Les portes de sa mémoire sont "
    "alors relâchées au même instant, et l'état qu'elle prend dépend de leurs retards."};
inline constexpr CauseMessage set_and_reset_remedy{
    "Block the reset while the memory is being set (style nand), or use the clocked style.",
    "Bloquer la désactivation pendant l'activation (style nand), ou choisir le style synchrone "
    "(clocked)."};

inline constexpr CauseMessage input_race{
    "A race of inputs: {1} change in one instant and are read together. Changed one after the "
    "other, in any order, they do no harm.",
    "Course entre entrées : {1} changent au même instant et sont lues ensemble. Changées l'une "
    "après l'autre, dans n'importe quel ordre, elles sont sans effet fâcheux."};
inline constexpr CauseMessage input_race_remedy{
    "Let one input change at a time; if the plant never has them together, say so with assume; "
    "write out what excludes the other in each condition (a./b and b./a); or use the clocked "
    "style.",
    "Ne changer qu'une entrée à la fois ; si l'installation ne les donne jamais ensemble, le dire "
    "par assume ; écrire dans chaque réceptivité ce qui exclut l'autre (a./b et b./a) ; ou choisir "
    "le style synchrone (clocked)."};

inline constexpr CauseMessage gate_race{
    "A race of gates: which of them is faster decides, and with these delays it goes wrong.",
    "Course entre portes : la plus rapide décide, et avec ces retards le résultat est faux."};
inline constexpr CauseMessage gate_race_remedy{
    "Use a wiring whose gates wait for one another (style handshake, with --interlock where the "
    "chart depends on the order in which its transitions clear), or the clocked style; or see to "
    "it that the slow gates above are fast.",
    "Choisir un câblage dont les portes s'attendent (style handshake, avec --interlock si le "
    "grafcet dépend de l'ordre de ses franchissements) ou le style synchrone (clocked) ; ou "
    "veiller à ce que les portes lentes ci-dessus soient rapides."};

// A net that changes too often in an instant (pulse_race).

/// Arguments: the X or output, how often it changes.
inline constexpr Message<std::string, unsigned> pulses_unasked{
    "{}: {} changes in one instant, and the reference asks for none\n",
    "{} : {} changements en un seul instant, et la référence n'en demande aucun\n"};
inline constexpr Message<std::string, unsigned> pulses_beside_one{
    "{}: {} changes in one instant, and the reference asks for one\n",
    "{} : {} changements en un seul instant, et la référence n'en demande qu'un\n"};
inline constexpr Message<std::string, unsigned, unsigned> pulses_beside_some{
    "{}: {} changes in one instant, and the reference asks for {}\n",
    "{} : {} changements en un seul instant, et la référence en demande {}\n"};
/// Arguments: the gates on the one way, those on the other.
inline constexpr Message<std::string, std::string> gates_that_race{
    "Gates that race: {}, which come first; {}, which come after them\n",
    "Portes en course : {}, les premières ; {}, les suivantes\n"};

/// The circuit of a witness that depends on delays.
inline constexpr Message<> delays_needed{
    "The delays that it takes (every other gate is as fast as can be):\n",
    "Les retards qu'il faut (toute autre porte étant aussi rapide que possible) :\n"};
inline constexpr Message<std::string, std::string> delay_of_gate{"  {}: {} ns\n", "  {} : {} ns\n"};
inline constexpr Message<std::string, std::string, std::string> delay_of_gate_later{
    "  {}: {} ns from {} on\n", "  {} : {} ns à partir de {}\n"};

}  // namespace grafwire::messages::explain
