#include "ladder/sfc_reader.h"

#include <cctype>
#include <map>
#include <pugixml.hpp>
#include <string_view>

#include "support/iec_lexer.h"

namespace grafwire::testing {

namespace {

[[noreturn]] void fail(const std::string& message) {
    throw PlcError(0, message);
}

std::string text_of(pugi::xml_node formatted) {
    return formatted.child("xhtml:p").text().get();
}

class Reader {
  public:
    explicit Reader(pugi::xml_node pou) : pou_(pou), body_(pou.child("body").child("SFC")) {
        if (!body_) fail("no SFC body");
    }

    SfcPou read() {
        read_variables();
        for (const pugi::xml_node node : body_.children()) {
            if (const auto id = node.attribute("localId")) elements_[id.as_ullong()] = node;
            if (std::string_view(node.name()) == "step") read_step(node);
        }
        for (const pugi::xml_node node : body_.children("transition")) read_transition(node);
        for (const pugi::xml_node node : body_.children()) {
            const std::string_view kind = node.name();
            if (kind == "actionBlock") read_actions(node);
            if (kind == "comment") sfc_.comments.push_back(text_of(node.child("content")));
            if (kind == "step") lead_to(node, node.attribute("name").value());
            if (kind == "jumpStep") lead_to(node, node.attribute("targetName").value());
        }
        return std::move(sfc_);
    }

  private:
    void read_variables();
    void read_step(pugi::xml_node node);
    void read_transition(pugi::xml_node node);
    void read_actions(pugi::xml_node node);
    void lead_to(pugi::xml_node node, const char* step);
    /// The elements that a step or transition hangs on, bars followed upwards.
    void collect_above(pugi::xml_node node, const char* wanted,
                       std::vector<pugi::xml_node>& found) const;
    std::size_t step_named(const std::string& name) const {
        const auto found = step_index_.find(lower_case(name));
        if (found == step_index_.end()) fail("no step " + name);
        return found->second;
    }

    pugi::xml_node pou_;
    pugi::xml_node body_;
    SfcPou sfc_;
    std::map<std::uint64_t, pugi::xml_node> elements_;
    std::map<std::string, std::size_t> step_index_;
    std::map<std::uint64_t, std::size_t> transition_index_;  ///< by localId
};

void Reader::read_variables() {
    for (const pugi::xml_node list : pou_.child("interface").children()) {
        for (const pugi::xml_node node : list.children("variable")) {
            SfcPou::Variable variable;
            variable.name = lower_case(node.attribute("name").value());
            const pugi::xml_node type = node.child("type").first_child();
            variable.type = lower_case(std::string_view(type.name()) == "derived"
                                           ? type.attribute("name").value()
                                           : type.name());
            const std::string initial =
                node.child("initialValue").child("simpleValue").attribute("value").value();
            variable.initial = initial.empty() ? 0 : initial == "TRUE" ? 1 : std::stoll(initial);
            variable.is_input = std::string_view(list.name()) == "inputVars";
            sfc_.variables.push_back(variable);
        }
    }
}

void Reader::read_step(pugi::xml_node node) {
    const std::string name = lower_case(node.attribute("name").value());
    if (!step_index_.emplace(name, sfc_.steps.size()).second) fail("two steps " + name);
    sfc_.steps.push_back({name, node.attribute("initialStep").as_bool()});
}

void Reader::collect_above(pugi::xml_node node, const char* wanted,
                           std::vector<pugi::xml_node>& found) const {
    for (const pugi::xml_node inlet : node.children("connectionPointIn")) {
        for (const pugi::xml_node wire : inlet.children("connection")) {
            const auto above = elements_.find(wire.attribute("refLocalId").as_ullong());
            if (above == elements_.end()) fail("a wire from nowhere");
            const std::string_view kind = above->second.name();
            if (kind == wanted) {
                found.push_back(above->second);
            } else if (kind.find("vergence") != std::string_view::npos) {
                collect_above(above->second, wanted, found);
            } else {
                fail("a wire from a " + std::string(kind));
            }
        }
    }
}

void Reader::read_transition(pugi::xml_node node) {
    SfcPou::Transition transition;
    transition.x = node.child("position").attribute("x").as_int();
    const pugi::xml_node text = node.child("condition").child("inline").child("ST");
    if (!text) fail("a transition without a condition");
    transition.condition = text_of(text);
    std::vector<pugi::xml_node> above;
    collect_above(node, "step", above);
    for (const pugi::xml_node step : above) {
        transition.preceding.push_back(step_named(step.attribute("name").value()));
    }
    if (above.empty()) fail("a transition without a step before it");
    transition_index_[node.attribute("localId").as_ullong()] = sfc_.transitions.size();
    sfc_.transitions.push_back(transition);
}

/// A step, or a jump to it, follows the transitions above.
void Reader::lead_to(pugi::xml_node node, const char* step) {
    std::vector<pugi::xml_node> above;
    collect_above(node, "transition", above);
    for (const pugi::xml_node transition : above) {
        const std::size_t index = transition_index_.at(transition.attribute("localId").as_ullong());
        sfc_.transitions[index].following.push_back(step_named(step));
    }
}

void Reader::read_actions(pugi::xml_node block) {
    std::vector<pugi::xml_node> above;
    collect_above(block, "step", above);
    if (above.size() != 1) fail("an action block of no one step");
    for (const pugi::xml_node node : block.children("action")) {
        SfcPou::Action action;
        action.step = step_named(above.front().attribute("name").value());
        action.qualifier = node.attribute("qualifier").as_string("N");
        action.reference = lower_case(node.child("reference").attribute("name").value());
        action.statements = text_of(node.child("inline").child("ST"));
        if (action.reference.empty() == action.statements.empty()) fail("an action of no one kind");
        const std::string duration = node.attribute("duration").value();
        const bool is_timed = action.qualifier == "D" || action.qualifier == "L";
        if (is_timed != !duration.empty()) fail("a duration too many, or none");
        if (is_timed) {
            const std::vector<IecToken> tokens = iec_tokens(duration);
            if (tokens.front().kind != IecToken::Kind::time) fail("no duration: " + duration);
            action.duration = tokens.front().value;
        }
        sfc_.actions.push_back(action);
    }
}

}  // namespace

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

SfcPou read_sfc(const std::string& xml, const std::string& name) {
    pugi::xml_document document;
    if (!document.load_string(xml.c_str())) fail("no XML");
    const pugi::xml_node pous = document.child("project").child("types").child("pous");
    const pugi::xml_node pou = pous.find_child_by_attribute("pou", "name", name.c_str());
    if (!pou) fail("no program " + name);
    return Reader(pou).read();
}

}  // namespace grafwire::testing
