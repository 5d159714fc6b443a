#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "draw/chart_flow.h"
#include "draw/chart_symbols.h"
#include "draw/scene.h"
#include "text/message.h"

namespace grafwire {

/// How cut links name what stands on another sheet: by node of the flow, the number of the sheet,
/// or 0 where there is only one.
using SheetOfNode = std::vector<std::size_t>;

/// What all sequences of a block share: the symbols of its nodes, the room that they need, and how
/// links are called.
class FlowSymbols {
  public:
    FlowSymbols(const ChartFlow& flow, const SheetOfNode& sheets, SymbolMaker& maker,
                Language language, Scene& scene);

    const FlowNode& node(std::uint32_t number) const { return flow_.nodes[number]; }
    bool is_transition(std::uint32_t number) const {
        return node(number).kind == FlowNode::Kind::transition;
    }
    /// Marks the steps that links lead back up to: they need room for them.
    void mark_returns(const FlowSequence& sequence);
    bool is_returned_to(std::uint32_t number) const { return is_returned_to_[number]; }

    /// The symbol of a node; its shapes may be taken once.
    Symbol& symbol(std::uint32_t number);
    /// How far it reaches above and below, with links that enter from the side.
    double above(std::uint32_t number);
    double below(std::uint32_t number) { return symbol(number).room_below; }

    std::string name_of(std::uint32_t number) const;
    /// The name at the end of a cut link, with the sheet if it is another than that of `beside`.
    std::string name_at_cut(std::uint32_t number, std::uint32_t beside) const;

    /// An owner for links between two nodes, either of which may be none.
    OwnerId link(std::string kind, std::uint32_t from, std::uint32_t to);
    const Owner& owner(OwnerId id) const { return scene_.owners[id]; }

  private:
    Symbol make(std::uint32_t number);

    const ChartFlow& flow_;
    const SheetOfNode& sheets_;
    SymbolMaker& maker_;
    Language language_;
    Scene& scene_;
    std::vector<std::optional<Symbol>> symbols_;
    std::vector<bool> is_returned_to_;
};

}  // namespace grafwire
