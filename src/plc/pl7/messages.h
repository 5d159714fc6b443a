#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::plc_pl7 {

inline constexpr Message<> integer_too_wide{
    "an integer needs more than the 16 bits of a word of PL7-2; make the range of the counter "
    "smaller",
    "un entier demande plus que les 16 bits d'un mot de PL7-2 ; réduisez la plage du compteur"};
inline constexpr Message<Localized> no_timer_holds{
    "no timer of PL7-2 holds {}: it counts up to 9999 times 10 ms, 100 ms, 1 s or 1 min; choose "
    "another time",
    "aucun temporisateur de PL7-2 ne contient {} : il compte jusqu'à 9999 fois 10 ms, 100 ms, "
    "1 s ou 1 min ; choisissez une autre durée"};

// What the program needs, and what there is of it.
inline constexpr Message<Localized, std::size_t> needs_too_many{
    "the program needs {}, and PL7-2 has {}; divide the GRAFCET",
    "le programme demande {}, et PL7-2 en a {} ; partagez le GRAFCET"};

// The head of a listing.
inline constexpr Message<> what_it_is{
    "A GRAFCET (IEC 60848) for Telemecanique TSX 17-20, TSX 27 and TSX 47.",
    "GRAFCET (CEI 60848) pour Telemecanique TSX 17-20, TSX 27 et TSX 47."};
inline constexpr Message<> conventions{
    "Conventions of this listing: the program is entered with its charts and rungs drawn.\n"
    "   ** LABEL 3         a rung, or several; contacts in series are joined by . and in parallel "
    "by +,\n"
    "                      /I0,1 is a contact that is closed while the bit is 0, =1 is a wire, =0 "
    "none\n"
    "   --( ) --(S) --(R)  a coil; --(#) ends the rung of a transition\n"
    "   [W0 < 5]           a COMPAR block; --[W0 + 1 -> W0] an OPERATE block\n"
    "   --T0 TB=1s P=3     a timer block, E and C both driven by the rung; T0,D is 1 once 3 s are "
    "over\n"
    "   SY0                1 in the first scan after a cold start; the chart is initialised before "
    "it\n"
    "   SY21, SY22, SY23   1 in the preliminary processing: in this scan the chart is initialised, "
    "has no\n"
    "                      step, or keeps the steps that were set and reset there, and does not "
    "evolve\n",
    "Conventions de cette liste : le programme se saisit sous forme graphique, GRAFCET et réseaux "
    "de contacts.\n"
    "   ** LABEL 3         un ou plusieurs réseaux ; . relie les contacts en série, + ceux en "
    "parallèle,\n"
    "                      /I0,1 est un contact fermé quand le bit est à 0, =1 un fil, =0 pas de "
    "fil\n"
    "   --( ) --(S) --(R)  une bobine ; --(#) termine le réseau d'une transition\n"
    "   [W0 < 5]           un bloc COMPAR ; --[W0 + 1 -> W0] un bloc OPERATE\n"
    "   --T0 TB=1s P=3     un bloc temporisateur, E et C pilotées par le réseau ; T0,D vaut 1 "
    "après 3 s\n"
    "   SY0                1 à la première scrutation après un démarrage à froid, GRAFCET déjà "
    "initialisé\n"
    "   SY21, SY22, SY23   1 en traitement préliminaire : dans cette scrutation le GRAFCET est "
    "initialisé,\n"
    "                      n'a aucune étape active, ou garde celles mises à 1 et à 0 là, sans "
    "évoluer\n"};
inline constexpr Message<> source_convention{
    "   always active      a step of this listing alone; a source transition leaves and enters "
    "it\n",
    "   toujours active    étape propre à cette liste ; une transition source en part et y "
    "revient\n"};
inline constexpr Message<> sink_convention{
    "   sink               a step of this listing alone, where sink transitions lead\n",
    "   puits              étape propre à cette liste, où mènent les transitions puits\n"};

// Headings.
inline constexpr Message<> assignment{"ASSIGNMENT", "AFFECTATION"};
inline constexpr Message<> preliminary{"PRELIMINARY PROCESSING", "TRAITEMENT PRÉLIMINAIRE"};
inline constexpr Message<> sequential{"SEQUENTIAL PROCESSING", "TRAITEMENT SÉQUENTIEL"};
inline constexpr Message<> posterior{"POSTERIOR PROCESSING", "TRAITEMENT POSTÉRIEUR"};

// What rungs and steps are for.
inline constexpr Message<> source_step{"always active, for source transitions",
                                       "toujours active, pour les transitions sources"};
inline constexpr Message<> sink_step{"sink, for sink transitions",
                                     "puits, pour les transitions puits"};
inline constexpr Message<Localized> cold_start{"cold start: {}", "démarrage à froid : {}"};
inline constexpr Message<std::string> step_before{"X{} as the scan begins",
                                                  "X{} en début de scrutation"};
inline constexpr Message<Localized> transition_condition{"transition condition of {}",
                                                         "réceptivité de {}"};
inline constexpr Message<Localized> sums{"sums of {}", "sommes de {}"};
inline constexpr Message<Localized> parts{"parts of {}", "parties de {}"};
inline constexpr Message<> au_dur{"AUdur: no step active", "AUdur : aucune étape active"};
inline constexpr Message<> init{"Init: initial situation", "Init : situation initiale"};
inline constexpr Message<> presetting{"SY23: no step active", "SY23 : aucune étape active"};
inline constexpr Message<std::string> step_to_be_active{"step {} is to be active, before any order",
                                                        "étape {} à activer, avant tout forçage"};
inline constexpr Message<std::string> forcing_orders{"forcing orders on {}",
                                                     "ordres de forçage sur {}"};
inline constexpr Message<std::string> presetting_of{"presetting of step {}",
                                                    "prépositionnement de l'étape {}"};

}  // namespace grafwire::messages::plc_pl7
