// The end of a witness in words: what changed outside, what the reference made of it scan by scan,
// and then backwards from what differs: the equations with the values that decide, the causal chain
// through the gates, and the cause with what helps, where it is a known one.

#include "explain/write_explanation.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/explanation_writer.h"

namespace grafwire {

namespace {

using Fault = Explanation::Fault;
using EquationPair = Explanation::EquationPair;
using Part = Explanation::Part;

constexpr std::size_t most_oscillating = 12;

class ExplanationText {
  public:
    ExplanationText(const Grafcet& grafcet, const Netlist& netlist, const Witness& witness,
                    const Explanation& explanation, const ExplanationOptions& options)
        : netlist_(netlist),
          witness_(witness),
          explanation_(explanation),
          options_(options),
          language_(options.language),
          writer_(grafcet, witness, options.language) {}

    std::string make() {
        writer_.explain_changes();
        writer_.explain_reference();
        write_parts();
        write_chain();
        write_oscillation();
        write_cause();
        return writer_.take();
    }

  private:
    std::string_view localized(std::string_view english, std::string_view french) const {
        return writer_.localized(english, french);
    }
    std::string_view colon() const { return localized(":", " :"); }

    void write_parts() {
        if (explanation_.parts.empty()) return;
        writer_.add(witness_.kind == DifferenceKind::oscillation
                        ? localized("What keeps changing:\n", "Ce qui change sans cesse :\n")
                        : localized("Where they part:\n", "Où ils se séparent :\n"));
        for (const Part& part : explanation_.parts) write_part(part);
    }

    void write_part(const Part& part) {
        if (witness_.kind == DifferenceKind::oscillation) {
            writer_.add(fmt::format("  {}{} {} {}\n", part.name, colon(),
                                    localized("the reference gives", "la référence donne"),
                                    digit_of(part.expected)));
        } else {
            writer_.add(fmt::format("  {}{} {} {}, {} {}\n", part.name, colon(),
                                    localized("the reference gives", "la référence donne"),
                                    digit_of(part.expected), localized("the netlist", "le câblage"),
                                    digit_of(part.got)));
        }
        if (!part.follows_from.empty()) {
            writer_.add(fmt::format("    {} {}\n",
                                    localized("that follows from", "cela découle de"),
                                    fmt::join(part.follows_from, ", ")));
            return;
        }
        for (const EquationPair& pair : part.equations) write_equation(part, pair);
        write_fault(part);
    }

    void write_equation(const Part& part, const EquationPair& pair) {
        std::string line = fmt::format("    {} = {}", pair.name, pair.expected);
        std::vector<std::string> values;
        for (const Explanation::Operand& operand : pair.operands) {
            values.push_back(fmt::format("{}={}", operand.name, digit_of(operand.value)));
        }
        if (!values.empty()) {
            line += fmt::format("   {} {}", localized("with", "avec"), fmt::join(values, " "));
        }
        writer_.add(line + "\n");
        if (part.fault == Fault::unread) return;
        if (pair.is_same) return;
        line = pair.got.empty()
                   ? std::string(localized("    in the netlist another one",
                                           "    dans le câblage, une autre"))
                   : fmt::format("    {} {} = {}", localized("in the netlist", "dans le câblage"),
                                 pair.name, pair.got);
        if (!pair.missing.empty()) {
            line += fmt::format("{} {}", localized("; it has no", " ; il y manque"),
                                fmt::join(pair.missing, ", "));
        }
        if (!pair.extra.empty()) {
            line += fmt::format("{} {}",
                                localized("; it should not have", " ; n'y ont pas leur place :"),
                                fmt::join(pair.extra, ", "));
        }
        writer_.add(line + "\n");
    }

    void write_fault(const Part& part) {
        switch (part.fault) {
            case Fault::no_fault:
                if (!part.equations.empty()) {
                    writer_.add(localized(
                        "    its gates have the same equations: it is a matter of delays\n",
                        "    ses portes ont les mêmes équations : c'est une question de "
                        "retards\n"));
                }
                break;
            case Fault::priority:
                writer_.add(
                    localized("    its gates have the same, but where CAX and CDX are both 1 "
                              "deactivation wins\n",
                              "    ses portes ont les mêmes, mais là où CAX et CDX valent 1 "
                              "la désactivation l'emporte\n"));
                break;
            case Fault::unread:
                writer_.add(
                    localized("    what the gates make of it cannot be compared; they read",
                              "    ce qu'en font les portes ne se compare pas ; elles lisent"));
                for (const Explanation::Operand& operand : part.reads) {
                    writer_.add(fmt::format(" {}={}", operand.name, digit_of(operand.value)));
                }
                writer_.add("\n");
                break;
            case Fault::equation:
            case Fault::order:
                break;
        }
        if (part.decided_at) {
            writer_.add(fmt::format("    {} {}\n",
                                    localized("it is decided at", "cela se décide à"),
                                    time_text(*part.decided_at)));
        }
        if (!part.lines.empty()) {
            const std::string place = options_.source.empty() ? "" : options_.source + ", ";
            writer_.add(fmt::format(
                "    {} {}{} {}\n", localized("its gates:", "ses portes :"), place,
                part.lines.size() == 1 ? localized("line", "ligne") : localized("lines", "lignes"),
                ranges(part.lines)));
        }
    }

