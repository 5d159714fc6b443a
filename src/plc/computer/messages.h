#pragma once

#include <cstddef>
#include <string>
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
/// Of more than one.
inline constexpr Message<std::size_t, std::size_t> too_many_pins{
    "{} inputs and outputs need a pin each, and the largest board, an Arduino Mega 2560, has {}; "
    "write --to c and connect them by yourself",
    "{} entrées et sorties demandent une broche chacune, et la plus grande carte, une Arduino "
    "Mega 2560, en a {} ; écrivez --to c et raccordez-les vous-même"};
/// Of more than one.
inline constexpr Message<std::size_t, std::size_t> too_many_pins_with_modes{
    "{} inputs and outputs need a pin each, and the largest board, an Arduino Mega 2560, has {}; "
    "write --to c and connect them by yourself, or --modes off to save three",
    "{} entrées et sorties demandent une broche chacune, et la plus grande carte, une Arduino "
    "Mega 2560, en a {} ; écrivez --to c et raccordez-les vous-même, ou --modes off pour en "
    "économiser trois"};

// The head of a file. A text of several lines is a comment of as many.
inline constexpr Message<> program_in_c{"a program in C99", "programme en C99"};
inline constexpr Message<> sketch{"a sketch for Arduino boards", "croquis pour cartes Arduino"};
inline constexpr Message<> program_in_pascal{"a program in Free Pascal",
                                             "programme en Free Pascal"};
inline constexpr Message<> program_in_python{"a program in Python 3", "programme en Python 3"};
inline constexpr Message<Localized> what_it_is{
    "A GRAFCET (IEC 60848) as {}. A scan is one\n"
    "of the table method (Cordier, \"Méthode d'implémentation du GRAFCET\", 1998); each of\n"
    "its parts says which subroutine of the method it is, SBR 0 to SBR 8.",
    "GRAFCET (CEI 60848), {}. Une scrutation est\n"
    "celle de la méthode des tables (Cordier, « Méthode d'implémentation du GRAFCET », 1998) ;\n"
    "chaque partie dit de quel sous-programme de la méthode il s'agit, SBR 0 à SBR 8."};
inline constexpr Message<> changed_names{"Names that are spelt differently in the GRAFCET:",
                                         "Noms écrits autrement dans le GRAFCET :"};
inline constexpr Message<> include_where_called{
    "Include this file where the scan is called:",
    "Inclure ce fichier là où la scrutation est appelée :"};
inline constexpr Message<> fill_in_inputs{"fill in the inputs", "y mettre les entrées"};
inline constexpr Message<> once{"once", "une fois"};
inline constexpr Message<> over_and_over{"over and over; now: a clock in us",
                                         "en boucle ; now : une horloge en us"};
inline constexpr Message<> are_outputs{"are the outputs", "sont les sorties"};
inline constexpr Message<> how_to_use_python{
    "To use it:\n"
    "  inputs = Inputs(...)       those that are not named are False\n"
    "  chart = Grafcet(inputs)\n"
    "  chart.scan(inputs, now)    over and over; now: a clock in us\n"
    "  chart.outputs",
    "Pour l'utiliser :\n"
    "  inputs = Inputs(...)       celles qui ne sont pas nommées valent False\n"
    "  chart = Grafcet(inputs)\n"
    "  chart.scan(inputs, now)    en boucle ; now : une horloge en us\n"
    "  chart.outputs"};
inline constexpr Message<> how_to_try_c{
    "To try it on scans from a trace of the reference:\n"
    "  cc -std=c99 -DGRAFWIRE_MAIN THIS_FILE -o program\n"
    "  grafwire run CHART STIMULI --scan 10ms -o trace.csv\n"
    "  ./program < trace.csv | diff - trace.csv",
    "Pour l'essayer sur les scrutations d'une trace de la référence :\n"
    "  cc -std=c99 -DGRAFWIRE_MAIN CE_FICHIER -o programme\n"
    "  grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv\n"
    "  ./programme < trace.csv | diff - trace.csv"};
inline constexpr Message<> how_to_try_pascal{
    "To try it on scans from a trace of the reference:\n"
    "  fpc THIS_FILE -oprogram\n"
    "  grafwire run CHART STIMULI --scan 10ms -o trace.csv\n"
    "  ./program < trace.csv | diff - trace.csv",
    "Pour l'essayer sur les scrutations d'une trace de la référence :\n"
    "  fpc CE_FICHIER -oprogramme\n"
    "  grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv\n"
    "  ./programme < trace.csv | diff - trace.csv"};
