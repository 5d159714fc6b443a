#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the language of GRAFCETs are about.
namespace code {
inline constexpr Code duration_out_of_range{"duration-out-of-range"};
inline constexpr Code transition_without_step{"transition-without-step"};
inline constexpr Code step_of_another_graph{"step-of-another-graph"};
inline constexpr Code assignment_to_input{"assignment-to-input"};
inline constexpr Code continuous_on_internal{"continuous-on-internal"};
inline constexpr Code edge_in_condition{"edge-in-condition"};
inline constexpr Code macro_not_allowed_here{"macro-not-allowed-here"};
inline constexpr Code reads_continuous_output{"reads-continuous-output"};
inline constexpr Code output_driven_twice{"output-driven-twice"};
inline constexpr Code forcing_unknown_graph{"forcing-unknown-graph"};
inline constexpr Code forcing_foreign_step{"forcing-foreign-step"};
inline constexpr Code forcing_circle{"forcing-circle"};
inline constexpr Code counter_range{"counter-range"};
inline constexpr Code not_a_counter{"not-a-counter"};
inline constexpr Code not_a_boolean{"not-a-boolean"};
inline constexpr Code enclosed_twice{"enclosed-twice"};
inline constexpr Code encloses_twice{"encloses-twice"};
inline constexpr Code enclosure_initial_mismatch{"enclosure-initial-mismatch"};
inline constexpr Code variable_clash{"variable-clash"};
inline constexpr Code expansion_entry_exit{"expansion-entry-exit"};
inline constexpr Code expansion_use{"expansion-use"};
inline constexpr Code not_a_plant_condition{"not-a-plant-condition"};
inline constexpr Code contradicting_assumptions{"contradicting-assumptions"};
inline constexpr Code no_steps{"no-steps"};
inline constexpr Code unreachable_step{"unreachable-step"};
inline constexpr Code graph_without_start{"graph-without-start"};
inline constexpr Code constant_receptivity{"constant-receptivity"};
inline constexpr Code event_without_edge{"event-without-edge"};
inline constexpr Code unused_name{"unused-name"};
inline constexpr Code conflicting_writes{"conflicting-writes"};
inline constexpr Code circle_of_definitions{"circle-of-definitions"};
inline constexpr Code held_and_stored{"held-and-stored"};
inline constexpr Code not_a_duration{"not-a-duration"};
inline constexpr Code name_is_operator{"name-is-operator"};
inline constexpr Code step_named_like_variable{"step-named-like-variable"};
}  // namespace code

