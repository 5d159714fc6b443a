// From what differs at the end of a witness back to why.
//
// First the equations: of every wrong step or output what it should be made of against what the
// gates make of it (compare_functions), with the values at the moment in which the two disagree.
// A netlist does not say which form of CDX it has; it is taken to have the one with fewer wrong
// equations, then with fewer faults.
// Then the chain by which it came about (causal_chain). Where a value is wrong because it did not
// change, the chain is the one to what should have changed it. Last the cause, if it is a known
// one.

#include "explain/explain.h"

#include <algorithm>

#include "explain/causal_chain.h"
#include "explain/cause_search.h"
#include "explain/compare_functions.h"
#include "explain/explanation_writer.h"
#include "explain/named_chain.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

using Fault = Explanation::Fault;
using Part = Explanation::Part;

/// The loop of an oscillation is looked for among this many changes of one net.
constexpr std::size_t most_rounds = 32;

/// The explanation of one witness. The steps of make() build on each other: what is wrong, what it
/// should be made of, when that is decided, what follows from what, how it came about, and why.
class Explainer {
  public:
    Explainer(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
              const Witness& witness)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          witness_(witness),
          history_(grafcet, netlist, delays, witness),
          reference_(end_of_reference(grafcet, witness)),
          reader_(grafcet, netlist) {}

    Explanation make() {
        find_parts();
        compare();
        for (Examined& examined : parts_) decide(examined);
        note_consequences();
        make_chain();
        find_cause();
        // What follows from others comes after them.
        std::stable_partition(parts_.begin(), parts_.end(), [](const Examined& examined) {
            return examined.part.follows_from.empty();
        });
        for (Examined& examined : parts_) result_.parts.push_back(std::move(examined.part));
        for (const NetId net : history_.oscillating) {
            if (reader_.driver(net) != no_cell) {
                result_.oscillating.push_back(reader_.driver(net));
            }
        }
        return std::move(result_);
    }

  private:
    struct Examined {
        Part part;
        std::size_t index = 0;  ///< in the values of the witness
        std::string operand;    ///< of a step: its X as equations write it
        NetId net = no_net;
        FunctionComparison functions;
        bool is_decided = false;
    };

    bool oscillates(NetId net) const {
        return std::find(history_.oscillating.begin(), history_.oscillating.end(), net) !=
               history_.oscillating.end();
    }

    /// What differs; of a netlist that does not settle, what keeps changing.
    void find_parts() {
        const std::size_t steps = grafcet_.steps.size();
        for (std::size_t i = 0; i < witness_.values.size(); ++i) {
            const Witness::Value& value = witness_.values[i];
            const NetId net =
                i < steps ? reader_.ports().steps[i] : reader_.ports().outputs[i - steps];
            const bool is_wrong = witness_.kind == DifferenceKind::oscillation
                                      ? oscillates(net)
                                      : value.expected != value.got;
            if (!is_wrong) continue;
            Examined examined;
            examined.part.name = value.name;
            examined.part.is_step = i < steps;
            examined.part.expected = value.expected;
            examined.part.got = value.got;
            examined.index = i;
            if (i < steps) {
                examined.operand =
                    operand_name(grafcet_, {VariableKind::step, static_cast<std::uint32_t>(i)});
            }
            examined.net = net;
            parts_.push_back(std::move(examined));
        }
    }

