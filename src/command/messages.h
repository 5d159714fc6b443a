#pragma once

#include <cstdint>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"
#include "text/time.h"

namespace grafwire::code {
/// Of a file of shared options.
inline constexpr Code bad_config{"bad-config"};
}  // namespace grafwire::code

namespace grafwire::messages::command {

// The command line.

/// An option and what is wrong with its value.
inline constexpr Message<std::string_view, std::string_view> option_value{"{}: {}", "{} : {}"};
inline constexpr Message<std::string_view, std::string_view> not_one_of{"{} not in {}",
                                                                        "« {} » n'est pas dans {}"};
inline constexpr Message<std::string_view> no_whole_number{
    "'{}' is no whole number from 0 to 18446744073709551615",
    "« {} » n'est pas un nombre entier de 0 à 18446744073709551615"};
inline constexpr Message<std::string_view> no_number{"'{}' is no number from 0 on",
                                                     "« {} » n'est pas un nombre à partir de 0"};
inline constexpr Message<std::string_view> unknown_option{"there is no option '{}'",
                                                          "il n'y a pas d'option « {} »"};
inline constexpr Message<std::string_view, std::string_view> unknown_option_near{
    "there is no option '{}'; did you mean '{}'?",
    "il n'y a pas d'option « {} » ; vouliez-vous dire « {} » ?"};
inline constexpr Message<std::string_view, std::string_view> unknown_command{
    "there is no command '{}' (commands: {})", "il n'y a pas de commande « {} » (commandes : {})"};
inline constexpr Message<std::string_view, std::string_view, std::string_view> unknown_command_near{
    "there is no command '{}'; did you mean '{}'? (commands: {})",
    "il n'y a pas de commande « {} » ; vouliez-vous dire « {} » ? (commandes : {})"};
inline constexpr Message<std::string_view> word_too_many{
    "'{}' is one word too many; check, equations, fmt, info, netlist and plc take several GRAFCETs",
    "« {} » est un mot de trop ; plusieurs GRAFCET : avec check, equations, fmt, info, netlist et "
    "plc"};
inline constexpr Message<std::string_view> argument_required{"{} is required", "il manque {}"};
inline constexpr Message<> command_required{"A subcommand is required", "il manque une commande"};
inline constexpr Message<std::string_view, std::string_view> value_missing{
    "{}: 1 required {} missing", "{} : il manque la valeur ({})"};
inline constexpr Message<std::string_view, std::size_t> given_too_often{
    "{}: At Most 1 required but received {}", "{} : une seule valeur est admise, et non {}"};
inline constexpr Message<std::string_view, std::string_view> flag_with_value{
    "Could not convert: {} = {}", "{} ne prend pas de valeur (« {} »)"};
inline constexpr Message<Localized, std::string_view> see_help{
    "{}\n'grafwire {}--help' shows what there is.",
    "{}\n« grafwire {}--help » montre ce qu'il y a."};

// Options.

inline constexpr Message<std::string_view, std::string> unknown_format{
    "there is no format '{}'; there are: {}", "il n'y a pas de format « {} » ; il y a : {}"};
inline constexpr Message<std::string_view, std::string_view> unknown_format_near{
    "there is no format '{}'; did you mean '{}'?",
    "il n'y a pas de format « {} » ; vouliez-vous dire « {} » ?"};
inline constexpr Message<std::string_view> no_period{
    "'{}' is no period: write a positive duration such as 10ms",
    "« {} » n'est pas une période : écrivez une durée positive, comme 10ms"};
/// The name of the file without its ending.
inline constexpr Message<std::string> no_fst{
    "this grafwire was built without FST: write {0}.vcd, and 'vcd2fst {0}.vcd {0}.fst' of GTKWave "
    "makes FST of it",
    "ce grafwire a été construit sans FST : écrivez {0}.vcd, et « vcd2fst {0}.vcd {0}.fst » de "
    "GTKWave en fait un fichier FST"};
inline constexpr Message<std::string_view> no_moment{
    "'{}' is no moment of a run: write a duration such as 500ms, or 0",
    "« {} » n'est pas un instant : écrivez une durée, comme 500ms, ou 0"};
inline constexpr Message<> moment_needed{
    "stimuli without --at change nothing: say which moment of the run is to be drawn",
    "sans --at, les stimuli ne changent rien : dites quel instant est à dessiner"};
inline constexpr Message<std::string_view> no_values_at{
    "the gates do not settle up to {}: 'grafwire simulate' shows how far the run goes",
    "les portes ne se stabilisent pas jusqu'à {} : « grafwire simulate » montre jusqu'où va "
    "l'évolution"};
inline constexpr Message<std::string_view> no_situation_at{
    "there is no stable situation at {}: 'grafwire run' shows how far the run goes",
    "il n'y a pas de situation stable à {} : « grafwire run » montre jusqu'où va "
    "l'évolution"};
/// The moment as asked for, and the instants nearest to it.
inline constexpr Message<std::string_view, std::string_view> no_instant_at{
    "the run has no instant at {}; nearest to it: {}",
    "l'évolution n'a pas d'instant à {} ; les plus proches : {}"};
inline constexpr Message<std::string_view> no_amount_of_memory{
    "'{}' is no amount of memory: write 500M or 2G",
    "« {} » n'est pas une quantité de mémoire : écrivez 500M ou 2G"};
inline constexpr Message<> stimuli_share_standard_input{
    "GRAFCET and stimuli cannot both come from standard input: give a file for one",
    "le GRAFCET et les stimuli ne peuvent pas venir tous deux de l'entrée standard : donnez un "
    "fichier pour l'un des deux"};
inline constexpr Message<std::string_view> delays_are_open{
    "--delay {} leaves the delays of gates open: say with --delays FILE which circuit is simulated",
    "--delay {} laisse les retards des portes ouverts : indiquez par --delays FICHIER le "
    "circuit à simuler"};
inline constexpr Message<> delays_share_standard_input{
    "the delays cannot come from standard input, from which something else is read: give a file",
    "les retards ne peuvent pas venir de l'entrée standard, d'où autre chose est lu : donnez un "
    "fichier"};
inline constexpr Message<> assignment_shares_standard_input{
    "GRAFCET and assignment cannot both come from standard input",
    "le GRAFCET et la table d'affectation ne peuvent pas venir tous deux de l'entrée standard"};
inline constexpr Message<std::string_view> no_netlist_file{
    "{}: a netlist to compare with is a .blif or a .json (Yosys) file, a program an .awl (S7-200) "
    "or "
    "an .xml (PLCopen) file",
    "{} : un câblage à comparer est un fichier .blif ou .json (Yosys), un programme un fichier "
    ".awl "
    "(S7-200) ou .xml (PLCopen)"};
inline constexpr Message<> grafcet_needs_io{
    "--grafcet needs --io: the table that says which address is which step",
    "--grafcet demande --io : la table qui dit à quelle étape correspond chaque adresse"};
inline constexpr Message<std::string_view> listing_needs_io{
    "--io: {} needs a table that says which address is which input, output and step",
    "--io : {} demande une table qui dit à quelle entrée, sortie ou étape correspond chaque "
    "adresse"};

// Several charts.

inline constexpr Message<> no_chart_in_folder{
    "there is no .grafcet file in this folder, nor below it",
    "il n'y a aucun fichier .grafcet dans ce dossier, ni plus bas"};
inline constexpr Message<> nothing_fits{"no file fits this pattern",
                                        "aucun fichier ne correspond à ce motif"};
/// Two files, and the name that the result of either would get.
inline constexpr Message<std::string, std::string, std::string> same_name{
    "{} and {}: the results of both would be called {}; give them to two calls, with a folder each",
    "{} et {} : les résultats des deux s'appelleraient {} ; traitez-les en deux appels, avec un "
    "dossier chacun"};
inline constexpr Message<> several_need_folder{
    "several GRAFCETs in a form that cannot stand one behind the other: name a folder with -o",
    "plusieurs GRAFCET dans une forme qui ne se met pas bout à bout : donnez un dossier avec -o"};
/// The same in both languages.
inline constexpr Message<std::string> file_heading{"==> {} <==\n", "==> {} <==\n"};
inline constexpr Message<> one_file_to_standard_output{
    "several files: only one goes to standard output; -i replaces files, --check looks at them",
    "plusieurs fichiers : un seul peut aller sur la sortie standard ; -i remplace les fichiers, "
    "--check les examine"};
inline constexpr Message<> replace_or_check{
    "-i and --check exclude each other: one writes, the other writes nothing",
    "-i et --check s'excluent : l'un écrit, l'autre n'écrit rien"};
inline constexpr Message<> standard_input_in_place{
    "-i replaces files, and standard input is none: leave out -i",
    "-i remplace des fichiers, et l'entrée standard n'en est pas un : enlevez -i"};

// grafwire.toml.

inline constexpr Message<std::string> no_toml{"this is no TOML: {}", "ceci n'est pas du TOML : {}"};
inline constexpr Message<std::string> option_below_no_command{
    "'{}' stands below no command: options stand in a table of their command, such as [check]",
    "« {} » n'est sous aucune commande : les options sont dans la table de leur commande, comme "
    "[check]"};
inline constexpr Message<std::string> no_value_of_option{
    "{} takes a text, a number, true or false, or a list of texts or numbers",
    "{} prend un texte, un nombre, true ou false, ou une liste de textes ou de nombres"};
inline constexpr Message<std::string> option_of_one_call{
    "{} belongs to a single call, and cannot be shared: write it on the command line",
    "{} appartient à un seul appel et ne se partage pas : écrivez-la sur la ligne de commande"};
inline constexpr Message<std::string> flag_is_true_or_false{"{} is either true or false",
                                                            "{} vaut true ou false"};
inline constexpr Message<std::string> option_has_value{"{} has a value, and is not true or false",
                                                       "{} a une valeur, et ne vaut pas true ou "
                                                       "false"};
/// Two files.
inline constexpr Message<std::string, std::string> two_configs{
    "these GRAFCETs have different shared options, {} and {}: give them to two calls, or leave "
    "both "
    "out with --no-config",
    "ces GRAFCET ont des options partagées différentes, {} et {} : traitez-les en deux appels, ou "
    "ignorez les deux avec --no-config"};

// Options without effect, and what they are for.

inline constexpr Message<std::string_view, Localized> has_no_effect{"{} has no effect here: {}",
                                                                    "{} est sans effet ici : {}"};
inline constexpr Message<std::string_view, std::string_view, std::string_view> format_has_no_option{
    "{} has no {}; it is for {}", "{} ne connaît pas {} ; cette option est pour {}"};
inline constexpr Message<> only_generated{"it is for a netlist made from the GRAFCET",
                                          "cette option est pour un câblage tiré du GRAFCET"};
inline constexpr Message<> only_handshake{
    "it is for a netlist made in the style handshake: only there does the order of clearing matter",
    "cette option est pour un câblage fait dans le style handshake : là seulement, l'ordre des "
    "franchissements importe"};
inline constexpr Message<> only_clocked{
    "it is for the clocked style: the others have no scans",
    "cette option est pour le style clocked : les autres n'ont pas de scrutation"};
inline constexpr Message<> only_asynchronous{
    "it is for netlists without a clock: what a clocked one does does not depend on its gates, as "
    "long as they are faster than the clock",
    "cette option est pour les câblages sans horloge : ce que fait un câblage à horloge ne dépend "
    "pas de ses portes, tant qu'elles sont plus rapides que l'horloge"};
inline constexpr Message<> stimuli_by_bench{
    "this format takes stimuli with --bench, as a test bench",
    "ce format prend les stimuli avec --bench, comme banc d'essai"};
inline constexpr Message<> stimuli_by_moment{
    "this format takes stimuli with --at, the moment whose values are drawn",
    "ce format prend les stimuli avec --at, l'instant dont les valeurs sont dessinées"};
inline constexpr Message<> values_need_stimuli{"it needs --stim, the stimuli of the run",
                                               "il faut --stim, les stimuli de l'évolution"};
inline constexpr Message<> bench_needs_stimuli{"it needs --stim, what the bench applies",
                                               "il faut --stim, que le banc d'essai applique"};
inline constexpr Message<> bench_needs_output{
    "it needs -o: the bench is written beside that file",
    "il faut -o : le banc d'essai est écrit à côté de ce fichier"};
inline constexpr Message<> only_netlist_from_file{
    "it is for a netlist given with --against",
    "cette option est pour un câblage donné avec --against"};
inline constexpr Message<> only_open_start{
    "it is for a netlist from elsewhere without an input Init",
    "cette option est pour un câblage venu d'ailleurs sans entrée Init"};
inline constexpr Message<> only_ladder{
    "it is for a ladder diagram given with --against",
    "cette option est pour un schéma à contacts donné avec --against"};
inline constexpr Message<> only_listing{
    "it is for an S7-200 listing given with --against",
    "cette option est pour une liste d'instructions S7-200 donnée avec --against"};
inline constexpr Message<> program_has_no_gates{"a program has no gates",
                                                "un programme n'a pas de portes"};
inline constexpr Message<> needs_stimuli{"without STIM the run is step by step",
                                         "sans STIM, on avance pas à pas"};
inline constexpr Message<> moment_needs_stimuli{"it needs STIM, the stimuli of the run",
                                                "il faut STIM, les stimuli de l'évolution"};
inline constexpr Message<> inputs_are_sampled{
    "inputs are sampled, and any of them change between two scans",
    "les entrées sont échantillonnées, et peuvent toutes changer entre deux scrutations"};
inline constexpr Message<> nothing_is_scanned{"nothing is scanned", "il n'y a pas de scrutation"};

// Runs and checks.

inline constexpr Message<std::string_view, std::string_view> no_stable_situation{
    "no stable situation at {} ms; these keep changing: {}",
    "pas de situation stable à {} ms ; changent sans cesse : {}"};
/// Of more than one scan, and more than one column.
inline constexpr Message<Time, std::size_t, std::size_t> too_many_scans{
    "{} scans with {} columns each are more than a trace may hold, {} values; take a longer "
    "period, "
    "or end the stimuli earlier",
    "{} scrutations de {} colonnes dépassent ce qu'une trace peut contenir, {} valeurs ; prenez "
    "une "
    "période plus longue, ou arrêtez les stimuli plus tôt"};
inline constexpr Message<std::string_view, Localized> netlist_does_not_settle{
    "the netlist does not settle at {} ms; these keep changing: {}",
    "le câblage ne se stabilise pas à {} ms ; changent sans cesse : {}"};
inline constexpr Message<Localized> ports{"ports:\n{}", "ports :\n{}"};
inline constexpr Message<std::string_view, std::string_view, Localized> ports_do_not_fit{
    "{}: the ports do not fit {}:\n{}", "{} : les ports ne correspondent pas à {} :\n{}"};
inline constexpr Message<std::string_view> listing_has_no_input{
    "the listing has no input {}: what the stimuli say of it is left out",
    "la liste d'instructions n'a pas d'entrée {} : ce que les stimuli en disent est laissé de "
    "côté"};
inline constexpr Message<std::string_view, std::uint32_t, std::uint32_t, Localized> listing_failed{
    "at {} ms, network {}, line {}: {}", "à {} ms, réseau {}, ligne {} : {}"};
/// Cases, situations, states waiting; the same in both languages.
inline constexpr Message<Localized, Localized, Localized> progress{"{}, {}, {}", "{}, {}, {}"};

/// Of several checks: how many are done, how many there are, the name of one and how far it is.
inline constexpr Message<std::size_t, std::size_t, std::string, std::string> progress_of_several{
    "{} of {} done; {}: {}", "{} sur {} ; {} : {}"};

/// A chart from standard input leaves nothing to type there.
inline constexpr Message<> lines_share_standard_input{
    "the GRAFCET comes from standard input, so nothing can be typed there: give a STIM",
    "le GRAFCET vient de l'entrée standard, on ne peut donc rien y taper : donnez un STIM"};
inline constexpr Message<std::string> saved{"saved: {}", "enregistré : {}"};

// Memory.

/// The end of a line, which takes no memory to be made.
inline constexpr Message<> not_enough_memory{"error: there is not enough memory\n",
                                             "erreur : il n'y a pas assez de mémoire\n"};
inline constexpr Message<> check_takes_too_much_memory{
    "there is not enough memory for this check; with --max-memory it ends before that, undecided",
    "il n'y a pas assez de mémoire pour cette vérification ; avec --max-memory elle s'arrête "
    "avant, "
    "indécise"};

// Files.

inline constexpr Message<> cannot_read_standard_input{"cannot read standard input",
                                                      "impossible de lire l'entrée standard"};
inline constexpr Message<> is_a_directory{"is a directory, not a file",
                                          "c'est un dossier et non un fichier"};
inline constexpr Message<Localized> cannot_read{"cannot read the file: {}",
                                                "impossible de lire le fichier : {}"};
inline constexpr Message<Localized, Localized> cannot_write{"cannot write {}: {}",
                                                            "impossible d'écrire dans {} : {}"};
inline constexpr Message<Localized, Localized> cannot_remove{"cannot remove {}: {}",
                                                             "impossible de supprimer {} : {}"};
inline constexpr Message<Localized, Localized> cannot_remove_old{
    "cannot remove {}, which is of an earlier time: {}",
    "impossible de supprimer {}, qui date d'une fois précédente : {}"};
inline constexpr Message<> standard_output{"standard output", "la sortie standard"};
inline constexpr Message<> is_to_hold_two_results{"it is to hold two results",
                                                  "deux résultats doivent y aller"};
inline constexpr Message<> is_to_hold_a_result{"it is to hold a result",
                                               "un résultat doit y aller"};
inline constexpr Message<std::string_view> is_the_input{"it is the input {}", "c'est l'entrée {}"};
inline constexpr Message<> is_standard_input{"it is the input on standard input",
                                             "c'est le fichier lu sur l'entrée standard"};
inline constexpr Message<> is_a_folder{"it is a folder", "c'est un dossier"};
inline constexpr Message<> is_read_only{"it is read-only", "il est en lecture seule"};
inline constexpr Message<> has_hard_links{
    "it has other names (hard links), which would keep the old text; remove it first",
    "il a d'autres noms (liens physiques), qui garderaient l'ancien texte ; supprimez-le d'abord"};
inline constexpr Message<> belongs_to_others{
    "it belongs to another user or group, and a new file would not; remove it first",
    "il appartient à un autre utilisateur ou groupe, un nouveau fichier non ; supprimez-le "
    "d'abord"};
inline constexpr Message<std::string_view, Localized> no_file_in_folder{
    "no file can be made in the folder {}: {}",
    "aucun fichier ne peut être créé dans le dossier {} : {}"};

// What the system has refused, in the words of the GNU C library.

inline constexpr Message<> not_permitted{"Operation not permitted", "opération non permise"};
inline constexpr Message<> no_such_file{"No such file or directory",
                                        "aucun fichier ou dossier de ce nom"};
inline constexpr Message<> input_output_error{"Input/output error", "erreur d'entrée/sortie"};
inline constexpr Message<> no_such_address{"No such device or address",
                                           "aucun périphérique ou aucune adresse de ce nom"};
inline constexpr Message<> no_memory{"Cannot allocate memory", "mémoire insuffisante"};
inline constexpr Message<> permission_denied{"Permission denied", "permission non accordée"};
inline constexpr Message<> busy{"Device or resource busy",
                                "périphérique ou ressource déjà utilisé"};
inline constexpr Message<> file_exists{"File exists", "le fichier existe"};
inline constexpr Message<> no_such_device{"No such device", "aucun périphérique de ce type"};
inline constexpr Message<> not_a_directory{"Not a directory", "n'est pas un dossier"};
inline constexpr Message<> is_directory{"Is a directory", "est un dossier"};
inline constexpr Message<> invalid_argument{"Invalid argument", "argument invalide"};
inline constexpr Message<> too_many_in_system{"Too many open files in system",
                                              "trop de fichiers ouverts dans le système"};
inline constexpr Message<> too_many_open{"Too many open files", "trop de fichiers ouverts"};
inline constexpr Message<> text_busy{"Text file busy", "fichier exécutable en cours d'usage"};
inline constexpr Message<> too_large{"File too large", "fichier trop grand"};
inline constexpr Message<> no_space{"No space left on device",
                                    "aucun espace disponible sur le périphérique"};
inline constexpr Message<> read_only_system{"Read-only file system",
                                            "système de fichiers en lecture seule"};
inline constexpr Message<> broken_pipe{"Broken pipe", "tube cassé"};
inline constexpr Message<> name_too_long{"File name too long", "nom de fichier trop long"};
inline constexpr Message<> too_many_links{"Too many levels of symbolic links",
                                          "trop de niveaux de liens symboliques"};
inline constexpr Message<> quota_exceeded{"Disk quota exceeded", "quota d'espace disque dépassé"};
inline constexpr Message<int> other_system_error{"error {} of the system", "erreur {} du système"};

}  // namespace grafwire::messages::command
