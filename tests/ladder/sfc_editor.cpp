#include "ladder/sfc_editor.h"

#include <fmt/format.h>

#include <map>
#include <pugixml.hpp>
#include <set>
#include <string_view>
#include <vector>

#include "support/iec_lexer.h"

namespace grafwire::testing {

namespace {

using Nodes = std::vector<pugi::xml_node>;

[[noreturn]] void refuse(const std::string& message) {
    throw PlcError(0, message);
}

std::string_view kind_of(pugi::xml_node node) {
    return node.name();
}

std::string formatted_text(pugi::xml_node node) {
    return node.child("xhtml:p").text().get();
}

std::string joined_steps(const std::vector<std::string>& steps) {
    if (steps.size() == 1) return steps.front();
    std::string text;
    for (const std::string& step : steps) text += (text.empty() ? "(" : ", ") + step;
    return text + ")";
}

class Editor {
  public:
    explicit Editor(pugi::xml_node pou) : pou_(pou), body_(pou.child("body").child("SFC")) {
        for (const pugi::xml_node node : body_.children()) {
            elements_[node.attribute("localId").as_ullong()] = node;
        }
    }

    std::string text() {
        for (const pugi::xml_node node : body_.children("step")) visit_step(node);
        for (const pugi::xml_node node : body_.children("jumpStep")) {
            lead_to(node, node.attribute("targetName").value());
        }
        for (const pugi::xml_node node : body_.children("actionBlock")) read_actions(node);
        text_ = fmt::format("PROGRAM {}\n", pou_.attribute("name").value());
        write_variables();
        for (const std::string& step : initial_) write_step(step);
        return text_ + "END_PROGRAM\n";
    }

  private:
    struct Step {
        bool is_initial = false;
        std::vector<std::uint64_t> transitions;
        std::vector<std::pair<std::string, std::string>> actions;  ///< with statements, or none
    };
    struct Transition {
        std::string condition;
        std::vector<std::string> from;
        std::vector<std::string> to;
    };

    /// What the wire at an inlet comes from; exactly one.
    pugi::xml_node source(pugi::xml_node inlet) const {
        const pugi::xml_node wire = inlet.child("connection");
        if (!wire || wire.next_sibling("connection")) refuse("an inlet with no one wire");
        const auto found = elements_.find(wire.attribute("refLocalId").as_ullong());
        if (found == elements_.end()) refuse("a wire from nowhere");
        return found->second;
    }
    pugi::xml_node above(pugi::xml_node node) const {
        return source(node.child("connectionPointIn"));
    }
    Nodes all_above(pugi::xml_node bar, std::string_view wanted) const {
        Nodes nodes;
        for (const pugi::xml_node inlet : bar.children("connectionPointIn")) {
            nodes.push_back(source(inlet));
            if (kind_of(nodes.back()) != wanted) refuse("a bar on a " + text_of_kind(nodes.back()));
        }
        return nodes;
    }
    static std::string text_of_kind(pugi::xml_node node) { return std::string(kind_of(node)); }
    Nodes transitions_above(pugi::xml_node node) const;
    Nodes steps_above(pugi::xml_node transition) const;
    void visit_step(pugi::xml_node node);
    void visit_transition(pugi::xml_node node);
    void lead_to(pugi::xml_node node, const std::string& step);
    void read_actions(pugi::xml_node block);
    void write_variables();
    void write_step(const std::string& name);
    void write_transition(const Transition& transition);

