#include "s7/generate/network_list.h"

#include <utility>

#include "s7/instruction_set.h"

namespace grafwire::s7 {

Network& NetworkList::add(Part part, const Localized& comment) {
    Network network;
    network.number = static_cast<std::uint32_t>(networks_.size() + 1);
    network.comment = comment.in(language_);
    parts_.push_back(part);
    networks_.push_back(std::move(network));
    return networks_.back();
}

void NetworkList::add(Part part, const Localized& comment, std::vector<Instruction> instructions) {
    add(part, comment).instructions = std::move(instructions);
}

std::uint32_t NetworkList::size_of_part(Part part) const {
    std::uint32_t size = 0;
    for (std::size_t n = 0; n < networks_.size(); ++n) {
        if (parts_[n] != part) continue;
        for (const Instruction& instruction : networks_[n].instructions)
            size += size_of(instruction);
    }
    return size;
}

}  // namespace grafwire::s7