inline constexpr Message<> how_to_try_python{
    "To try it on scans from a trace of the reference:\n"
    "  grafwire run CHART STIMULI --scan 10ms -o trace.csv\n"
    "  python3 THIS_FILE < trace.csv | diff - trace.csv",
    "Pour l'essayer sur les scrutations d'une trace de la référence :\n"
    "  grafwire run GRAFCET STIMULI --scan 10ms -o trace.csv\n"
    "  python3 CE_FICHIER < trace.csv | diff - trace.csv"};

// Types and variables.
inline constexpr Message<> steps_in_order{"The steps, in the order of the tables.",
                                          "Les étapes, dans l'ordre des tables."};
inline constexpr Message<> steps_as_bits{"The steps, as bits of the tables.",
                                         "Les étapes, comme bits des tables."};
inline constexpr Message<> init{"1: the initial situation", "1 : situation initiale"};
inline constexpr Message<> au_dur{"1: no step is active", "1 : aucune étape active"};
inline constexpr Message<> au_doux{"1: continuous actions are off, the steps stay",
                                   "1 : actions continues à 0, étapes conservées"};
inline constexpr Message<> state{"All that one scan hands to the next.",
                                 "Tout ce qu'une scrutation transmet à la suivante."};
inline constexpr Message<> moment_of_scan{"the moment of the scan, in us",
                                          "instant de la scrutation, en us"};
inline constexpr Message<> step_tables{"Tables of the steps, one bit each.",
                                       "Tables des étapes, un bit par étape."};
inline constexpr Message<> situation{"the situation", "situation"};
inline constexpr Message<> situation_before{"the situation that the scan began with",
                                            "situation en début de scrutation"};
inline constexpr Message<> to_activate{"to activate, to deactivate", "à activer, à désactiver"};
inline constexpr Message<> forced{"forced to 1, forced to 0", "forcées à 1, forcées à 0"};
inline constexpr Message<> just_activated{"activated in this scan",
                                          "activées dans cette scrutation"};
inline constexpr Message<> inputs{"Inputs.", "Entrées."};
inline constexpr Message<> outputs{"Outputs.", "Sorties."};
inline constexpr Message<> transition_conditions{"The conditions of the transitions.",
                                                 "Réceptivités des transitions."};
inline constexpr Message<> graphs_0_frozen{"Whether a graph may evolve; 0: frozen.",
                                           "Grafcets partiels : peut évoluer ; 0 : figé."};
inline constexpr Message<> graphs_false_frozen{"Whether a graph may evolve; False: frozen.",
                                               "Grafcets partiels : peut évoluer ; False : figé."};
inline constexpr Message<> edges_1{"Edges, 1 in the scan in which they occur.",
                                   "Fronts, à 1 dans la scrutation où ils se produisent."};
inline constexpr Message<> edges_true{"Edges, True in the scan in which they occur.",
                                      "Fronts, True dans la scrutation où ils se produisent."};
inline constexpr Message<> edge_memories{
    "What the operands of edges were in the scan before.",
    "Valeurs des opérandes des fronts à la scrutation précédente."};
inline constexpr Message<> time_conditions{"Time conditions.", "Temporisations."};
inline constexpr Message<> vars{"Internal variables.", "Variables internes."};
inline constexpr Message<> counters{"Counters.", "Compteurs."};
inline constexpr Message<> pins{"The pins: change them to suit the wiring.",
                                "Les broches : à adapter au câblage."};
inline constexpr Message<> inputs_driven{
    "An input is 1 where its pin is HIGH. A contact to 5 V needs a resistor to ground: a pin that\n"
    "is left open is read as anything (--pull-up: contacts to ground, without resistors).",
    "Une entrée vaut 1 quand sa broche est HIGH. Un contact vers le 5 V demande une résistance\n"
    "vers la masse : une broche en l'air donne une valeur quelconque (--pull-up : contacts vers\n"
    "la masse, sans résistance)."};
inline constexpr Message<> inputs_pulled_up{
    "An input is a contact from its pin to ground, with the pull-up resistor of the board: closed\n"
    "is 1, open is 0. A pin that nothing is wired to is 0.",
    "Une entrée est un contact entre sa broche et la masse, avec la résistance de tirage de la\n"
    "carte : fermé vaut 1, ouvert vaut 0. Une broche en l'air vaut 0."};
inline constexpr Message<> modes_pulled_up{
    "Init, AUdur and AUdoux are contacts to ground, with the pull-up resistors of the board: left\n"
    "open they are 0, and the chart runs.",
    "Init, AUdur et AUdoux sont des contacts vers la masse, avec les résistances de tirage de la\n"
    "carte : non raccordés, ils valent 0 et le GRAFCET évolue."};
inline constexpr Message<> until_charged{
    "Until the pull-up resistors have charged the wires.",
    "Le temps que les résistances de tirage chargent les fils."};
