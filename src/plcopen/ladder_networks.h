#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "ladder/ladder.h"
#include "plcopen/ladder_elements.h"
#include "plcopen/ladder_variables.h"
#include "plcopen/power_graph.h"

namespace grafwire::plcopen {

/// Makes rungs of the elements of an LD body (see ladder_networks.cpp).
class LadderNetworks {
  public:
    LadderNetworks(const Source& source, const LadderElements& elements, LadderVariables& variables,
                   ladder::Ladder& ladder);

    void read();

  private:
    enum class State : std::uint8_t { waits, begun, done };
    static constexpr std::size_t most_contacts = 20'000;
    static constexpr std::size_t deepest = 500;

    // What is executed, in its order (ladder_networks.cpp).
    void read_coils(std::size_t end);
    void read_number(std::size_t element);
    void read_block(std::size_t element);
    std::optional<std::size_t> next_in_chain(std::size_t element, const Output& onward);
    void end_chain(std::size_t element, const Output& onward, ladder::Rung& rung);
    Output onward_of(std::size_t element) const;
    bool is_coil(std::size_t element) const;
    std::optional<ladder::Coil> coil_of(std::size_t element) const;
    void push(ladder::Rung rung, std::size_t element);

    /// What lies between the left rail and one inlet, as it is found from right to left.
    struct Wiring {
        PowerGraph graph;
        PowerGraph::Point rail = 0;
        std::map<Output, PowerGraph::Point> points;
        std::map<std::vector<Output>, PowerGraph::Point> joints;  ///< of several outputs
        std::set<Output> begun;  ///< outputs whose point is being made
        bool failed = false;
    };
    // What reaches an inlet (ladder_inlets.cpp).
    std::optional<ladder::Power> power(const Inlet& inlet, std::size_t element);
    PowerGraph::Point point_of(Wiring& wiring, const Inlet& inlet, std::size_t element);
    PowerGraph::Point point_of(Wiring& wiring, const Output& output);
    PowerGraph::Point make_point(Wiring& wiring, const Output& output);
    std::optional<ladder::Power> contact_of(const Element& element) const;
    std::optional<ladder::Power> comparison_of(std::size_t element);
    std::optional<ladder::Power> value_of(const Element& element) const;
    std::optional<ladder::Power> gate_of(std::size_t element);
    std::optional<ladder::Power> block_output(std::size_t element);
    bool is_pure(std::size_t element) const;
    PowerGraph::Rank rank_of(std::size_t element) const;
    // What blocks read, and where functions leave their results (ladder_inlets.cpp).
    std::optional<ladder::Block> block_of(std::size_t element);
    std::optional<ladder::VariableId> target_of(std::size_t element);
    void add_moves(std::size_t element, ladder::Rung& rung);
    bool gives_number(const Output& output) const;
    std::optional<ladder::Operand> operand(std::size_t element, std::string_view name,
                                           ladder::Operand::Kind kind, bool of_bits);
    ladder::Operand worked_out(const Inlet& inlet, std::size_t element);

    const Source& source_;
    const LadderElements& elements_;
    LadderVariables& variables_;
    ladder::Ladder& ladder_;
    std::vector<State> states_;
    std::vector<std::size_t> ends_;  ///< coils, blocks, outVariables in their order
    std::map<std::size_t, ladder::VariableId> results_;  ///< of functions: where the result is
    std::map<std::size_t, ladder::VariableId>
        executed_;  ///< of functions: a bit that holds their ENO
    std::size_t nesting_ = 0;
};

}  // namespace grafwire::plcopen
