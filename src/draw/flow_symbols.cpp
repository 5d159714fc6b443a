#include "draw/flow_symbols.h"

#include <algorithm>
#include <utility>

#include "draw/messages.h"

namespace grafwire {

FlowSymbols::FlowSymbols(const ChartFlow& flow, const SheetOfNode& sheets, SymbolMaker& maker,
                         Language language, Scene& scene)
    : flow_(flow),
      sheets_(sheets),
      maker_(maker),
      language_(language),
      scene_(scene),
      symbols_(flow.nodes.size()),
      is_returned_to_(flow.nodes.size()) {}

void FlowSymbols::mark_returns(const FlowSequence& sequence) {
    if (sequence.end == FlowSequence::End::up) is_returned_to_[sequence.target] = true;
    for (const FlowPiece& piece : sequence.pieces) {
        for (const auto* list : {&piece.branches, &piece.before, &piece.after}) {
            for (const FlowSequence& branch : *list) mark_returns(branch);
        }
    }
}

Symbol& FlowSymbols::symbol(std::uint32_t number) {
    std::optional<Symbol>& made = symbols_[number];
    if (!made) made = make(number);
    return *made;
}

Symbol FlowSymbols::make(std::uint32_t number) {
    const FlowNode& made = node(number);
    switch (made.kind) {
        case FlowNode::Kind::step:
            return maker_.step(StepId{made.index});
        case FlowNode::Kind::macro:
            return maker_.macro(MacroId{made.index});
        case FlowNode::Kind::transition:
            return maker_.transition(TransitionId{made.index});
    }
    return {};
}

double FlowSymbols::above(std::uint32_t number) {
    double room = symbol(number).room_above;
    if (is_transition(number)) return room;
    if (is_returned_to_[number]) room += room > 0 ? 0.2 : 0.25;
    if (!node(number).named.empty()) room = std::max(room, 0.5);
    return room;
}

std::string FlowSymbols::name_of(std::uint32_t number) const {
    const FlowNode& named = node(number);
    switch (named.kind) {
        case FlowNode::Kind::step:
            return maker_.name_of(StepId{named.index});
        case FlowNode::Kind::macro:
            return maker_.name_of(MacroId{named.index});
        case FlowNode::Kind::transition:
            return maker_.name_of(TransitionId{named.index});
    }
    return {};
}

std::string FlowSymbols::name_at_cut(std::uint32_t number, std::uint32_t beside) const {
    const std::size_t sheet = sheets_[number];
    if (beside == none || sheet == sheets_[beside]) return name_of(number);
    return messages::draw::on_sheet(name_of(number), sheet).in(language_);
}

OwnerId FlowSymbols::link(std::string kind, std::uint32_t from, std::uint32_t to) {
    Owner owner{std::move(kind), {}, {}};
    if (from != none) owner.facts.emplace_back("from", name_of(from));
    if (to != none) owner.facts.emplace_back("to", name_of(to));
    return scene_.owners.add(std::move(owner));
}

}  // namespace grafwire