    /// `3, 7-9`.
    static std::string ranges(const std::vector<std::uint32_t>& lines) {
        std::string text;
        for (std::size_t i = 0; i < lines.size();) {
            std::size_t end = i + 1;
            while (end < lines.size() && lines[end] == lines[end - 1] + 1) ++end;
            if (!text.empty()) text += ", ";
            text += end - i == 1 ? fmt::format("{}", lines[i])
                                 : fmt::format("{}-{}", lines[i], lines[end - 1]);
            i = end;
        }
        return text;
    }

    std::string time_text(Time after) const {
        if (after < 0) {
            return fmt::format("{} ms", format_milliseconds(witness_.stimuli.end + after));
        }
        return fmt::format("+{} ns", after / nanosecond);
    }

    std::string_view verb_of(Logic value) const {
        switch (value) {
            case Logic::one:
                return localized("rises", "monte");
            case Logic::zero:
                return localized("falls", "descend");
            default:
                return localized("becomes undefined", "devient indéterminée");
        }
    }

    void write_chain() {
        const std::size_t most_links = options_.most_links;
        writer_.add(localized("How it came about, gate by gate:\n",
                              "Comment on en arrive là, porte par porte :\n"));
        const std::vector<Explanation::Link>& chain = explanation_.chain;
        if (chain.empty()) {
            writer_.add(localized("  no gate changes\n", "  aucune porte ne change\n"));
            return;
        }
        std::size_t first = 0;
        if (most_links != 0 && chain.size() > most_links) {
            first = chain.size() - most_links;
            writer_.add(fmt::format(
                fmt::runtime(localized("  … {} links before these stand in witness.txt\n",
                                       "  … {} maillons avant ceux-ci : voir witness.txt\n")),
                first));
        }
        for (std::size_t i = first; i < chain.size(); ++i) write_link(chain[i]);
    }

    void write_link(const Explanation::Link& link) {
        std::string line = fmt::format("  {}  ", time_text(link.after));
        if (link.cell == no_cell) {
            line += fmt::format("{} {}", localized("input", "entrée"), link.net);
        } else {
            line += cell_description(netlist_, link.cell, language_);
            const Origin& origin = netlist_.origin_of(netlist_.cells[link.cell]);
            if (origin.kind == Origin::Kind::other && origin.where.is_known()) {
                line += options_.source.empty()
                            ? fmt::format(" ({} {})", localized("line", "ligne"), origin.where.line)
                            : fmt::format(" ({}:{})", options_.source, origin.where.line);
            }
        }
        line += fmt::format(" {}", verb_of(link.value));
        if (!link.causes.empty()) {
            line +=
                fmt::format(", {} {}", localized("after", "après"), fmt::join(link.causes, ", "));
        } else if (link.cell != no_cell && is_timer(netlist_.cells[link.cell].type)) {
            line += localized(", its delay has ended", ", son retard est écoulé");
        } else if (link.cell != no_cell) {
            line += localized(", from the start", ", dès le départ");
        }
        writer_.add(line + "\n");
    }

    void write_oscillation() {
        if (explanation_.oscillating.empty()) return;
        writer_.add(localized("The netlist does not settle. These keep changing:\n",
                              "Le câblage ne se stabilise pas. Changent sans cesse :\n"));
        std::size_t shown = 0;
        for (const CellId cell : explanation_.oscillating) {
            if (shown++ == most_oscillating) {
                writer_.add(
                    fmt::format(fmt::runtime(localized("  and {} more\n", "  et {} autres\n")),
                                explanation_.oscillating.size() - most_oscillating));
                break;
            }
            writer_.add(fmt::format("  {}\n", cell_description(netlist_, cell, language_)));
        }
    }

    void write_cause() {
        if (!explanation_.cause) return;
        writer_.add(fmt::format("{}\n  {}\n{}\n  {}\n", localized("Cause:", "Cause :"),
                                cause_text(*explanation_.cause, language_),
                                localized("What helps:", "Remède :"),
                                remedy_text(*explanation_.cause, language_)));
    }

    const Netlist& netlist_;
    const Witness& witness_;
    const Explanation& explanation_;
    const ExplanationOptions& options_;
    Language language_;
    ExplanationWriter writer_;
};

}  // namespace

std::string write_explanation(const Grafcet& grafcet, const Netlist& netlist,
                              const Witness& witness, const Explanation& explanation,
                              const ExplanationOptions& options) {
    return ExplanationText(grafcet, netlist, witness, explanation, options).make();
}

}  // namespace grafwire