/// What is said of charts, and how they are described.
namespace messages::grafcet {

// What a text is made of.
inline constexpr Message<> end_of_file{"the end of the file", "la fin du fichier"};
inline constexpr Message<> empty_name{"an empty name", "un nom vide"};
inline constexpr Message<Localized> quoted_word{"the name {}", "le nom {}"};
inline constexpr Message<> unterminated_text{
    "this quoted text has no end on its line; close it with '\"'",
    "ce texte entre guillemets n'a pas de fin sur sa ligne ; fermez-le par « \" »"};
/// The same in both languages.
inline constexpr Message<std::uint32_t> character_code{"U+{:04X}", "U+{:04X}"};
inline constexpr Message<Localized> unexpected_character{
    "the character {} has no meaning here; remove it, or write the name it belongs to between "
    "quotation marks",
    "le caractère {} n'a pas de sens ici ; supprimez-le, ou mettez entre guillemets droits le nom "
    "dont il fait partie"};
inline constexpr Message<Localized, Localized> expected{"expected {}, got {}",
                                                        "on attend ici {} et non {}"};
inline constexpr Message<Localized, std::string_view> reserved_word_as_name{
    "expected {0}, got '{1}', a reserved word; to use it as a name write \"{1}\"",
    "on attend ici {0} et non « {1} », qui est un mot réservé ; pour en faire un nom, écrivez "
    "\"{1}\""};
inline constexpr Message<Localized, Localized> number_as_name{
    "expected {}, got {}; to use it as a name put it between quotation marks",
    "on attend ici {} et non {} ; pour en faire un nom, mettez-le entre guillemets droits"};
inline constexpr Message<Localized, std::int64_t> written_number_too_large{
    "the number {} is too large; numbers go up to {}",
    "le nombre {} est trop grand ; un nombre va jusqu'à {}"};
inline constexpr Message<> file_too_large{
    "the file is larger than 4 GiB; cut the GRAFCET into several",
    "le fichier dépasse 4 Gio ; découpez le GRAFCET en plusieurs"};

// Declarations.
inline constexpr Message<> name_of_grafcet{"the name of the GRAFCET", "le nom du GRAFCET"};
inline constexpr Message<std::string_view> declaration_after_graphs{
    "declarations stand before the graphs; move this '{}' up",
    "les déclarations précèdent les grafcets partiels ; remontez ce « {} »"};
inline constexpr Message<> grafcet_not_first{
    "'grafcet' stands once, at the beginning of the file",
    "« grafcet » ne figure qu'une fois, au début du fichier"};
inline constexpr Message<> brace_closes_nothing{
    "this '}}' closes nothing; remove it", "cette accolade « }} » ne ferme rien ; supprimez-la"};
inline constexpr Message<std::string_view> stands_inside_graph{
    "'{}' stands inside a graph or an expansion, as in graph G1 {{ … }}",
    "« {} » se place dans un grafcet partiel ou une expansion, comme dans graph G1 {{ … }}"};
inline constexpr Message<> declaration_or_graph{"a declaration or a graph",
                                                "une déclaration ou un grafcet partiel"};
inline constexpr Message<> an_output{"an output", "une sortie"};
inline constexpr Message<> a_var{"a var", "une variable interne"};
inline constexpr Message<> an_input{"an input", "une entrée"};
inline constexpr Message<> a_counter{"a counter", "un compteur"};
inline constexpr Message<> comma_between_names{"',' between the names", "« , » entre les noms"};
inline constexpr Message<> colon_and_range{"':' and the range, as in counter c : 0..9",
                                           "« : » et la plage, comme dans « counter c : 0..9 »"};
inline constexpr Message<> dots_of_range{"'..' between the lowest and the highest value",
                                         "« .. » entre la plus petite et la plus grande valeur"};
inline constexpr Message<> one_counter_each{
    "each counter has a declaration of its own; write 'counter' again",
    "chaque compteur a sa propre déclaration ; écrivez de nouveau « counter »"};
inline constexpr Message<> number_for_range{"a number for the range of the counter",
                                            "un nombre pour la plage du compteur"};

// Graphs and their steps.
inline constexpr Message<> name_of_expansion{"the name of the expansion", "le nom de l'expansion"};
inline constexpr Message<> name_of_graph{"the name of the graph", "le nom du grafcet partiel"};
inline constexpr Message<> brace_of_expansion{"'{{' and the steps of the expansion",
                                              "« {{ » et les étapes de l'expansion"};
inline constexpr Message<> brace_of_graph{"'{{' and the steps of the graph",
                                          "« {{ » et les étapes du grafcet partiel"};
inline constexpr Message<Localized, Localized> end_of_expansion{
    "expected '}}' at the end of expansion {}, got {}",
    "on attend « }} » à la fin de l'expansion {} et non {}"};
inline constexpr Message<Localized, Localized> end_of_graph{
    "expected '}}' at the end of graph {}, got {}",
    "on attend « }} » à la fin du grafcet partiel {} et non {}"};
inline constexpr Message<> begins_here{"it begins here", "le début est ici"};
inline constexpr Message<std::string_view> declaration_in_graph{
    "declarations stand before the graphs; move this '{}' up, or close the graph with '}}' before "
    "it",
    "les déclarations précèdent les grafcets partiels ; remontez ce « {} », ou fermez d'abord le "
    "grafcet partiel par "
    "« }} »"};
inline constexpr Message<> step_or_transition{"a step, a transition or '}}'",
                                              "une étape, une transition ou « }} »"};
inline constexpr Message<> name_of_step{"the name of the step", "le nom de l'étape"};
inline constexpr Message<> name_of_enclosed_graph{"the name of the enclosed graph",
                                                  "le nom du grafcet partiel encapsulé"};
inline constexpr Message<> brace_of_links{"'{{' and the steps to activate, as in G3{{60}}",
                                          "« {{ » et les étapes à activer, comme dans G3{{60}},"};
inline constexpr Message<> enclosure_without_links{
    "an enclosing step names the steps that are activated with it, as in G3{{60}}",
    "une étape encapsulante nomme les étapes activées avec elle, comme dans G3{{60}}"};
inline constexpr Message<> name_of_a_step{"the name of a step", "le nom d'une étape"};
inline constexpr Message<> comma_or_brace{"',' or '}}'", "« , » ou « }} »"};
inline constexpr Message<> name_of_macro_step{"the name of the macro-step",
                                              "le nom de la macro-étape"};
inline constexpr Message<> equal_and_expansion{"'=' and the name of the expansion",
                                               "« = » et le nom de l'expansion"};
inline constexpr Message<> name_of_entry{"the name of the entry step",
                                         "le nom de l'étape d'entrée"};
inline constexpr Message<> name_of_exit{"the name of the exit step", "le nom de l'étape de sortie"};

// Transitions and actions.
inline constexpr Message<> name_of_transition{"the name of the transition",
                                              "le nom de la transition"};
inline constexpr Message<> parenthesis_of_label{"')' after the name of the transition",
                                                "« ) » après le nom de la transition"};
inline constexpr Message<> comma_or_arrow{"',' or '->'", "« , » ou « -> »"};
inline constexpr Message<Localized, std::string_view, Localized> did_you_mean_instead{
    "{}; did you mean '{}' instead of {}?", "{} ; vouliez-vous dire « {} » au lieu de {} ?"};
inline constexpr Message<> comma_or_condition{"',' or ':' and the transition condition",
                                              "« , », ou « : » et la réceptivité,"};
inline constexpr Message<> an_action{"an action", "une action"};
inline constexpr Message<Localized> number_as_action{
    "expected an action, got {}; an output of that name is written between quotation marks",
    "on attend une action et non {} ; une sortie de ce nom s'écrit entre guillemets droits"};
inline constexpr Message<> situation_of_order{"the name of a step, '*', INIT or '}}'",
                                              "le nom d'une étape, « * », INIT ou « }} »"};
inline constexpr Message<> closing_brace{"'}}'", "« }} »"};
inline constexpr Message<> written_name{"the name of an output or var",
                                        "le nom d'une sortie ou d'une variable interne"};
inline constexpr Message<> set_reset_or_assign{"'set', 'reset' or a name and ':='",
                                               "« set », « reset » ou un nom et « := »"};
inline constexpr Message<> assign_and_value{"':=' and the value", "« := » et la valeur"};

// Expressions.
inline constexpr Message<> counter_or_number{"a counter or a number", "un compteur ou un nombre"};
inline constexpr Message<std::string_view> parenthesis_after{"'(' after '{}'",
                                                             "« ( » après « {} »"};
inline constexpr Message<> operator_or_parenthesis{"an operator or ')'", "un opérateur ou « ) »"};
inline constexpr Message<> slash_after_duration{"'/' after the duration, as in 5s/X13",
                                                "« / » après la durée, comme dans 5s/X13,"};
inline constexpr Message<> duration_after_slash{
    "a duration after '/', as in 1s/X5/2s, or an operator before it",
    "une durée après « / », comme dans 1s/X5/2s, ou un opérateur devant,"};
inline constexpr Message<Localized> duration_out_of_range{
    "the duration {} is too long or too fine; durations go up to 106 days in whole picoseconds",
    "la durée {} est trop longue ou trop fine ; une durée va jusqu'à 106 jours, en picosecondes "
    "entières"};
inline constexpr Message<> relation{"one of = <> < <= > >= in the comparison",
                                    "l'un des signes = <> < <= > >= dans la comparaison"};
inline constexpr Message<> end_of_comparison{"']' at the end of the comparison",
                                             "« ] » à la fin de la comparaison"};
inline constexpr Message<Localized, std::string_view> number_as_condition{
    "the number {0} is no condition: the variable of step {1} is X{1}, and counters are compared "
    "in "
    "brackets, as in [c = {1}]",
    "le nombre {0} n'est pas une condition : la variable de l'étape {1} est X{1}, et un compteur "
    "se "
    "compare entre crochets, comme dans [c = {1}]"};
inline constexpr Message<> a_condition{"a condition", "une condition"};
inline constexpr Message<> operator_or_end{"an operator or the end of the expression",
                                           "un opérateur ou la fin de l'expression"};

// Other notations, and how they are written here.
inline constexpr Message<Localized, std::string_view> digits_and_letters{
    "{0} begins with a digit and is neither a number nor a duration; a name that begins with a "
    "digit "
    "stands between quotation marks: \"{1}\"",
    "{0} commence par un chiffre sans être un nombre ni une durée ; un nom qui commence par un "
    "chiffre se met entre guillemets droits : \"{1}\""};
inline constexpr Message<Localized> overlined_name{
    "expected {}; an overline negates a condition, so remove it here",
    "on attend ici {} ; une barre est la négation d'une condition, supprimez-la ici"};
inline constexpr Message<> partly_overlined{
    "the overline covers only a part of this name; put it over each letter, or write / before the "
    "name",
    "la barre ne couvre qu'une partie de ce nom ; mettez-la sur chaque lettre, ou écrivez / devant "
    "le nom"};
inline constexpr Message<> remark_begins_otherwise{"a remark begins with '#'",
                                                   "un commentaire commence par « # »"};
inline constexpr Message<> parenthesis_out_of_place{
    "a parenthesis cannot stand here: AND is written '.', as in a . (b + c); a priority is written "
    "out, as in b . /a; a remark begins with '#'; the label of a transition begins its line",
    "une parenthèse n'a pas de sens ici : ET s'écrit « . », comme dans a . (b + c) ; une priorité "
    "s'écrit en toutes lettres, comme dans b . /a ; un commentaire commence par « # » ; le repère "
    "d'une transition est en début de ligne"};
inline constexpr Message<> negation_before{
    "NOT is written before what it negates: /a, or an overline over it",
    "la négation s'écrit devant ce qu'elle porte : /a, ou par une barre au-dessus"};
inline constexpr Message<> rise_written{"a rising edge is written ↑a or rise(a)",
                                        "un front montant s'écrit ↑a ou rise(a)"};
inline constexpr Message<std::string_view> edge_called{
    "an edge is written ↑a or rise(a), ↓a or fall(a); '{}' is none",
    "un front s'écrit ↑a ou rise(a), ↓a ou fall(a), et non « {} »"};
inline constexpr Message<std::string_view, std::string_view> decimal_point{
    "the decimal mark of a duration is a point: {}.{}",
    "le séparateur décimal d'une durée est le point : {}.{}"};
inline constexpr Message<std::string_view, std::string_view> space_before_unit{
    "no space stands between a number and its unit: {0}{1}, as in {0}{1}/X5",
    "pas d'espace entre un nombre et son unité : {0}{1}, comme dans {0}{1}/X5"};
inline constexpr Message<std::string_view, std::string_view> time_condition_order{
    "a time condition is written with the duration first and the variable behind it: {0}/{1}",
    "une temporisation s'écrit avec la durée d'abord et la variable ensuite : {0}/{1}"};
inline constexpr Message<> comparison_without_brackets{
    "a variable is written alone where it is to be 1, with / where it is to be 0; counters are "
    "compared in brackets, as in [n = 1]; how long step 3 has been active is 5s/X3",
    "une variable s'écrit seule quand elle doit valoir 1, avec / quand elle doit valoir 0 ; un "
    "compteur se compare entre crochets, comme dans [n = 1] ; la durée d'activité de l'étape 3 "
    "s'écrit 5s/X3"};
inline constexpr Message<> action_in_brackets{"actions stand without brackets: C := C + 1",
                                              "une action s'écrit sans crochets : C := C + 1"};
inline constexpr Message<std::string_view> action_with_value{
    "a continuous action is the name alone, {0}: it is 1 while the step is active; a stored one is "
    "set {0} or reset {0}",
    "une action continue est le nom seul, {0} : elle vaut 1 tant que l'étape est active ; une "
    "action "
    "mémorisée s'écrit set {0} ou reset {0}"};
inline constexpr Message<std::string_view, std::string_view> qualifier_written{
    "a stored action is written {0} {1}", "une action mémorisée s'écrit {0} {1}"};
inline constexpr Message<std::string_view> order_written{
    "a forcing order names the graph and its situation: {0}{{10}}, {0}{{}} for none, {0}{{INIT}}, "
    "{0}{{*}} to freeze",
    "un ordre de forçage nomme le grafcet partiel et sa situation : {0}{{10}}, {0}{{}} pour la "
    "situation "
    "vide, "
    "{0}{{INIT}}, {0}{{*}} pour figer"};
inline constexpr Message<Localized, std::string_view> word_is_operator{
    "{} is also read as the operator '{}'; here the declared name counts",
    "{} se lit aussi comme l'opérateur « {} » ; ici, c'est le nom déclaré qui compte"};

// Names that stand for something.
inline constexpr Message<> name_of_condition{"the name of a condition", "le nom d'une condition"};
inline constexpr Message<> equal_and_condition{
    "'=' and a condition, as in define ready = v0 . h0",
    "« = » et une condition, comme dans define prêt = v0 . h0,"};
inline constexpr Message<> name_of_duration{"the name of a duration", "le nom d'une durée"};
inline constexpr Message<> equal_and_duration{"'=' and a duration, as in time T3 = 300ms",
                                              "« = » et une durée, comme dans time T3 = 300ms,"};
inline constexpr Message<> a_duration{"a duration, as in 300ms", "une durée, comme 300ms,"};
inline constexpr Message<Localized> definition_named{"the defined name {}", "le nom défini {}"};
inline constexpr Message<Localized> duration_named{"the duration {}", "la durée {}"};
inline constexpr Message<Localized> circle_of_definitions{
    "names stand for one another in a circle: {}; write one of them out",
    "des noms se définissent l'un l'autre en boucle : {} ; écrivez l'un d'eux en toutes lettres"};
inline constexpr Message<Localized> edge_behind_name{
    "{} stands for a condition with an edge, which cannot stand in the condition of a continuous "
    "action; use it in a transition condition or after 'on'",
    "{} désigne une condition avec un front, qui ne peut pas conditionner une action continue ; "
    "employez-le dans une réceptivité ou après « on »"};
inline constexpr Message<Localized> no_plant_condition_behind_name{
    "{} stands for more than inputs, and an assumption is over inputs and control inputs alone",
    "{} ne désigne pas que des entrées, et une hypothèse ne porte que sur des entrées"};
inline constexpr Message<> stands_for_this{"it stands for this", "il désigne ceci"};
/// Of more than one.
inline constexpr Message<Localized, std::uint32_t> definition_too_large{
    "{} stands for an expression of more than {} parts; keep a part of it in a var",
    "{} désigne une expression de plus de {} parties ; gardez-en une partie dans une variable "
    "interne"};
inline constexpr Message<Localized> definition_written{
    "{} is a defined name, which no action changes; declare a var instead",
    "{} est un nom défini, qu'aucune action ne modifie ; déclarez plutôt une variable interne"};
inline constexpr Message<Localized, std::string_view> duration_read{
    "{0} is a duration; it stands before '/', as in {1}/X5",
    "{0} est une durée ; elle se place devant « / », comme dans {1}/X5"};
inline constexpr Message<Localized> unknown_duration{
    "unknown duration {}; declare it with time, as in time T3 = 300ms, or write an operator before "
    "it",
    "la durée {} est inconnue ; déclarez-la par time, comme dans time T3 = 300ms, ou écrivez un "
    "opérateur devant"};
inline constexpr Message<Localized> not_a_duration{
    "{} is no duration; declare one with time, as in time T3 = 300ms",
    "{} n'est pas une durée ; déclarez-en une par time, comme dans time T3 = 300ms"};
inline constexpr Message<Localized> var_held_and_stored{
    "{} is held by continuous actions and changed by stored ones; use one kind only",
    "{} est tenue par des actions continues et modifiée par des actions mémorisées ; n'en utilisez "
    "qu'une sorte"};
inline constexpr Message<Localized> definition_unused{
    "the condition {} is defined and never used",
    "la condition {} est définie mais jamais utilisée"};
inline constexpr Message<Localized> duration_unused{
    "the duration {} is declared and never used", "la durée {} est déclarée mais jamais utilisée"};
inline constexpr Message<Localized, std::string_view> step_named_like_variable{
    "the variable of step {0} is X{1}; if X{1} is not what you mean, name the step without the X",
    "la variable de l'étape {0} est X{1} ; si ce n'est pas ce que vous voulez, nommez l'étape sans "
    "X"};
inline constexpr Message<Localized, Localized, std::string> steps_of_two_graphs{
    "{} and {} both have steps {}; step names are unique in the whole file, so number those of one "
    "graph otherwise, as in 10, 11, …",
    "{} et {} ont tous deux les étapes {} ; un nom d'étape est unique dans tout le fichier, "
    "numérotez "
    "donc autrement celles de l'un des deux, par exemple 10, 11, …"};

// Contradictions of a whole chart.
inline constexpr Message<> assumption_never_1{
    "this assumption is never 1, so that no input is left",
    "cette hypothèse ne vaut jamais 1 : il ne reste aucune combinaison d'entrées"};
inline constexpr CountedMessage<> contradicting_assumptions{
    {"this assumption contradicts another, so that no input is left",
     "cette hypothèse en contredit une autre : il ne reste aucune combinaison d'entrées"},
    {"this assumption contradicts {} others together, so that no input is left",
     "cette hypothèse contredit {} autres prises ensemble : il ne reste aucune combinaison "
     "d'entrées"}};
inline constexpr Message<std::string> other_assumption{"the other: assume {}",
                                                       "l'autre : assume {}"};
inline constexpr Message<> no_steps{
    "there is no step, and a GRAFCET needs one at least: graph G {{ initial 0 }}",
    "il n'y a pas d'étape, et il en faut au moins une à un GRAFCET : graph G {{ initial 0 }}"};
inline constexpr Message<Localized> encloses_twice{
    "step {} encloses a graph already; a step encloses one graph at most",
    "l'étape {} encapsule déjà un grafcet partiel ; une étape encapsule un grafcet partiel au "
    "plus"};
inline constexpr Message<> entry_outside_of_expansion{
    "'entry' stands in an expansion only; in a graph write 'step'",
    "« entry » ne se place que dans une expansion ; dans un grafcet partiel, écrivez « step »"};
inline constexpr Message<> exit_outside_of_expansion{
    "'exit' stands in an expansion only; in a graph write 'step'",
    "« exit » ne se place que dans une expansion ; dans un grafcet partiel, écrivez « step »"};

// Names.
inline constexpr Message<> first_declared_here{"it is first declared here",
                                               "la première déclaration est ici"};
inline constexpr Message<std::int64_t, std::int64_t, Localized> empty_range{
    "the range {}..{} of counter {} is empty; write the lowest value first",
    "la plage {}..{} du compteur {} est vide ; écrivez d'abord la plus petite valeur"};
/// Of more than one.
inline constexpr Message<std::int64_t, std::int64_t, Localized, std::int64_t, std::int64_t>
    range_too_wide{
        "the range {}..{} of counter {} spans {} values; a counter has {} at most",
        "la plage {}..{} du compteur {} compte {} valeurs ; un compteur en a {} au plus"};
inline constexpr Message<Localized> control_input_declared{
    "{} is a control input, which every GRAFCET has without declaring it; remove this declaration "
    "or choose another name",
    "{} est une entrée de commande, que tout GRAFCET possède sans la déclarer ; supprimez cette "
    "déclaration ou choisissez un autre nom"};
inline constexpr Message<Localized> variable_twice{
    "the variable {} exists already; rename one of the two",
    "la variable {} existe déjà ; renommez l'une des deux"};
inline constexpr Message<Localized> expansion_twice{
    "the expansion {} exists already; rename one of the two",
    "l'expansion {} existe déjà ; renommez l'une des deux"};
inline constexpr Message<Localized> graph_twice{
    "the graph {} exists already; rename one of the two",
    "le grafcet partiel {} existe déjà ; renommez l'un des deux"};
inline constexpr Message<Localized> step_twice{
    "the step {} exists already; step names are unique in the whole file, so rename one of the two",
    "l'étape {} existe déjà ; un nom d'étape est unique dans tout le fichier, renommez donc l'une "
    "des deux"};
inline constexpr Message<Localized> transition_twice{
    "the transition {} exists already; transition names are unique in the whole file, so rename "
    "one of the two",
    "la transition {} existe déjà ; un nom de transition est unique dans tout le fichier, renommez "
    "donc l'une des deux"};
inline constexpr Message<Localized> label_is_rank{
    "the label {} is also the rank of a transition without a label; label that one too, or choose "
    "another label",
    "le repère {} est aussi le rang d'une transition sans repère ; donnez-en un à celle-ci, ou "
    "choisissez un autre repère"};
inline constexpr Message<std::uint32_t> transition_of_rank{
    "this transition has rank {0}: it is named '{0}'",
    "cette transition a le rang {0} : elle se nomme « {0} »"};
inline constexpr Message<Localized> input_named{"input {}", "l'entrée {}"};
inline constexpr Message<Localized> output_named{"output {}", "la sortie {}"};
inline constexpr Message<Localized> var_named{"var {}", "la variable interne {}"};
inline constexpr Message<Localized> counter_named{"counter {}", "le compteur {}"};
inline constexpr Message<Localized, Localized, Localized> variable_clash{
    "{} and {} both have the variable {}; rename one of them",
    "{} et {} ont la même variable {} ; changez l'un des deux noms"};
inline constexpr Message<Localized> declared_here{"{} is declared here",
                                                  "la déclaration est ici : {}"};
inline constexpr Message<Localized> expansion_named{"expansion {}", "l'expansion {}"};
inline constexpr Message<Localized> graph_named{"graph {}", "le grafcet partiel {}"};
inline constexpr Message<Localized> macro_step_named{"macro-step {}", "la macro-étape {}"};
inline constexpr Message<Localized> step_named{"step {}", "l'étape {}"};
inline constexpr Message<Localized> unknown_step{"unknown step {}", "l'étape {} est inconnue"};

// Macro-steps and expansions.
inline constexpr Message<Localized, std::string_view> expanded_by_graph{
    "{} is a graph; a macro-step is expanded by an expansion, declared with 'expansion {} {{ … }}'",
    "{} est un grafcet partiel ; une macro-étape se développe en une expansion, déclarée par "
    "« expansion {} "
    "{{ … }} »"};
inline constexpr Message<Localized> unknown_expansion{"unknown expansion {}",
                                                      "l'expansion {} est inconnue"};
inline constexpr Message<Localized, Localized> expansion_used_twice{
    "expansion {} expands macro-step {} already; each macro-step needs an expansion of its own",
    "l'expansion {} est déjà celle de la macro-étape {} ; il faut à chaque macro-étape sa propre "
    "expansion"};
inline constexpr Message<> first_used_here{"it is first used here",
                                           "la première utilisation est ici"};
inline constexpr Message<Localized> second_entry{
    "expansion {} has a second entry step; an expansion has exactly one",
    "l'expansion {} a une deuxième étape d'entrée ; une expansion en a exactement une"};
inline constexpr Message<Localized> second_exit{
    "expansion {} has a second exit step; an expansion has exactly one",
    "l'expansion {} a une deuxième étape de sortie ; une expansion en a exactement une"};
inline constexpr Message<> first_one_here{"the first one is here", "la première est ici"};
inline constexpr Message<Localized> no_entry{
    "expansion {} has no entry step; declare it with 'entry E1'",
    "l'expansion {} n'a pas d'étape d'entrée ; déclarez-la par « entry E1 »"};
inline constexpr Message<Localized> no_exit{
    "expansion {} has no exit step; declare it with 'exit S1'",
    "l'expansion {} n'a pas d'étape de sortie ; déclarez-la par « exit S1 »"};
inline constexpr Message<Localized, Localized> expansion_contains_itself{
    "expansion {} contains itself ({}); a macro-step must not lead back to an expansion it stands "
    "in",
    "l'expansion {} se contient elle-même ({}) ; une macro-étape ne doit pas ramener à une "
    "expansion où elle se trouve"};
inline constexpr Message<Localized, std::string_view> unused_expansion{
    "no macro-step uses expansion {}; declare one with 'macro M = {}', or remove the expansion",
    "aucune macro-étape n'utilise l'expansion {} ; déclarez-en une par « macro M = {} », ou "
    "supprimez l'expansion"};

// Transitions and their conditions.
inline constexpr Message<Localized> unknown_variable{"unknown variable {}",
                                                     "la variable {} est inconnue"};
inline constexpr Message<Localized, Localized, std::string_view> unknown_variable_of{
    "unknown variable {}; the variable of {} is X{}",
    "la variable {} est inconnue ; {} a pour variable X{}"};
inline constexpr Message<Localized> no_input_in_assumption{
    "{} is no input in 'assume'; an assumption is about the plant, so it is made of inputs and "
    "control inputs, without edges, times and comparisons",
    "{} n'est pas une entrée ; une hypothèse (« assume ») porte sur la partie opérative et se "
    "compose donc d'entrées et d'entrées de commande, sans front, ni temporisation, ni "
    "comparaison"};
inline constexpr Message<> edge_in_assumption{
    "edge in 'assume'; an assumption is about the plant, so it is made of inputs and control "
    "inputs, without edges, times and comparisons",
    "un front n'a pas sa place ici ; une hypothèse (« assume ») porte sur la partie opérative et "
    "se compose donc d'entrées et d'entrées de commande, sans front, ni temporisation, ni "
    "comparaison"};
inline constexpr Message<> time_in_assumption{
    "time condition in 'assume'; an assumption is about the plant, so it is made of inputs and "
    "control inputs, without edges, times and comparisons",
    "une temporisation n'a pas sa place ici ; une hypothèse (« assume ») porte sur la partie "
    "opérative et se compose donc d'entrées et d'entrées de commande, sans front, ni "
    "temporisation, ni comparaison"};
inline constexpr Message<> comparison_in_assumption{
    "comparison in 'assume'; an assumption is about the plant, so it is made of inputs and control "
    "inputs, without edges, times and comparisons",
    "une comparaison n'a pas sa place ici ; une hypothèse (« assume ») porte sur la partie "
    "opérative et se compose donc d'entrées et d'entrées de commande, sans front, ni "
    "temporisation, ni comparaison"};
inline constexpr Message<Localized, std::string_view> counter_as_condition{
    "{} is a counter, not a condition; compare it, as in [{} > 0]",
    "{} est un compteur et non une condition ; comparez-le, comme dans [{} > 0]"};
inline constexpr Message<> edge_in_condition{
    "edge in the condition of a continuous action: it would last one scan only; use a stored "
    "action ('set … on ↑…'), or a time condition around the edge",
    "un front dans la condition d'une action continue ne durerait qu'une scrutation ; utilisez une "
    "action mémorisée (« set … on ↑… »), ou une temporisation autour du front"};
inline constexpr Message<Localized, Localized, Localized> step_of_another_graph{
    "{} belongs to {}; a transition of {} names steps and macro-steps of that graph only",
    "{} est dans {} ; une transition placée dans {} ne nomme que des étapes et des macro-étapes de "
    "ce grafcet partiel"};
inline constexpr Message<Localized, Localized, Localized> step_of_another_expansion{
    "{} belongs to {}; a transition of {} names steps and macro-steps of that expansion only",
    "{} est dans {} ; une transition placée dans {} ne nomme que des étapes et des macro-étapes de "
    "cette expansion"};
inline constexpr Message<Localized> not_a_counter{
    "{} is not a counter; only counters and numbers are compared and added",
    "{} n'est pas un compteur ; on ne compare et n'additionne que des compteurs et des nombres"};
inline constexpr Message<Localized> unknown_counter{"unknown counter {}",
                                                    "le compteur {} est inconnu"};
inline constexpr Message<Localized> named_twice{
    "{} is named twice in this list; name it once",
    "{} est nommée deux fois dans cette liste ; nommez-la une seule fois"};
inline constexpr Message<> named_here_too{"it is named here too", "l'autre mention est ici"};
inline constexpr Message<> transition_without_step{
    "this transition has no step before it and none after it; name at least one, as in 1 -> 2",
    "cette transition n'a d'étape ni en amont ni en aval ; nommez-en au moins une, comme dans 1 -> "
    "2"};

// Actions and orders.
inline constexpr Message<Localized, std::string_view> continuous_on_counter{
    "continuous action on the counter {0}, which changes by stored actions only; write '{1} := {1} "
    "+ 1', or declare it as an output",
    "cette action continue porte sur le compteur {0}, que seules des actions mémorisées "
    "modifient ; écrivez « {1} := {1} + 1 », ou déclarez-le comme sortie"};
inline constexpr Message<Localized> input_written{
    "{} is an input, which the GRAFCET reads and never writes; name an output, a var or a counter",
    "{} est une entrée, que le GRAFCET lit sans jamais l'écrire ; nommez une sortie, une variable "
    "interne ou un compteur"};
inline constexpr Message<Localized> control_input_written{
    "{} is a control input, which the GRAFCET reads and never writes; name an output, a var or a "
    "counter",
    "{} est une entrée de commande, que le GRAFCET lit sans jamais l'écrire ; nommez une sortie, "
    "une variable interne ou un compteur"};
inline constexpr Message<Localized> step_variable_written{
    "{} follows the situation and is never written; use a forcing order to change the situation of "
    "a graph",
    "{} suit la situation et ne s'écrit jamais ; pour changer la situation d'un grafcet partiel, "
    "utilisez "
    "un ordre de forçage"};
inline constexpr Message<Localized> unknown_output{"unknown output {}",
                                                   "la sortie {} est inconnue"};
inline constexpr Message<Localized, std::string_view> unknown_output_is_graph{
    "unknown output {0}; an order to graph {0} is written {1}{{…}}",
    "la sortie {0} est inconnue ; un ordre au grafcet partiel {0} s'écrit {1}{{…}}"};
inline constexpr Message<Localized, std::string_view> counter_set{
    "{} is a counter, which is neither set nor reset; write a value, as in {} := 0",
    "{} est un compteur, qui ne se met ni à 1 ni à 0 ; écrivez une valeur, comme dans {} := 0"};
inline constexpr Message<Localized> value_of_counter{
    "{} is a counter; assign a sum of counters and numbers",
    "{} est un compteur ; affectez-lui une somme de compteurs et de nombres"};
inline constexpr Message<Localized> value_of_boolean{
    "{} is not a counter; assign a condition",
    "{} n'est pas un compteur ; affectez-lui une condition"};
inline constexpr Message<Localized> expansion_as_graph{
    "{} is an expansion; orders and enclosures name graphs",
    "{} est une expansion ; un ordre et une encapsulation nomment des grafcets partiels"};
inline constexpr Message<Localized> unknown_graph{"unknown graph {}",
                                                  "le grafcet partiel {} est inconnu"};
inline constexpr Message<Localized> macro_step_in_order{
    "{} is a macro-step; a forcing order names steps, such as the entry step of its expansion",
    "{} est une macro-étape ; un ordre de forçage nomme des étapes, par exemple l'étape d'entrée "
    "de son expansion"};
inline constexpr Message<Localized> macro_step_in_link{
    "{} is a macro-step; an activation link names steps, such as the entry step of its expansion",
    "{} est une macro-étape ; un lien d'activation nomme des étapes, par exemple l'étape d'entrée "
    "de son expansion"};
inline constexpr Message<Localized, Localized, Localized, Localized> foreign_step{
    "{} belongs to {}, not to {}; name steps of {}",
    "{} est dans {} et non dans {} ; nommez des étapes de {}"};
inline constexpr Message<Localized> output_driven_twice{
    "output {} is driven by continuous and by stored actions; use one kind only",
    "la sortie {} est commandée à la fois par des actions continues et par des actions "
    "mémorisées ; n'en utilisez qu'une sorte"};
inline constexpr Message<> continuous_drives_here{"a continuous action drives it here",
                                                  "une action continue la commande ici"};
inline constexpr Message<> stored_drives_here{"a stored action drives it here",
                                              "une action mémorisée la commande ici"};
inline constexpr Message<Localized> undriven_output_read{
    "output {} is read, but no stored action drives it; only stored outputs can be read",
    "la sortie {} est lue, mais aucune action mémorisée ne la commande ; seule une sortie "
    "mémorisée peut être lue"};
inline constexpr Message<Localized, std::string> continuous_output_read{
    "{} is a continuous output, which cannot be read; write its condition instead, or declare it "
    "as a "
    "var, which steps hold and conditions read: var {}",
    "{} est une sortie continue, qui ne peut pas être lue ; écrivez plutôt sa condition, ou "
    "déclarez-la comme variable interne, que les étapes tiennent et que les conditions lisent : "
    "var {}"};
inline constexpr Message<> this_continuous_action{"this continuous action drives it",
                                                  "cette action continue la commande"};

// The hierarchy of graphs.
inline constexpr Message<Localized, Localized> encloses_its_graph{
    "{} encloses its own graph {}; only another graph can be forced or enclosed",
    "{} encapsule son propre grafcet partiel {} ; on ne peut forcer ou encapsuler qu'un autre "
    "grafcet partiel"};
inline constexpr Message<Localized, Localized> forces_its_graph{
    "{} forces its own graph {}; only another graph can be forced or enclosed",
    "{} force son propre grafcet partiel {} ; on ne peut forcer ou encapsuler qu'un autre grafcet "
    "partiel"};
inline constexpr Message<Localized, Localized> encloses{"{} encloses {}", "{} encapsule {}"};
inline constexpr Message<Localized, Localized> forces{"{} forces {}", "{} force {}"};
inline constexpr Message<Localized> circle_of_graphs{
    "graphs force or enclose one another in a circle: {}; break the circle at one place",
    "des grafcets partiels se forcent ou s'encapsulent en boucle : {} ; rompez cette boucle en un "
    "point"};
inline constexpr Message<Localized, Localized, Localized> encloses_here{
    "{} of {} encloses {} here", "{} de {} encapsule ici {}"};
inline constexpr Message<Localized, Localized, Localized> forces_here{"{} of {} forces {} here",
                                                                      "{} de {} force ici {}"};
inline constexpr Message<Localized, Localized> enclosed_twice{
    "{} is enclosed by {} already; a graph is enclosed by one step at most",
    "{} est déjà encapsulé par {} ; un grafcet partiel est encapsulé par une étape au plus"};
inline constexpr Message<> first_enclosed_here{"it is first enclosed here",
                                               "la première encapsulation est ici"};
inline constexpr Message<Localized, Localized, Localized> initial_in_enclosed{
    "{} is initial, but {}, which encloses its graph {}, is not; make both initial or neither",
    "{} est initiale, mais {}, qui encapsule son grafcet partiel {}, ne l'est pas ; rendez "
    "initiales les "
    "deux étapes ou aucune"};
inline constexpr Message<> enclosing_step_here{"the enclosing step is here",
                                               "l'étape encapsulante est ici"};
inline constexpr Message<Localized, Localized> initial_encloses{
    "{} is initial, but {}, which it encloses, has no initial step; make both initial or neither",
    "{} est initiale, mais {}, qu'elle encapsule, n'a pas d'étape initiale ; donnez-lui-en une, ou "
    "rendez l'étape encapsulante non initiale"};
inline constexpr Message<> enclosed_graph_here{"the enclosed graph is here",
                                               "le grafcet partiel encapsulé est ici"};

// Parts that a reader of another format may leave out or make too large.
inline constexpr Message<> grafcet_without_name{"the GRAFCET has no name",
                                                "le GRAFCET n'a pas de nom"};
inline constexpr Message<> title_without_name{"the title has no name", "le titre n'a pas de nom"};
inline constexpr Message<> variable_without_name{"a variable has no name",
                                                 "une variable n'a pas de nom"};
inline constexpr Message<> expansion_without_name{"an expansion has no name",
                                                  "une expansion n'a pas de nom"};
inline constexpr Message<> graph_without_name{"a graph has no name",
                                              "un grafcet partiel n'a pas de nom"};
inline constexpr Message<> macro_step_without_name{"a macro-step has no name",
                                                   "une macro-étape n'a pas de nom"};
inline constexpr Message<> step_without_name{"a step has no name", "une étape n'a pas de nom"};
inline constexpr Message<> transition_without_name{"a transition has no name",
                                                   "une transition n'a pas de nom"};
inline constexpr Message<> assumption_without_condition{"this assumption has no condition",
                                                        "cette hypothèse n'a pas de condition"};
inline constexpr Message<> transition_without_condition{"this transition has no condition",
                                                        "cette transition n'a pas de réceptivité"};
inline constexpr Message<> event_without_condition{"the event has no condition",
                                                   "l'événement n'a pas de condition"};
inline constexpr Message<> assignment_without_condition{"the assignment has no condition",
                                                        "l'affectation n'a pas de condition"};
inline constexpr Message<Localized> quotation_mark_in_name{
    "the name {} holds a quotation mark, and no name may",
    "le nom {} contient un guillemet droit, ce qu'aucun nom ne peut contenir"};
inline constexpr Message<Localized> no_expansion{"{} has no expansion", "{} n'a pas d'expansion"};
inline constexpr Message<Localized, Localized> encloses_without_links{
    "{} encloses {} without a step to activate", "{} encapsule {} sans étape à activer"};
inline constexpr Message<Localized> enclosing_end{
    "{} is the entry or exit of an expansion, which encloses nothing",
    "{} est l'entrée ou la sortie d'une expansion, qui n'encapsule rien"};
inline constexpr Message<> bad_delay{
    "a duration is negative or too long; durations go up to 106 days",
    "une durée est négative ou trop longue ; une durée va jusqu'à 106 jours"};
inline constexpr Message<> side_of_comparison_empty{"a side of the comparison is empty",
                                                    "un membre de la comparaison est vide"};
/// Of more than one.
inline constexpr Message<int> nested_too_deep{
    "this expression is nested more than {} levels deep; give parts of it to vars of their own",
    "cette expression est imbriquée sur plus de {} niveaux ; confiez-en des parties à des "
    "variables internes"};
inline constexpr Message<std::int64_t, std::int64_t> number_too_large{
    "the number {} is too large; numbers go up to {}",
    "le nombre {} est trop grand ; un nombre va jusqu'à {}"};
/// Of more than one.
inline constexpr Message<std::uint32_t> sum_too_long{"a sum has {} terms at most",
                                                     "une somme a {} termes au plus"};

// Warnings.
inline constexpr Message<Localized> graph_without_start{
    "graph {} has no initial step and nothing forces it, so it never becomes active; make a step "
    "initial",
    "le grafcet partiel {} n'a pas d'étape initiale et rien ne le force : il ne devient jamais "
    "actif ; "
    "rendez une étape initiale"};
inline constexpr Message<Localized> unreachable_step{
    "nothing can activate step {}: it is not initial, and no transition, forcing order or "
    "activation link that can come about leads to it",
    "rien ne peut activer l'étape {} : elle n'est pas initiale, et aucune transition "
    "franchissable, aucun ordre de forçage ni aucun lien d'activation possible n'y mène"};
inline constexpr Message<Localized> constant_receptivity{
    "the transition condition of transition {} is constantly 0, so it is never cleared",
    "la réceptivité de la transition {} vaut toujours 0 : cette transition n'est jamais franchie"};
inline constexpr Message<> event_without_edge{
    "the event after 'on' has no edge, so this action runs at every scan in which it is 1; write ↑ "
    "or ↓ before what should happen",
    "l'événement après « on » n'a pas de front : l'action s'exécute à chaque scrutation où il vaut "
    "1 ; écrivez ↑ ou ↓ devant ce qui doit se produire"};
inline constexpr Message<Localized> input_unused{"input {} is declared and never used",
                                                 "l'entrée {} est déclarée mais jamais utilisée"};
inline constexpr Message<Localized> output_unused{"output {} is declared and never used",
                                                  "la sortie {} est déclarée mais jamais utilisée"};
inline constexpr Message<Localized> var_unused{
    "var {} is declared and never used",
    "la variable interne {} est déclarée mais jamais utilisée"};
inline constexpr Message<Localized> counter_unused{
    "counter {} is declared and never used", "le compteur {} est déclaré mais jamais utilisé"};
inline constexpr Message<Localized> conflicting_writes{
    "several stored actions may write {} in the same scan; only the last of them then counts",
    "plusieurs actions mémorisées peuvent écrire {} dans la même scrutation ; seule la dernière "
    "compte alors"};
inline constexpr Message<> another_one_here{"another one is here", "une autre est ici"};

// The description of a chart.
inline constexpr Message<> graphs{"Graphs", "Grafcets partiels"};
inline constexpr Message<std::string, std::string, std::string> graph_line{"{}: {}, {}",
                                                                           "{} : {}, {}"};
inline constexpr Message<std::string> steps_line{"steps: {}", "étapes : {}"};
inline constexpr Message<std::string> transitions_line{"transitions: {}", "transitions : {}"};
inline constexpr Message<std::string> initial_step{"{} (initial)", "{} (initiale)"};
inline constexpr Message<std::string, std::size_t> and_more{"{}, … and {} more",
                                                            "{}, … et {} de plus"};
inline constexpr Message<> macro_steps{"Macro-steps", "Macro-étapes"};
/// Macro-step, its graph, the expansion, its entry, its exit, how many steps.
inline constexpr Message<std::string, std::string, std::string, std::string, std::string,
                         std::string>
    macro_step_line{"{} of {}: expansion {}, entry {}, exit {}, {}",
                    "{} de {} : expansion {}, entrée {}, sortie {}, {}"};
inline constexpr Message<> enclosing_steps{"Enclosing steps", "Étapes encapsulantes"};
inline constexpr Message<std::string, std::string, std::string, std::string> enclosure_line{
    "{} of {} encloses {}, activation links: {}", "{} de {} encapsule {}, liens d'activation : {}"};
inline constexpr Message<> hierarchy{"Hierarchy of forcing orders and enclosures",
                                     "Hiérarchie des ordres de forçage et des encapsulations"};
inline constexpr Message<std::string, std::string> dominance{"{}: {}", "{} : {}"};
inline constexpr Message<std::string, std::string> further_dominance{"{}; {}", "{} ; {}"};
inline constexpr Message<std::string> forced_by{"forced by {}", "forçage par {}"};
inline constexpr Message<std::string> frozen_by{"frozen by {}", "figeage par {}"};
inline constexpr Message<std::string> enclosed_by{"enclosed by {}", "encapsulation par {}"};
inline constexpr Message<std::string> shown_above{"{} (shown above)", "{} (voir plus haut)"};

}  // namespace messages::grafcet

}  // namespace grafwire
