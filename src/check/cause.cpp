#include "check/cause.h"

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
     "l'autre est aussi celle qui la désactive, et le jeton ne survit que si les retards des portes "
     "s'y prêtent.",
     "Put a step between the two, or use --cdx transition or the clocked style.",
     "Insérer une étape entre les deux, ou choisir --cdx transition ou le style synchrone (clocked)."},
    {CauseKind::two_tokens, "two-tokens",
     "{0} is reset by a second token: {1} is active already, and in the successor form of CDX that "
     "resets {0} although transition ({2}) has not been cleared.",
     "{0} est désactivée par un second jeton : {1} est déjà active et, dans la forme « successeur » "
     "de CDX, cela désactive {0} sans que la transition ({2}) soit franchie.",
     "Use --cdx transition, or the clocked style.",
     "Choisir --cdx transition ou le style synchrone (clocked)."},
    {CauseKind::long_pulse, "long-pulse",
     "The pulse of {1} outlives the passage through {0}: it clears transition ({2}) and then "
     "({3}) as well, which reads the same edge.",
     "L'impulsion de {1} dure plus longtemps que le passage par {0} : elle franchit la transition "
     "({2}), puis aussi ({3}), qui lit le même front.",
     "Let a step between the two wait for the input to fall, make the pulse shorter, or use the "
     "clocked style.",
     "Insérer une étape qui attend la retombée de l'entrée, raccourcir l'impulsion, ou choisir le "
     "style synchrone (clocked)."},
    {CauseKind::reset_priority, "reset-priority",
     "CAX and CDX of {0} are 1 together, and in this memory deactivation wins. By rule 5 of GRAFCET "
     "the step stays active.",
     "CAX et CDX de {0} valent 1 ensemble, et dans cette mémoire la désactivation l'emporte. "
     "D'après la règle 5 du GRAFCET, l'étape reste active.",
     "Use a memory in which activation wins (styles nand and gates).",
     "Choisir une mémoire à activation prioritaire (styles nand et gates)."},
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
     "par assume ; écrire dans chaque réceptivité ce qui exclut l'autre (a./b et b./a) ; ou choisir "
     "le style synchrone (clocked)."},
};

const CauseRow& row_of(CauseKind kind) {
    for (const CauseRow& row : rows) {
        if (row.kind == kind) return row;
    }
    return rows[0];
}

}  // namespace

std::string_view identifier_of(CauseKind kind) {
    return row_of(kind).identifier;
}

std::string cause_text(const Cause& cause, Language language) {
    const CauseRow& row = row_of(cause.kind);
    const bool french = language == Language::french;
    std::string others;
    for (std::size_t i = 0; i < cause.others.size(); ++i) {
        if (i != 0) others += i + 1 == cause.others.size() ? (french ? " et " : " and ") : ", ";
        others += cause.others[i];
    }
    const auto transition = [&](std::size_t i) {
        return i < cause.transitions.size() ? cause.transitions[i] : std::string();
    };
    return fmt::format(fmt::runtime(french ? row.french : row.english), cause.step, others,
                       transition(0), transition(1));
}

std::string remedy_text(const Cause& cause, Language language) {
    const CauseRow& row = row_of(cause.kind);
    return std::string(language == Language::french ? row.french_remedy : row.english_remedy);
}

}  // namespace grafwire
