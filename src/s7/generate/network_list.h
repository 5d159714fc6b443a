#pragma once

#include <cstdint>
#include <vector>

#include "s7/listing.h"
#include "text/message.h"

namespace grafwire::s7 {

/// What a network is for: the skeleton of the method is the same for every chart (Cordier, chapter
/// V); the rest is the chart's.
enum class Part : std::uint8_t { skeleton, chart };

/// The networks of a listing as it grows, numbered from 1, with comments in one language.
class NetworkList {
  public:
    explicit NetworkList(Language language) : language_(language) {}

    /// A new network at the end. The reference lives until the next call.
    Network& add(Part part, const Localized& comment);
    /// The same with its instructions.
    void add(Part part, const Localized& comment, std::vector<Instruction> instructions);

    /// The bytes of program memory of one part.
    std::uint32_t size_of_part(Part part) const;
    const std::vector<Network>& networks() const { return networks_; }
    std::vector<Network> take() { return std::move(networks_); }

  private:
    Language language_;
    std::vector<Network> networks_;
    std::vector<Part> parts_;
};

}  // namespace grafwire::s7
