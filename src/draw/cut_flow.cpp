#include "draw/cut_flow.h"

#include <iterator>
#include <utility>

namespace grafwire {

namespace {

/// Lets what goes into a node end with its name. `from` is the node above the sequence.
void name_ends(std::vector<FlowNode>& nodes, FlowSequence& sequence, std::uint32_t target,
               std::uint32_t from) {
    if (sequence.end != FlowSequence::End::into) return;
    for (const FlowPiece& piece : sequence.pieces) {
        if (piece.node != none) from = piece.node;
    }
    if (!sequence.pieces.empty() && sequence.pieces.back().node == none) {
        sequence.end = FlowSequence::End::stops;
        for (FlowSequence& branch : sequence.pieces.back().branches) {
            name_ends(nodes, branch, target, from);
        }
        return;
    }
    sequence.end = FlowSequence::End::named;
    sequence.target = target;
    if (from != none) nodes[target].named.push_back(from);
}

std::size_t size_of(const FlowSequence& sequence) {
    std::size_t size = sequence.pieces.size();
    for (const FlowPiece& piece : sequence.pieces) {
        for (const auto* list : {&piece.branches, &piece.before, &piece.after}) {
            for (const FlowSequence& branch : *list) size += size_of(branch);
        }
    }
    return size;
}

struct Branch {
    FlowSequence* sequence = nullptr;
    std::uint32_t meeting = none;  ///< what it goes into
    std::size_t size = 0;
};

/// `meeting` is what the sequence itself goes into.
Branch largest_branch(FlowSequence& sequence, std::uint32_t meeting) {
    Branch largest;
    const auto look_at = [&](std::vector<FlowSequence>& branches, std::uint32_t into) {
        for (FlowSequence& branch : branches) {
            const std::size_t size = size_of(branch);
            if (size > largest.size) largest = {&branch, into, size};
        }
    };
    const bool has_own =
        sequence.end == FlowSequence::End::up || sequence.end == FlowSequence::End::named;
    const std::uint32_t into = has_own ? sequence.target : meeting;
    for (std::size_t i = 0; i < sequence.pieces.size(); ++i) {
        FlowPiece& piece = sequence.pieces[i];
        const bool is_last = i + 1 == sequence.pieces.size();
        look_at(piece.branches, is_last ? into : sequence.pieces[i + 1].node);
        look_at(piece.before, none);
        look_at(piece.after, none);
    }
    return largest;
}

}  // namespace

std::vector<std::size_t> places_to_cut(const std::vector<FlowNode>& nodes,
                                       const FlowSequence& sequence) {
    std::vector<std::size_t> places;
    const std::vector<FlowPiece>& pieces = sequence.pieces;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const FlowPiece& above = pieces[i - 1];
        const bool is_before_step =
            pieces[i].node != none && nodes[pieces[i].node].kind != FlowNode::Kind::transition;
        if (is_before_step && above.before.empty() && above.after.empty()) places.push_back(i);
    }
    return places;
}

FlowSequence cut_before(std::vector<FlowNode>& nodes, FlowSequence& sequence, std::size_t piece) {
    FlowSequence rest;
    rest.end = sequence.end;
    rest.target = sequence.target;
    const auto first = sequence.pieces.begin() + static_cast<std::ptrdiff_t>(piece);
    rest.pieces.assign(std::make_move_iterator(first),
                       std::make_move_iterator(sequence.pieces.end()));
    sequence.pieces.erase(first, sequence.pieces.end());
    sequence.end = FlowSequence::End::into;
    name_ends(nodes, sequence, rest.pieces.front().node, none);
    return rest;
}

std::vector<FlowSequence> cut_largest_branch(std::vector<FlowNode>& nodes, FlowSequence& sequence) {
    const std::size_t half = size_of(sequence) / 2;
    Branch best;
    Branch branch = largest_branch(sequence, none);
    while (branch.sequence != nullptr) {
        if (!places_to_cut(nodes, *branch.sequence).empty()) best = branch;
        if (best.sequence != nullptr && branch.size <= half) break;
        branch = largest_branch(*branch.sequence, branch.meeting);
    }
    std::vector<FlowSequence> rests;
    if (best.sequence == nullptr) return rests;
    const std::vector<std::size_t> places = places_to_cut(nodes, *best.sequence);
    rests.push_back(cut_before(nodes, *best.sequence, places[places.size() / 2]));
    if (best.meeting != none) name_ends(nodes, rests.back(), best.meeting, none);
    return rests;
}

}  // namespace grafwire
