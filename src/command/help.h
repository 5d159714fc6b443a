#pragma once

#include <string_view>

#include "text/message.h"

/// The texts of --help.
namespace grafwire::messages::help {

// The frame, and the words of CLI11.

inline constexpr Message<> program{
    "From a GRAFCET (IEC 60848) to wiring, and a proof that the wiring is right.",
    "D'un GRAFCET (CEI 60848) au câblage, avec la preuve que le câblage est juste."};
/// What the exit statuses say, from 0 on.
inline constexpr Message<> statuses[] = {
    {"done or equivalent", "fait ou équivalent"},
    {"the answer is no", "la réponse est non"},
    {"wrong request or input", "demande ou entrée erronée"},
    {"undecided", "indécis"},
};
inline constexpr Message<Localized, Localized, Localized, Localized> exit_statuses{
    "Exit status: 0 {}; 1 {}; 2 {}; 3 {}.\n'grafwire COMMAND --help' shows the options of a "
    "command.",
    "Code de retour : 0 {} ; 1 {} ; 2 {} ; 3 {}.\n« grafwire COMMANDE --help » montre les options "
    "d'une commande."};
inline constexpr Message<std::string_view> example{"Example: {}", "Exemple : {}"};
/// A row of the table of styles, formats or languages, below the option that takes its name.
inline constexpr Message<std::string_view, Localized> row{"{}: {}", "{} : {}"};
inline constexpr Message<> help{"Print this help message and exit", "afficher cette aide"};
inline constexpr Message<> version{"Display program version information and exit",
                                   "afficher la version du programme"};
inline constexpr Message<> language{"language of reports: en or fr (default: from the locale)",
                                    "langue des textes : en ou fr (par défaut : celle du système)"};
inline constexpr Message<> no_config{
    "do not read grafwire.toml, which has options that are shared",
    "ne pas lire grafwire.toml, qui contient des options partagées"};
inline constexpr Message<> usage{"Usage:", "Utilisation :"};
inline constexpr Message<> a_command{"SUBCOMMAND", "COMMANDE"};
inline constexpr Message<> commands{"Subcommands:", "Commandes :"};
inline constexpr Message<> positionals{"Positionals:", "Arguments :"};
inline constexpr Message<> options{"Options:", "Options :"};
inline constexpr Message<> required{"REQUIRED", "OBLIGATOIRE"};
// Kinds of values. They stand in a column that is as wide as their bytes: letters without accents.
inline constexpr Message<> text{"TEXT", "TEXTE"};
inline constexpr Message<> whole{"UINT", "ENTIER"};
inline constexpr Message<> number{"FLOAT", "NOMBRE"};
inline constexpr Message<> of_64_bits{"WHOLE", "POSITIF"};
inline constexpr Message<> not_negative{"NONNEGATIVE", "POSITIF"};

// The commands.

inline constexpr Message<> info{
    "check a GRAFCET; print its size, graphs, forcing hierarchy and warnings",
    "vérifier un GRAFCET ; afficher sa taille, ses grafcets partiels, sa hiérarchie de forçage et "
    "les avertissements"};
inline constexpr Message<> equations{"derive CAX, CDX, X and the equations of the actions",
                                     "établir CAX, CDX, X et les équations des actions"};
inline constexpr Message<> run{"run the reference evolution over stimuli",
                               "dérouler l'évolution de référence sous des stimuli"};
inline constexpr Message<> netlist{"make a netlist and write it in one of many formats",
                                   "faire un câblage et l'écrire dans un format parmi d'autres"};
inline constexpr Message<> simulate{"simulate the gates of a netlist over stimuli",
                                    "simuler les portes d'un câblage sous des stimuli"};
inline constexpr Message<> check{
    "prove a netlist equivalent to the reference evolution, or show a difference",
    "prouver qu'un câblage équivaut à l'évolution de référence, ou montrer un écart"};
inline constexpr Message<> draw{"draw the GRAFCET as IEC 60848 does",
                                "dessiner le GRAFCET comme le veut la norme CEI 60848"};
inline constexpr Message<> plc{
    "write the GRAFCET as a program for a PLC or in a programming language",
    "écrire le GRAFCET comme programme d'automate ou dans un langage de programmation"};
inline constexpr Message<> s7{"execute an instruction list of a Siemens S7-200",
                              "exécuter une liste d'instructions d'un Siemens S7-200"};
inline constexpr Message<> s7_run{"execute a listing over stimuli, scan by scan",
                                  "exécuter une liste d'instructions sous des stimuli, scrutation "
                                  "par scrutation"};

inline constexpr Message<> report{
    "write everything about a GRAFCET on one page of HTML: drawing, equations, verdicts",
    "réunir tout ce qu'il y a à dire d'un GRAFCET sur une page HTML : dessin, équations, verdicts"};
inline constexpr Message<> fmt{
    "write a GRAFCET in the canonical layout, with its keywords in the language of --lang",
    "mettre un GRAFCET dans sa présentation canonique, avec les mots-clés dans la langue de "
    "--lang"};

// Options of several commands.

inline constexpr Message<> file{"the GRAFCET, - for standard input",
                                "le GRAFCET, - pour l'entrée standard"};
inline constexpr Message<> files{
    "GRAFCETs: files, folders (every .grafcet below), patterns (* ? **); - for standard input",
    "des GRAFCET : fichiers, dossiers (tout .grafcet qui s'y trouve), motifs (« * », « ? », "
    "« ** ») ; - pour l'entrée standard"};
inline constexpr Message<> strict{"warnings about a GRAFCET are errors",
                                  "les avertissements sur un GRAFCET sont des erreurs"};
inline constexpr Message<> stim{"the stimuli (.stim), - for standard input",
                                "les stimuli (.stim), - pour l'entrée standard"};
inline constexpr Message<> file_name{"FILE", "FICHIER"};
/// The same in both languages.
inline constexpr Message<> stim_name{"STIM", "STIM"};
inline constexpr Message<> style{"how the equations become cells",
                                 "comment les équations deviennent des cellules"};
inline constexpr Message<> cdx_by_style{
    "form of CDX (default: successor; transition for clocked)",
    "forme de CDX (par défaut : successor ; transition pour clocked)"};
inline constexpr Message<> cdx{"form of CDX", "forme de CDX"};
inline constexpr Message<> modes{"with Init, AUdur and AUdoux, or without",
                                 "avec Init, AUdur et AUdoux, ou sans"};
inline constexpr Message<> interlock{
    "style handshake: add to the chart the interlocks that make the order of clearing immaterial",
    "style handshake : ajouter au grafcet les verrouillages qui rendent l'ordre des "
    "franchissements sans effet"};
inline constexpr Message<> delay{
    "delays of gates: unit (1 ns each); MIN..MAX in ns, as 1..2 (each change anywhere between); "
    "any (any finite time); any-wire (of every wire as well); a part family, 74HC, 74LS or 4000 "
    "(what its data sheets allow), or 74HC-typical and so on (0.4 to 1.6 times the typical)",
    "retards des portes : unit (1 ns chacune) ; MIN..MAX en ns, comme 1..2 (chaque "
    "changement entre les deux) ; any (tout retard fini) ; any-wire (de chaque fil aussi) ; une "
    "famille, 74HC, 74LS ou 4000 (ce qu'admettent ses notices), ou 74HC-typical, etc. (de 0.4 à "
    "1.6 fois le temps typique)"};
inline constexpr Message<> power_up{
    "netlists from elsewhere without Init: how their steps start: unknown (the default), or "
    "initial, taken as given",
    "câblages venus d'ailleurs sans Init : comment leurs étapes démarrent : unknown (inconnu, par "
    "défaut), ou initial, tenu pour acquis"};
inline constexpr Message<> output{"output file (default: standard output)",
                                  "fichier de sortie (par défaut : la sortie standard)"};
inline constexpr Message<> outputs{
    "output file (default: standard output); of several GRAFCETs a folder, for files called after "
    "theirs",
    "fichier de sortie (par défaut : la sortie standard) ; pour plusieurs GRAFCET un dossier, dont "
    "les fichiers portent leurs noms"};
inline constexpr Message<> trace{"the trace as CSV (default: standard output)",
                                 "le chronogramme en CSV (par défaut : la sortie standard)"};
inline constexpr Message<> trace_to{"format of the trace", "format du chronogramme"};
inline constexpr Message<> waveform{
    "the waveform for GTKWave, as FST where the file is called OUT.fst, else as VCD; beside it "
    "goes OUT.gtkw, which says what to show",
    "le chronogramme pour GTKWave, en FST si le fichier s'appelle SORTIE.fst, sinon en VCD ; à "
    "côté, SORTIE.gtkw dit quoi montrer"};

// draw

inline constexpr Message<> draw_stim{
    "the stimuli (.stim) of the run whose situation is shown, - for standard input",
    "les stimuli (.stim) de l'évolution dont la situation est montrée, - pour l'entrée standard"};
inline constexpr Message<> draw_at{
    "show the situation of the run at this moment, such as 500ms: active steps with a dot, enabled "
    "transitions with an arrow, filled where they are clearable",
    "montrer la situation à cet instant, comme 500ms : étapes actives par un point, transitions "
    "validées par une flèche, pleine si elles sont franchissables"};
inline constexpr Message<> draw_to{"format of the drawing", "format du dessin"};
inline constexpr Message<> notation{"how NOT is written: by a line over it, or by /",
                                    "écriture de la négation : barre au-dessus, ou /"};
inline constexpr Message<> paper{"what a sheet may hold; long charts take several",
                                 "taille des folios ; un long grafcet en prend plusieurs"};
inline constexpr Message<> standalone{"a whole document rather than a part of one",
                                      "un document complet, et non une partie de document"};

// report

inline constexpr Message<> report_stim{
    "the stimuli (.stim) of the run that is shown, - for standard input",
    "les stimuli (.stim) de l'évolution montrée, - pour l'entrée standard"};
inline constexpr Message<> report_style{"the style whose schematic is shown",
                                        "le style dont le schéma est montré"};
inline constexpr Message<> report_symbols{
    "gates: rectangles of IEC 60617-12, or the distinctive shapes of IEEE 91",
    "portes : rectangles de la CEI 60617-12, ou formes distinctives de l'IEEE 91"};
inline constexpr Message<> report_max_cases{
    "give up each check after so many cases (0: never); it is undecided then",
    "abandonner chaque vérification après tant de cas (0 : jamais) ; elle est alors indécise"};
inline constexpr Message<> report_max_seconds{
    "give up checking after so much time in all (0: never)",
    "abandonner les vérifications après tant de secondes en tout (0 : jamais)"};
inline constexpr Message<> report_output{
    "the page (default: standard output); the status is 0 once it is written, whatever the "
    "verdicts in it",
    "la page (par défaut : la sortie standard) ; le code est 0 dès qu'elle est écrite, quels que "
    "soient les verdicts"};

// info

inline constexpr Message<> info_to{"what is printed: a text, or the messages as SARIF",
                                   "ce qui est écrit : un texte, ou les messages en SARIF"};
inline constexpr Message<> info_output{
    "output file (default: standard output); for the texts of several GRAFCETs a folder",
    "fichier de sortie (par défaut : la sortie standard) ; pour les textes de plusieurs GRAFCET un "
    "dossier"};

// equations

inline constexpr Message<> equations_to{"output form", "forme de la sortie"};
inline constexpr Message<> karnaugh{
    "with the truth table and Karnaugh map of a step, and the minimised form of every step",
    "avec la table de vérité et le tableau de Karnaugh d'une étape, et la forme réduite de chaque "
    "étape"};
inline constexpr Message<> whole_report{
    "LaTeX: a whole document for pdflatex, not a fragment to include in one",
    "LaTeX : un document complet pour pdflatex, et non un fragment à inclure"};

// run

inline constexpr Message<> run_stim{
    "the stimuli (.stim), - for standard input; without them step by step: type help there",
    "les stimuli (.stim), - pour l'entrée standard ; sans eux pas à pas : taper aide"};
inline constexpr Message<> run_scan{
    "scan by scan with this period (default: until stable at every instant)",
    "scrutation par scrutation à cette période (par défaut : jusqu'à stabilité à chaque instant)"};

inline constexpr Message<> run_explain{
    "say in words what is cleared at each instant and why, in place of the trace (which goes where "
    "-o says)",
    "dire en toutes lettres ce qui est franchi à chaque instant et pourquoi, au lieu du "
    "chronogramme (qui va où le dit -o)"};
inline constexpr Message<> simulate_explain{
    "say in words by which gates each step and output changes at each instant, in place of the "
    "trace (which goes where -o says)",
    "dire en toutes lettres par quelles portes chaque étape et chaque sortie change à chaque "
    "instant, au lieu du chronogramme (qui va où le dit -o)"};

inline constexpr Message<> simulate_delays{
    "how long single gates take, from a .delays file: a line 'X1$set 3 5' gives the gate that "
    "drives this net 3 ns to rise and 5 ns to fall, '*' stands for every other gate, 'a->X1$set' "
    "for a wire; delays may change in time",
    "retards de certaines portes, lus dans un fichier .delays : une ligne « X1$set 3 5 » donne "
    "3 ns pour monter et 5 ns pour descendre à la porte qui commande ce fil, « * » désigne "
    "toutes les autres portes, « a->X1$set » un fil ; les retards peuvent changer avec le temps"};
inline constexpr Message<> simulate_zoom{
    "in place of the run, draw this instant of it, such as 500ms, gate by gate on a scale of "
    "nanoseconds (--to svg, wavedrom)",
    "au lieu de l'évolution, dessiner cet instant, comme 500ms, porte par porte à l'échelle de la "
    "nanoseconde (--to svg, wavedrom)"};

// netlist

inline constexpr Message<> netlist_to{"output format", "format de sortie"};
inline constexpr Message<> netlist_stim{
    "stimuli to drive the netlist with: in a SPICE deck, in a test bench (--bench), or up to the "
    "moment of a schematic (--at)",
    "stimuli à appliquer au câblage : dans une description SPICE, dans un banc d'essai (--bench), "
    "ou jusqu'à l'instant d'un schéma (--at)"};
inline constexpr Message<> netlist_at{
    "schematics: show the values of all nets at this moment, such as 500ms: 1 by a heavy line, 0 "
    "by a thin one, unknown by a dashed one",
    "schémas : montrer les valeurs de toutes les liaisons à cet instant, comme 500ms : 1 en trait "
    "fort, 0 en trait fin, inconnu en tirets"};
inline constexpr Message<> symbols{
    "schematics: rectangles of IEC 60617-12, or the distinctive shapes of IEEE 91",
    "schémas : rectangles de la CEI 60617-12, ou formes distinctives de l'IEEE 91"};
inline constexpr Message<> netlist_paper{"schematics: what a sheet may hold",
                                         "schémas : taille des folios"};
inline constexpr Message<> bench{
    "with the test bench that applies the stimuli; Verilog: OUT_bench.v beside OUT.v",
    "avec le banc d'essai qui applique les stimuli ; Verilog : SORTIE_bench.v à côté de SORTIE.v"};
inline constexpr Message<> netlist_scan{
    "scan period that clocked timers count with",
    "période de scrutation que comptent les temporisateurs synchrones"};

// simulate

inline constexpr Message<> simulate_against{
    "simulate this .blif or .json netlist instead of a generated one",
    "simuler ce câblage .blif ou .json au lieu d'en engendrer un"};
inline constexpr Message<> simulate_scan{
    "clocked style: one scan every so much time (default: until stable)",
    "style clocked : une scrutation à chaque période (par défaut : jusqu'à stabilité)"};

// check

inline constexpr Message<> check_style{
    "how the equations become cells; several as nand,rs; all: every style that can hold the "
    "GRAFCET, the others are told as skipped",
    "comment les équations deviennent des cellules ; plusieurs comme nand,rs ; all : tous les "
    "styles qui admettent le GRAFCET, les autres sont signalés et laissés de côté"};
inline constexpr Message<> check_against{
    "compare this .blif or .json (Yosys) netlist, this .awl listing (S7-200), or this .xml ladder "
    "diagram (PLCopen), instead of a generated netlist",
    "comparer ce câblage .blif ou .json (Yosys), cette liste d'instructions .awl (S7-200) ou ce "
    "schéma à contacts .xml (PLCopen), au lieu d'un câblage engendré"};
inline constexpr Message<> check_program{
    "ladder diagrams: which program of the project, where it holds several",
    "schémas à contacts : quel programme du projet, s'il en contient plusieurs"};
inline constexpr Message<> check_io{
    "listings: table of assignment, which address stands for which name",
    "listes d'instructions : table d'affectation, quelle adresse représente quel nom"};
inline constexpr Message<> changes{
    "asynchronous netlists: what changes in one instant: one input, or delays end, and the netlist "
    "settles before the next (the default); or many",
    "câblages asynchrones : ce qui change à un même instant : one, une seule entrée, ou des fins "
    "de temporisation, et le câblage se stabilise avant la suite (par défaut) ; many, plusieurs "
    "entrées"};
inline constexpr Message<> check_scan{
    "clocked netlists: the only time from one scan to the next that the verdict is for (default: "
    "every one); listings and ladder diagrams: that time (default: one that divides all delays)",
    "câblages synchrones : la seule durée d'une scrutation à l'autre pour laquelle vaut le verdict "
    "(par défaut : toutes) ; listes d'instructions et schémas à contacts : cette durée (par "
    "défaut : une qui divise toutes les temporisations)"};
inline constexpr Message<> check_cpu{"listings: the controller, 212 or 214",
                                     "listes d'instructions : l'automate, 212 ou 214"};
inline constexpr Message<> check_to{"form of the report", "forme du rapport"};
inline constexpr Message<> check_output{"file for the report (default: standard output)",
                                        "fichier du rapport (par défaut : la sortie standard)"};
inline constexpr Message<> witness{
    "folder for the stimuli, traces and waveforms that show a difference, in it one for each of "
    "several checks; those of an earlier one go",
    "dossier des stimuli et chronogrammes qui montrent un écart, avec un sous-dossier pour chacune "
    "de plusieurs vérifications ; ceux d'un écart précédent disparaissent"};
inline constexpr Message<> assume{
    "what the plant never does, besides what the file assumes: an expression that is never 0",
    "ce que la partie opérative ne fait jamais, outre ce que le fichier suppose : une expression "
    "qui ne vaut jamais 0"};
inline constexpr Message<> tolerance{
    "also find how much the delays of gates may differ (MAX/MIN) before something goes wrong, and "
    "what goes wrong first",
    "chercher aussi de combien les retards des portes peuvent différer (MAX/MIN) avant une erreur, "
    "et quelle erreur vient la première"};
inline constexpr Message<> pulses{
    "also find X and outputs that can change more often in one instant than the GRAFCET asks for, "
    "and the gates that race there; no part of the verdict",
    "chercher aussi les X et sorties qui peuvent changer plus souvent en un instant que le GRAFCET "
    "ne le demande, et les portes alors en course ; sans effet sur le verdict"};
inline constexpr Message<> shard{
    "only part K of N of all checks, by file and style; every machine that has the same files cuts "
    "them in the same way",
    "seulement la part K sur N de toutes les vérifications, par fichier et style ; toute machine "
    "qui a les mêmes fichiers les découpe de la même façon"};
inline constexpr Message<> jobs{
    "how many cores share the work; nothing but the time it takes depends on it (default: all)",
    "nombre de cœurs qui se partagent le travail ; seul le temps de calcul en dépend (par "
    "défaut : tous)"};
inline constexpr Message<> max_cases{"give up after so many cases (0: never)",
                                     "abandonner après tant de cas (0 : jamais)"};
inline constexpr Message<> max_seconds{"give up after so much time (0: never)",
                                       "abandonner après tant de secondes (0 : jamais)"};
inline constexpr Message<> max_memory{
    "give up once so much memory is held, such as 500M or 2G",
    "abandonner une fois tant de mémoire occupée, comme 500M ou 2G"};

// plc

inline constexpr Message<> plc_to{"language", "langage"};
inline constexpr Message<> plc_modes{"with Init, AUdur and AUdoux", "avec Init, AUdur et AUdoux"};
inline constexpr Message<> plc_io{"addresses of names, one a line: E0.0 = start",
                                  "adresses des noms, une par ligne : E0.0 = dcy"};
inline constexpr Message<> addresses{
    "file for the addresses of all names, in the form of --io",
    "fichier pour les adresses de tous les noms, sous la forme de --io"};
inline constexpr Message<> mnemonics{"spelling of instructions", "mnémoniques des instructions"};
inline constexpr Message<> offsets{"byte offsets before instructions",
                                   "adresses en octets devant les instructions"};
inline constexpr Message<> tables{"80 steps, or as many as the chart has",
                                  "80 étapes, ou autant que le GRAFCET en a"};
inline constexpr Message<> plc_cpu{"controller whose memory has to hold the program",
                                   "automate dont la mémoire doit contenir le programme"};
inline constexpr Message<> pull_up{
    "inputs are contacts to ground, with the pull-up resistors of the board: closed is 1",
    "les entrées sont des contacts vers la masse, avec les résistances de tirage de la carte : "
    "fermé vaut 1"};

// s7 run

inline constexpr Message<> listing_name{"LISTING", "LISTE"};
inline constexpr Message<> listing{"the instruction list (.awl), - for standard input",
                                   "la liste d'instructions (.awl), - pour l'entrée standard"};
inline constexpr Message<> s7_stim{"the stimuli (.stim)", "les stimuli (.stim)"};
inline constexpr Message<> s7_scan{"the time from one scan to the next, such as 10ms",
                                   "la durée d'une scrutation à l'autre, comme 10ms"};
inline constexpr Message<> s7_io{
    "table of assignment: which address stands for which name (default: names are the addresses)",
    "table d'affectation : quelle adresse représente quel nom (par défaut : les noms sont les "
    "adresses)"};
inline constexpr Message<> s7_cpu{"the controller: 212 or 214", "l'automate : 212 ou 214"};
inline constexpr Message<> s7_grafcet{
    "the GRAFCET whose columns the trace shall have; needs --io",
    "le GRAFCET dont le chronogramme aura les colonnes ; demande --io"};

// fmt

inline constexpr Message<> fmt_files{
    "the GRAFCET, - for standard input; several, folders (every .grafcet below) and patterns (* ? "
    "**) with -i or --check",
    "le GRAFCET, - pour l'entrée standard ; plusieurs, dossiers (tout .grafcet qui s'y trouve) et "
    "motifs (« * », « ? », « ** ») avec -i ou --check"};
inline constexpr Message<> in_place{"replace the files that are laid out otherwise",
                                    "remplacer les fichiers présentés autrement"};
inline constexpr Message<> fmt_interlock{
    "add the interlocks that make the order of clearing immaterial (style handshake)",
    "ajouter les verrouillages qui rendent l'ordre des franchissements sans effet (style "
    "handshake)"};
inline constexpr Message<> fmt_check{
    "write nothing; list the files that are laid out otherwise, with status 1 if there are any",
    "ne rien écrire ; lister les fichiers présentés autrement, avec le code 1 s'il y en a"};

}  // namespace grafwire::messages::help
