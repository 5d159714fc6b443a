// From the elements of an LD body to rungs, in the order in which they are executed.
//
// Coils, blocks and outVariables are the ends of a network. They are taken from top to bottom, and
// whatever an end depends on is executed before it: a block gives rise to a rung of its own, after
// which its output is a contact (`TON1.Q`); only coils and blocks that hang on nothing but that
// output stay in its rung.

#include "plcopen/ladder_networks.h"

#include <algorithm>

#include "plcopen/messages.h"

namespace grafwire::plcopen {

namespace {

using Kind = Element::Kind;

}  // namespace

LadderNetworks::LadderNetworks(const Source& source, const LadderElements& elements,
                               LadderVariables& variables, ladder::Ladder& ladder)
    : source_(source),
      elements_(elements),
      variables_(variables),
      ladder_(ladder),
      states_(elements.all().size(), State::waits) {
    bool all_ordered = true;
    for (std::size_t e = 0; e < states_.size(); ++e) {
        const Element& element = elements_[e];
        const bool is_end = element.kind == Kind::coil || element.kind == Kind::out_variable ||
                            (element.kind == Kind::block && !is_pure(e));
        if (!is_end) continue;
        ends_.push_back(e);
        all_ordered = all_ordered && element.order.has_value();
    }
    std::stable_sort(ends_.begin(), ends_.end(), [&](std::size_t a, std::size_t b) {
        const Element& first = elements_[a];
        const Element& second = elements_[b];
        if (all_ordered) return *first.order < *second.order;
        return std::tie(first.network, first.y, first.x) <
               std::tie(second.network, second.y, second.x);
    });
}

void LadderNetworks::read() {
    for (std::size_t end = 0; end < ends_.size(); ++end) {
        const std::size_t element = ends_[end];
        if (states_[element] != State::waits) continue;
        if (elements_[element].kind == Kind::block) {
            read_block(element);
        } else if (is_coil(element)) {
            read_coils(end);
        } else {
            read_number(element);
        }
    }
}

bool LadderNetworks::is_coil(std::size_t element) const {
    const Element& item = elements_[element];
    return item.kind == Kind::coil ||
           (item.kind == Kind::out_variable && !variables_.is_integer(item.text));
}

std::optional<ladder::Coil> LadderNetworks::coil_of(std::size_t element) const {
    const Element& item = elements_[element];
    const auto variable = variables_.bit(item.text, item.node);
    if (!variable) return std::nullopt;
    const std::string_view storage = item.node.attribute("storage").as_string("none");
    const std::string_view edge = item.node.attribute("edge").as_string("none");
    const bool negated = item.node.attribute("negated").as_bool();
    const int marks = (storage != "none" ? 1 : 0) + (edge != "none" ? 1 : 0) + (negated ? 1 : 0);
    if (marks > 1) {
        source_.error(item.node, messages::plcopen::coil_marks());
        return std::nullopt;
    }
    const ladder::CoilKind kind = storage == "set"     ? ladder::CoilKind::set
                                  : storage == "reset" ? ladder::CoilKind::reset
                                  : edge == "rising"   ? ladder::CoilKind::rising
                                  : edge == "falling"  ? ladder::CoilKind::falling
                                  : negated            ? ladder::CoilKind::negated
                                                       : ladder::CoilKind::normal;
    return ladder::Coil{kind, *variable};
}

void LadderNetworks::push(ladder::Rung rung, std::size_t element) {
    rung.number = static_cast<std::uint32_t>(elements_[element].network + 1);
    rung.origin = source_.place_of(elements_[element].node);
    ladder_.rungs.push_back(std::move(rung));
}

/// A coil, and those right after it that hang on the same wires.
void LadderNetworks::read_coils(std::size_t end) {
    const std::size_t first = ends_[end];
    const Element& element = elements_[first];
    if (element.inlets.empty()) {
        source_.error(element.node, messages::plcopen::coil_not_connected());
        return;
    }
    const Inlet& inlet = element.inlets.front();
    auto cause = power(inlet, first);
    if (!cause || states_[first] == State::done) return;
    ladder::Rung rung;
    rung.power = std::move(*cause);
    for (; end < ends_.size(); ++end) {
        const std::size_t next = ends_[end];
        const Element& other = elements_[next];
        const bool belongs = states_[next] == State::waits && is_coil(next) &&
                             other.network == element.network && !other.inlets.empty() &&
                             other.inlets.front().sources == inlet.sources;
        if (!belongs) break;
        states_[next] = State::done;
        if (const auto coil = coil_of(next)) rung.coils.push_back(*coil);
    }
    push(std::move(rung), first);
}

/// An outVariable that takes a number.
void LadderNetworks::read_number(std::size_t element) {
    states_[element] = State::done;
    const auto target = variables_.integer(elements_[element].text, elements_[element].node);
    if (!target || elements_[element].inlets.empty()) return;
    for (const Output& output : elements_[element].inlets.front().sources) {
        if (elements_[output.element].kind != Kind::block) continue;
        read_block(output.element);
        // A function has moved its result itself.
        if (results_.count(output.element) > 0) return;
    }
    const auto source = operand(element, "", ladder::Operand::Kind::number, false);
    if (!source) return;
    ladder::Rung rung;
    rung.blocks.push_back({ladder::BlockType::move, *target, {*source}});
    push(std::move(rung), element);
}

Output LadderNetworks::onward_of(std::size_t element) const {
    const ladder::BlockTypeRow& row = *block_named(elements_[element].text);
    return {element, row.is_function ? "ENO" : std::string(row.output)};
}

void LadderNetworks::read_block(std::size_t element) {
    if (is_pure(element) || states_[element] == State::done) return;
    if (states_[element] == State::begun) {
        source_.error(elements_[element].node, messages::plcopen::block_in_a_circle());
        return;
    }
    const ladder::BlockTypeRow* row = block_named(elements_[element].text);
    if (row == nullptr) return;  // reported where it was read
    states_[element] = State::begun;
    ladder::Rung rung;
    const Inlet* inlet = elements_[element].inlet(row->power);
    const bool is_connected =
        inlet != nullptr && (!inlet->sources.empty() || !inlet->expression.empty());
    if (is_connected) {
        auto cause = power(*inlet, element);
        if (!cause) return;
        rung.power = std::move(*cause);
    } else if (!row->is_function) {
        source_.error(elements_[element].node, messages::plcopen::input_not_connected(row->power));
        return;
    }
    for (std::optional<std::size_t> next = element; next;) {
        auto block = block_of(*next);
        if (!block) return;
        states_[*next] = State::begun;
        rung.blocks.push_back(std::move(*block));
        add_moves(*next, rung);
        const Output onward = onward_of(*next);
        states_[*next] = State::done;
        const auto after = next_in_chain(*next, onward);
        if (!after) end_chain(*next, onward, rung);
        next = after;
    }
    push(std::move(rung), element);
}

/// The block that alone takes the power on, and reads nothing that would have to be worked out.
std::optional<std::size_t> LadderNetworks::next_in_chain(std::size_t element,
                                                         const Output& onward) {
    const auto consumers = elements_.consumers(onward);
    if (consumers.size() != 1) return std::nullopt;
    const std::size_t next = consumers.front().element;
    const Element& item = elements_[next];
    const ladder::BlockTypeRow* row = item.kind == Kind::block ? block_named(item.text) : nullptr;
    if (row == nullptr || states_[next] != State::waits) return std::nullopt;
    if (item.network != elements_[element].network) return std::nullopt;
    for (std::size_t i = 0; i < item.inlets.size(); ++i) {
        const Inlet& inlet = item.inlets[i];
        if (i == consumers.front().inlet) {
            if (inlet.name != row->power || inlet.negated || inlet.sources.size() != 1) {
                return std::nullopt;
            }
            continue;
        }
        for (const Output& source : inlet.sources) {
            const bool is_value = elements_[source.element].kind == Kind::in_variable ||
                                  results_.count(source.element) > 0;
            if (!is_value || inlet.negated) return std::nullopt;
        }
    }
    return next;
}

/// The coils that hang on nothing else; a bit for the ENO of a function that anything else reads.
void LadderNetworks::end_chain(std::size_t element, const Output& onward, ladder::Rung& rung) {
    const auto consumers = elements_.consumers(onward);
    std::vector<std::size_t> coils;
    for (const auto& consumer : consumers) {
        const Element& item = elements_[consumer.element];
        if (is_coil(consumer.element) && states_[consumer.element] == State::waits &&
            item.inlets[consumer.inlet].sources.size() == 1) {
            coils.push_back(consumer.element);
        }
    }
    if (coils.size() < consumers.size()) {
        coils.clear();
        if (!results_.count(element)) return;
        const ladder::VariableId bit = variables_.add_hidden(
            fmt::format("ENO_{}", elements_[element].node.attribute("localId").as_string()),
            ladder::Type::bit);
        executed_.emplace(element, bit);
        rung.coils.push_back({ladder::CoilKind::normal, bit});
    }
    std::sort(coils.begin(), coils.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(elements_[a].y, elements_[a].x) < std::tie(elements_[b].y, elements_[b].x);
    });
    for (const std::size_t coil : coils) {
        states_[coil] = State::done;
        if (const auto made = coil_of(coil)) rung.coils.push_back(*made);
    }
}

}  // namespace grafwire::plcopen