inline constexpr Message<> all_input_columns{"Init, AUdur and AUdoux included",
                                             "avec Init, AUdur et AUdoux"};
inline constexpr Message<> input_columns{
    "The columns of inputs; Init, AUdur and AUdoux are always there.",
    "Les colonnes des entrées ; Init, AUdur et AUdoux y sont toujours."};

// Functions.
inline constexpr Message<> one_scan_clocked{"One scan. The clock, in us, never goes back.",
                                            "Une scrutation. L'horloge, en us, ne recule jamais."};
inline constexpr Message<> one_scan{"One scan.", "Une scrutation."};
inline constexpr Message<> time_condition_1{
    "A time condition t1/e/t2: 1 once e has been 1 for t1, 0 once it has been 0 for t2.",
    "Temporisation t1/e/t2 : 1 quand e vaut 1 depuis t1, 0 quand e vaut 0 depuis t2."};
inline constexpr Message<> time_condition_true{
    "A time condition t1/e/t2: True once e has been True for t1, False once it has been False for "
    "t2.",
    "Temporisation t1/e/t2 : True quand e est True depuis t1, False quand e est False depuis t2."};
inline constexpr Message<> time_class{
    "t1/e/t2: True once e has been True for t1, False once it has been False for t2.",
    "t1/e/t2 : True quand e est True depuis t1, False quand e est False depuis t2."};
inline constexpr Message<> e_differs{"e differs from the value", "e diffère de la valeur"};
inline constexpr Message<> differs_since{
    "while it waits: the moment since which e differs, in us",
    "pendant l'attente : l'instant depuis lequel e diffère, en us"};
inline constexpr Message<> differs_since_alone{"the moment since which e differs from the value",
                                               "instant depuis lequel e diffère de la valeur"};
inline constexpr Message<> steps_through{
    "The steps from first to last, both included, as one table.",
    "Les étapes de first à last, l'une et l'autre comprises, en une table."};
inline constexpr Message<> unending_clock{
    "micros() starts again at 0 after 71 minutes; this clock does not, if it is read more often.",
    "micros() repart de 0 après 71 minutes ; cette horloge non, si elle est lue plus souvent."};

// Reading scans and writing the trace.
inline constexpr Message<> reads_moment{
    "Reads a moment in ms, as `0.5`, into us. Whether it is one, and whole in us.",
    "Lit un instant en ms, comme `0.5`, et le donne en us. Vrai si c'en est un, entier en us."};
inline constexpr Message<> from_ms{"From ms, as `0.5`, to us.", "De ms, comme `0.5`, en us."};
inline constexpr Message<> moment_from_ms{"A moment in us, from one in ms as `0.5`.",
                                          "Un instant en us, à partir de ms comme `0.5`."};
inline constexpr Message<> in_the_line{"in the line", "dans la ligne"};
inline constexpr Message<> reads_scans_in_c{
    "Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and\n"
    "further columns, are passed over. Writes the trace in the columns of the reference.",
    "Lit une ligne par scrutation : l'instant en ms, les entrées à 0 ou 1. La première ligne et\n"
    "les colonnes en plus sont ignorées. Écrit la trace dans les colonnes de la référence."};
inline constexpr Message<> reads_scans_in_python{
    "Reads a line per scan: the moment in ms, the inputs as 0 or 1. The first line, and further\n"
    "columns, are passed over. Writes the trace in the columns of the reference.",
    "Lit une ligne par scrutation : l'instant en ms, les entrées à 0 ou 1. La première ligne et\n"
    "les colonnes en plus sont ignorées. Écrit la trace dans les colonnes de la référence."};
inline constexpr Message<> reads_scans_in_pascal{
    "From here on: scans read from standard input, a line each, with the moment in ms and the "
    "inputs as\n"
    "0 or 1 (the first line, and further columns, are passed over); the trace goes to standard "
    "output in\n"
    "the columns of the reference. In a machine, read its inputs and its clock instead.",
    "À partir d'ici : lecture des scrutations sur l'entrée standard, une par ligne, avec l'instant "
    "en\n"
    "ms et les entrées à 0 ou 1 (la première ligne et les colonnes en plus sont ignorées) ; la "
    "trace\n"
    "sort sur la sortie standard, dans les colonnes de la référence. Sur une machine, lire plutôt\n"
    "ses entrées et son horloge."};
/// What a program says of a wrong line; its number and the number of inputs, as the language puts
/// them into a text.
inline constexpr Message<std::string, std::string> bad_line{
    "line {}: expected a moment in ms, whole in us, and {} inputs",
    "ligne {} : instant en ms attendu (entier en us), puis {} entrées"};

}  // namespace grafwire::messages::plc_computer
