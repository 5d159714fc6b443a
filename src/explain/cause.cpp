#include "explain/cause.h"

#include <fmt/format.h>

namespace grafwire {

namespace {

struct CauseRow {
    CauseKind kind;
    std::string_view identifier;
    /// {0}: the step, {1}: the others, {2} and {3}: the transitions.
    std::string_view english;
    std::string_view french;
    std::string_view english_remedy;
    std::string_view french_remedy;
};

constexpr CauseRow rows[] = {
    {CauseKind::two_step_loop, "two-step-loop",
     "{0} and {1} follow each other. In the successor form of CDX the very step from which another "
     "is set also resets it, and whether the token survives depends on the delays of the gates.",
     "{0} et {1} se suivent l'une l'autre. Dans la forme « successeur » de CDX, l'étape qui active "
     "l'autre est aussi celle qui la désactive, et le jeton ne survit que si les retards des "
     "portes "
     "s'y prêtent.",
     "Put a step between the two; or use style nand, which blocks the reset while a memory is "
     "being "
     "set, or the clocked style.",
     "Insérer une étape entre les deux ; ou choisir le style nand, qui bloque la désactivation "
     "pendant l'activation, ou le style synchrone (clocked)."},
    {CauseKind::two_tokens, "two-tokens",
     "{0} is reset by a second token: {1} is active already, and in the successor form of CDX that "
     "resets {0} although transition ({2}) has not been cleared.",
     "{0} est désactivée par un second jeton : {1} est déjà active et, dans la forme « successeur "
     "» "
     "de CDX, cela désactive {0} sans que la transition ({2}) soit franchie.",
     "Use --cdx transition with latches (style nand), or the clocked style.",
     "Choisir --cdx transition avec des bascules (style nand), ou le style synchrone (clocked)."},
    {CauseKind::long_pulse, "long-pulse",
     "The pulse of {1} outlives the passage through {0}: it is still 1 when transition ({2}) has "
     "activated {0}, and clears ({3}) as well.",
     "L'impulsion de {1} dure plus longtemps que le passage par {0} : elle vaut encore 1 quand la "
     "transition ({2}) a activé {0}, et fait franchir aussi ({3}).",
     "Let a step between the two wait for the input to fall, make the pulse shorter, or use the "
     "clocked style.",
     "Insérer une étape qui attend la retombée de l'entrée, raccourcir l'impulsion, ou choisir le "
     "style synchrone (clocked)."},
    {CauseKind::fleeting_follower, "fleeting-follower",
     "{1}, which should reset {0}, is active only for as long as CAX of {0} is still 1, and has "
     "gone on before the reset could act.",
     "{1}, qui doit désactiver {0}, n'est active que pendant que CAX de {0} vaut encore 1 : elle "
     "est déjà quittée quand la désactivation pourrait agir.",
     "Let {1} last (a condition in place of one that is 1 at once), or use the clocked style.",
     "Faire durer {1} (une réceptivité qui n'est pas aussitôt vraie), ou choisir le style "
     "synchrone "
     "(clocked)."},
    {CauseKind::reset_priority, "reset-priority",
     "CAX and CDX of {0} are 1 together, and in this memory deactivation wins. By rule 5 of "
     "GRAFCET "
     "the step stays active.",
     "CAX et CDX de {0} valent 1 ensemble, et dans cette mémoire la désactivation l'emporte. "
     "D'après la règle 5 du GRAFCET, l'étape reste active.",
     "Use a memory in which activation wins (style nand).",
     "Choisir une mémoire à activation prioritaire (style nand)."},
    {CauseKind::set_and_reset, "set-and-reset",
     "CAX and CDX of {0} are 1 together and fall together. The gates of its memory are then let go "
     "at the same moment, and which state it falls into depends on their delays.",
     "CAX et CDX de {0} valent 1 ensemble et retombent ensemble. Les portes de sa mémoire sont "
     "alors relâchées au même instant, et l'état qu'elle prend dépend de leurs retards.",
     "Block the reset while the memory is being set (style nand), or use the clocked style.",
     "Bloquer la désactivation pendant l'activation (style nand), ou choisir le style synchrone "
     "(clocked)."},
    {CauseKind::input_race, "input-race",
     "A race of inputs: {1} change in one instant and are read together. Changed one after the "
     "other, in any order, they do no harm.",
     "Course entre entrées : {1} changent au même instant et sont lues ensemble. Changées l'une "
     "après l'autre, dans n'importe quel ordre, elles sont sans effet fâcheux.",
     "Let one input change at a time; if the plant never has them together, say so with assume; "
     "write out what excludes the other in each condition (a./b and b./a); or use the clocked "
     "style.",
     "Ne changer qu'une entrée à la fois ; si l'installation ne les donne jamais ensemble, le dire "
     "par assume ; écrire dans chaque réceptivité ce qui exclut l'autre (a./b et b./a) ; ou "
     "choisir "
     "le style synchrone (clocked)."},
};

const CauseRow& row_of(CauseKind kind) {
    for (const CauseRow& row : rows) {
        if (row.kind == kind) return row;
    }
    return rows[0];
}

/// A sentence with its names.
std::string filled(std::string_view sentence, const Cause& cause, Language language) {
    const std::string_view last = language == Language::french ? " et " : " and ";
    std::string others;
    for (std::size_t i = 0; i < cause.others.size(); ++i) {
        if (i != 0) others += i + 1 == cause.others.size() ? last : ", ";
        others += cause.others[i];
    }
    const auto transition = [&](std::size_t i) {
        return i < cause.transitions.size() ? cause.transitions[i] : std::string();
    };
    return fmt::format(fmt::runtime(sentence), cause.step, others, transition(0), transition(1));
}

}  // namespace

std::string_view identifier_of(CauseKind kind) {
    return row_of(kind).identifier;
}

std::string cause_text(const Cause& cause, Language language) {
    const CauseRow& row = row_of(cause.kind);
    return filled(language == Language::french ? row.french : row.english, cause, language);
}

std::string remedy_text(const Cause& cause, Language language) {
    const CauseRow& row = row_of(cause.kind);
    return filled(language == Language::french ? row.french_remedy : row.english_remedy, cause,
                  language);
}

}  // namespace grafwire