    /// Every part against the equations with this form of CDX.
    void compare_with(CdxForm cdx, std::vector<FunctionComparison>& functions) {
        const Equations equations = equations_from(grafcet_, {cdx, netlist_.has_modes});
        for (const Examined& examined : parts_) {
            const std::size_t steps = grafcet_.steps.size();
            if (examined.part.is_step) {
                functions.push_back(
                    compare_step(reader_, equations, static_cast<StepId>(examined.index)));
            } else {
                functions.push_back(compare_output(reader_, equations,
                                                   static_cast<OutputId>(examined.index - steps)));
            }
        }
    }
    /// Chooses the form of CDX that leaves fewer wrong equations, then fewer faults; with as many,
    /// the successor form.
    void compare() {
        std::vector<FunctionComparison> chosen;
        std::pair<std::size_t, std::size_t> fewest;
        for (const CdxForm cdx : {CdxForm::successor, CdxForm::transition}) {
            if (netlist_.is_clocked() && cdx == CdxForm::successor) continue;
            std::vector<FunctionComparison> functions;
            compare_with(cdx, functions);
            std::pair<std::size_t, std::size_t> faults;
            for (const FunctionComparison& comparison : functions) {
                const Fault fault = comparison.fault;
                if (fault == Fault::equation) ++faults.first;
                if (fault != Fault::no_fault && fault != Fault::unread) ++faults.second;
            }
            if (!chosen.empty() && faults >= fewest) continue;
            chosen = std::move(functions);
            fewest = faults;
            cdx_ = cdx;
        }
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            parts_[i].functions = std::move(chosen[i]);
            parts_[i].part.fault = parts_[i].functions.fault;
            parts_[i].part.equations = parts_[i].functions.equations;
            parts_[i].part.lines = lines_of(parts_[i].functions.gates);
        }
    }
    /// Of gates that were not made from the GRAFCET.
    std::vector<std::uint32_t> lines_of(const std::vector<NetId>& gates) const {
        std::vector<std::uint32_t> lines;
        for (const NetId net : gates) {
            const CellId driver = reader_.driver(net);
            if (driver == no_cell) continue;
            const Origin& origin = netlist_.origin_of(netlist_.cells[driver]);
            if (origin.kind == Origin::Kind::other && origin.where.is_known()) {
                lines.push_back(origin.where.line);
            }
        }
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
        return lines;
    }

    /// The last change of a net in the last instant, to the value it ended at.
    std::optional<std::size_t> last_change(NetId net) const {
        for (std::size_t i = history_.changes.size(); i > history_.first_of_end; --i) {
            if (history_.changes[i - 1].net == net) return i - 1;
        }
        return std::nullopt;
    }

    /// The change that is to be accounted for: the last one; of an oscillation the first one away
    /// from what it should be.
    std::optional<std::size_t> wrong_change(const Examined& examined) const {
        if (witness_.kind != DifferenceKind::oscillation) return last_change(examined.net);
        for (std::size_t i = history_.first_of_end; i < history_.changes.size(); ++i) {
            const NetChange& change = history_.changes[i];
            if (change.net == examined.net && change.value != examined.part.expected) return i;
        }
        return std::nullopt;
    }

    /// The moment that decides, and the values of the operands then.
    void decide(Examined& examined) {
        const FunctionComparison& functions = examined.functions;
        const Time end = witness_.stimuli.end;
        std::vector<Logic> decisive = history_.before_end();
        Time decided_at = end;
        bool is_final = false;
        // Just before the wrong change, or at the end where there is none.
        const auto change = wrong_change(examined);
        const Time changed_at = change ? history_.changes[*change].at : never;
        history_.replay_end(end, [&](const std::vector<Logic>& nets, Time at) {
            if (!examined.is_decided && at < changed_at) decisive = nets;
            if (!functions.got || is_final) return;
            const auto row =
                row_of(functions.variables, {&*functions.expected, &*functions.got}, nets);
            if (!row) return;
            const bool expected = functions.expected->at(*row);
            const bool got = functions.got->at(*row);
            if (expected == got) return;
            is_final =
                examined.part.expected == logic_of(expected) && examined.part.got == logic_of(got);
            if (examined.is_decided && !is_final) return;
            examined.is_decided = true;
            decisive = nets;
            decided_at = at;
        });
        if (examined.is_decided) examined.part.decided_at = decided_at - end;
        for (Explanation::EquationPair& pair : examined.part.equations) {
            for (Explanation::Operand& operand : pair.operands) {
                operand.value = value_at(functions, operand.name, decisive);
            }
        }
        if (examined.part.fault != Fault::unread) return;
        for (const std::string& name : functions.reads) {
            examined.part.reads.push_back({name, value_at(functions, name, decisive)});
        }
    }
    /// The value of an operand, by its name, at a moment with these values of the nets.
    Logic value_at(const FunctionComparison& functions, const std::string& name,
                   const std::vector<Logic>& nets) const {
        const auto variable = functions.variables.find(name);
        if (variable && functions.variables[*variable].net != no_net) {
            return value_of(functions.variables[*variable], nets);
        }
        // An input that the netlist lacks.
        for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
            const bool is_control = i >= grafcet_.inputs.size();
            const auto number =
                static_cast<std::uint32_t>(is_control ? i - grafcet_.inputs.size() : i);
            const VariableKind kind = is_control ? VariableKind::control : VariableKind::input;
            if (operand_name(grafcet_, {kind, number}) != name) continue;
            StimuliPlayer player(witness_.stimuli, grafcet_.all_input_count());
            player.advance(witness_.stimuli.end);
            return logic_of(player.inputs()[i] != 0);
        }
        return Logic::unknown;
    }

    /// What is right in itself and reads something wrong follows from that.
    void note_consequences() {
        for (Examined& examined : parts_) {
            if (examined.is_decided) continue;
            for (const Examined& other : parts_) {
                if (!other.part.is_step || &other == &examined) continue;
                const bool is_read = examined.functions.variables.find(other.operand).has_value();
                // Two steps that read each other: where neither has a fault, neither is first.
                const bool is_before = other.is_decided || !examined.part.is_step;
                if (is_read && is_before) examined.part.follows_from.push_back(other.part.name);
            }
        }
    }

    /// The changes to be explained.
    std::vector<std::size_t> targets() const {
        if (witness_.kind == DifferenceKind::oscillation) return around_the_loop();
        std::vector<std::size_t> found;
        const auto add = [&](const Examined& examined) {
            const auto change = last_change(examined.net);
            // A value that was decided after its last change is wrong because it did not change.
            const Time decided = examined.part.decided_at.value_or(-1) + witness_.stimuli.end;
            const bool stays = !change || history_.changes[*change].at <= decided;
            if (change) found.push_back(*change);
            if (!stays) return;
            // What should have made it.
            const bool is_equation = examined.part.fault == Fault::equation;
            for (const Explanation::EquationPair& pair : examined.part.equations) {
                if (is_equation && pair.is_same) continue;
                for (const Explanation::Operand& operand : pair.operands) {
                    const auto v = examined.functions.variables.find(operand.name);
                    if (!v || examined.functions.variables[*v].net == no_net) continue;
                    const auto moved = last_change(examined.functions.variables[*v].net);
                    if (!moved) continue;
                    const bool is_later =
                        change && history_.changes[*moved].at > decided && examined.part.decided_at;
                    if (!is_later) found.push_back(*moved);
                }
            }
        };
        const bool has_decided = std::any_of(parts_.begin(), parts_.end(),
                                             [](const Examined& e) { return e.is_decided; });
        const bool has_steps = std::any_of(parts_.begin(), parts_.end(),
                                           [](const Examined& e) { return e.part.is_step; });
        for (const Examined& examined : parts_) {
            const bool is_first = has_decided ? examined.is_decided
                                  : has_steps ? examined.part.is_step
                                              : true;
            if (is_first) add(examined);
        }
        return found;
    }
    /// The first change of an oscillating net to which an earlier one of the same net has led.
    std::vector<std::size_t> around_the_loop() const {
        if (history_.oscillating.empty()) return {};
        NetId net = history_.oscillating.front();
        for (const Examined& examined : parts_) {
            if (examined.part.is_step) {
                net = examined.net;
                break;
            }
        }
        std::vector<std::size_t> changes;
        for (std::size_t i = history_.first_of_end; i < history_.changes.size(); ++i) {
            if (history_.changes[i].net == net) changes.push_back(i);
            if (changes.size() == most_rounds) break;
        }
        for (const std::size_t change : changes) {
            const auto chain = causal_chain(netlist_, delays_, history_, {change}, witness_.delays);
            const bool has_earlier =
                std::any_of(chain.begin(), chain.end(), [&](const CausalLink& link) {
                    const NetChange& other = history_.changes[link.change];
                    return other.net == net && link.change != change &&
                           other.value == history_.changes[change].value;
                });
            if (has_earlier) return {change};
        }
        if (changes.empty()) return {};
        return {changes.back()};
    }

    void make_chain() {
        result_.chain =
            named_chain(netlist_, history_,
                        causal_chain(netlist_, delays_, history_, targets(), witness_.delays),
                        witness_.stimuli.end);
    }

    /// Puts together what the search for a known cause looks at.
    void find_cause() {
        WitnessFacts facts{grafcet_,   netlist_, delays_, witness_, history_,
                           reference_, reader_,  cdx_,    {},       false};
        for (const Examined& examined : parts_) {
            if (examined.part.is_step) {
                facts.steps.push_back({static_cast<StepId>(examined.index),
                                       examined.part.expected == Logic::one, examined.functions,
                                       examined.is_decided});
            } else if (examined.is_decided) {
                facts.has_wrong_output = true;
            }
        }
        result_.cause = cause_of(facts);
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    const Witness& witness_;
    NetHistory history_;
    ReferenceEnd reference_;
    NetReader reader_;
    CdxForm cdx_ = CdxForm::successor;
    std::vector<Examined> parts_;
    Explanation result_;
};

}  // namespace

Explanation explain(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                    const Witness& witness) {
    return Explainer(grafcet, netlist, delays, witness).make();
}

}  // namespace grafwire
