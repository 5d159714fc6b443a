#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ladder/ladder.h"
#include "plcopen/source.h"

namespace grafwire::plcopen {

/// One output of an element of an LD body.
struct Output {
    std::size_t element = 0;
    std::string parameter;  ///< in capitals; of a block never empty
    auto operator<=>(const Output&) const = default;
};

struct Inlet {
    std::string name;  ///< of a block: the parameter, in capitals
    std::vector<Output> sources;
    std::string expression;  ///< written at the inlet itself, instead of sources
    bool negated = false;
    pugi::xml_node node;
};

/// An element of an LD body as it stands in the file.
struct Element {
    enum class Kind : std::uint8_t {
        left_rail,
        right_rail,
        contact,
        coil,
        block,
        in_variable,
        out_variable,
        connector,
        continuation,
        comment,
    };
    Kind kind = Kind::comment;
    pugi::xml_node node;
    int x = 0;
    int y = 0;
    std::optional<std::uint64_t> order;  ///< executionOrderId
    std::string text;                    ///< variable, expression, type of a block, label, comment
    std::vector<Inlet> inlets;
    std::size_t network = 0;  ///< from 0; see number_networks

    const Inlet* inlet(std::string_view name) const;
};

/// All elements of a body, connected. What is not understood is reported.
class LadderElements {
  public:
    LadderElements(const Source& source, pugi::xml_node body);

    const std::vector<Element>& all() const { return elements_; }
    const Element& operator[](std::size_t index) const { return elements_[index]; }
    /// The inlets that an output feeds, except those of right rails.
    struct Consumer {
        std::size_t element = 0;
        std::size_t inlet = 0;
    };
    std::vector<Consumer> consumers(const Output& output) const;
    std::size_t network_count() const { return network_count_; }

  private:
    void read(pugi::xml_node node);
    void read_block(Element& element);
    Inlet read_inlet(pugi::xml_node point) const;
    void connect();
    void follow_connectors();
    void number_networks();

    const Source& source_;
    std::vector<Element> elements_;
    std::map<std::uint64_t, std::size_t> by_id_;
    std::map<Output, std::vector<Consumer>> consumers_;
    std::size_t network_count_ = 0;
};

/// The output that is meant where a connection to a block names none.
std::string default_output(std::string_view block_type);
/// AND and OR, blocks that are nothing but contacts in series or in parallel.
bool is_gate(std::string_view block_type);
std::optional<Relation> comparison_named(std::string_view block_type);
const ladder::BlockTypeRow* block_named(std::string_view block_type);

}  // namespace grafwire::plcopen