    pugi::xml_node pou_;
    pugi::xml_node body_;
    std::map<std::uint64_t, pugi::xml_node> elements_;
    std::map<std::string, Step> steps_;
    std::map<std::uint64_t, Transition> transitions_;
    std::vector<std::string> initial_;
    std::set<std::string> written_steps_;
    std::set<std::uint64_t> written_transitions_;
    std::size_t action_count_ = 0;
    std::string text_;
};

/// Of a step or jump; none where nothing leads to it.
Nodes Editor::transitions_above(pugi::xml_node node) const {
    if (!node.child("connectionPointIn")) return {};
    pugi::xml_node found = above(node);
    if (kind_of(found) == "simultaneousDivergence") found = above(found);
    if (kind_of(found) == "selectionConvergence") return all_above(found, "transition");
    if (kind_of(found) != "transition") refuse("a step on a " + text_of_kind(found));
    return {found};
}

Nodes Editor::steps_above(pugi::xml_node transition) const {
    pugi::xml_node found = above(transition);
    if (kind_of(found) == "selectionDivergence") found = above(found);
    if (kind_of(found) == "simultaneousConvergence") return all_above(found, "step");
    if (kind_of(found) != "step") refuse("a transition on a " + text_of_kind(found));
    return {found};
}

void Editor::lead_to(pugi::xml_node node, const std::string& step) {
    for (const pugi::xml_node transition : transitions_above(node)) {
        visit_transition(transition);
        transitions_[transition.attribute("localId").as_ullong()].to.push_back(step);
    }
}

void Editor::visit_step(pugi::xml_node node) {
    const std::string name = node.attribute("name").value();
    if (steps_.count(name) > 0) return;
    steps_[name].is_initial = node.attribute("initialStep").as_bool();
    if (steps_[name].is_initial) initial_.push_back(name);
    lead_to(node, name);
}

void Editor::visit_transition(pugi::xml_node node) {
    const std::uint64_t id = node.attribute("localId").as_ullong();
    if (transitions_.count(id) > 0) return;
    transitions_[id].condition =
        formatted_text(node.child("condition").child("inline").child("ST"));
    for (const pugi::xml_node step : steps_above(node)) {
        const std::string name = step.attribute("name").value();
        visit_step(step);
        transitions_[id].from.push_back(name);
        steps_[name].transitions.push_back(id);
    }
}

void Editor::read_actions(pugi::xml_node block) {
    Step& step = steps_.at(above(block).attribute("name").value());
    const std::string step_name = above(block).attribute("name").value();
    for (const pugi::xml_node node : block.children("action")) {
        std::string name = node.child("reference").attribute("name").value();
        std::string statements;
        if (name.empty()) {
            name = fmt::format("{}_INLINE{}", step_name, ++action_count_);
            statements = formatted_text(node.child("inline").child("ST"));
            if (statements.empty()) refuse("an action of nothing");
        }
        std::string qualifier = node.attribute("qualifier").value();
        const std::string duration = node.attribute("duration").value();
        if (!duration.empty()) qualifier += ", " + duration;
        step.actions.emplace_back(fmt::format("{}({})", name, qualifier), statements);
    }
}

void Editor::write_variables() {
    const std::map<std::string_view, const char*> words{
        {"inputVars", "VAR_INPUT"}, {"outputVars", "VAR_OUTPUT"}, {"localVars", "VAR"}};
    for (const pugi::xml_node list : pou_.child("interface").children()) {
        text_ += fmt::format("{}\n", words.at(list.name()));
        for (const pugi::xml_node variable : list.children("variable")) {
            const pugi::xml_node type = variable.child("type").first_child();
            const bool is_derived = kind_of(type) == "derived";
            const std::string initial =
                variable.child("initialValue").child("simpleValue").attribute("value").value();
            text_ += fmt::format("  {} : {}{};\n", variable.attribute("name").value(),
                                 is_derived ? type.attribute("name").value() : type.name(),
                                 initial.empty() ? "" : " := " + initial);
        }
        text_ += "END_VAR\n";
    }
}

void Editor::write_step(const std::string& name) {
    if (!written_steps_.insert(name).second) return;
    const Step& step = steps_.at(name);
    text_ += fmt::format("{}STEP {}:\n", step.is_initial ? "INITIAL_" : "", name);
    for (const auto& [association, statements] : step.actions) text_ += "  " + association + ";\n";
    text_ += "END_STEP\n";
    for (const auto& [association, statements] : step.actions) {
        if (statements.empty()) continue;
        text_ += fmt::format("ACTION {}:\n{}\nEND_ACTION\n",
                             association.substr(0, association.find('(')), statements);
    }
    for (const std::uint64_t id : step.transitions) {
        if (!written_transitions_.insert(id).second) continue;
        write_transition(transitions_.at(id));
    }
}

void Editor::write_transition(const Transition& transition) {
    if (transition.to.empty()) refuse("a transition that leads nowhere");
    text_ += fmt::format("TRANSITION FROM {} TO {}\n  := {};\nEND_TRANSITION\n",
                         joined_steps(transition.from), joined_steps(transition.to),
                         transition.condition);
    for (const std::string& step : transition.to) write_step(step);
}

}  // namespace

std::string sfc_as_text(const std::string& xml) {
    pugi::xml_document document;
    if (!document.load_string(xml.c_str())) refuse("no XML");
    return Editor(document.child("project").child("types").child("pous").child("pou")).text();
}

std::string undeclared_step_in(const std::string& sfc_text) {
    const std::vector<IecToken> tokens = iec_tokens(sfc_text);
    std::set<std::string> declared;
    for (std::size_t i = 1; i + 2 < tokens.size(); ++i) {
        const std::string& before = tokens[i - 1].text;
        if (before == "step" || before == "initial_step") declared.insert(tokens[i].text);
        const bool is_flag = tokens[i + 1].text == "." && tokens[i + 2].text == "x";
        if (is_flag && declared.count(tokens[i].text) == 0) return tokens[i].text;
    }
    return {};
}

}  // namespace grafwire::testing
