#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "ladder/ladder.h"
#include "plcopen/plcopen_elements.h"
#include "plcopen/plcopen_variables.h"
#include "plcopen/power_graph.h"

namespace grafwire::ladder {

/// Makes rungs of the elements of an LD body (see plcopen_networks.cpp).
class PlcopenNetworks {
  public:
    PlcopenNetworks(const PlcopenSource& source, const PlcopenElements& elements,
                    PlcopenVariables& variables, Ladder& ladder);

    void read();

  private:
    enum class State : std::uint8_t { waits, begun, done };
    static constexpr std::size_t most_contacts = 20'000;
    static constexpr std::size_t deepest = 500;

    // What is executed, in its order.
    void read_coils(std::size_t end);
    void read_number(std::size_t element);
    void read_block(std::size_t element);
    std::optional<Block> block_of(std::size_t element);
    std::optional<VariableId> target_of(std::size_t element);
    void add_moves(std::size_t element, Rung& rung);
    std::optional<std::size_t> next_in_chain(std::size_t element, const PlcopenOutput& onward);
    void end_chain(std::size_t element, const PlcopenOutput& onward, Rung& rung);
    PlcopenOutput onward_of(std::size_t element) const;
    bool is_coil(std::size_t element) const;
    bool gives_number(const PlcopenOutput& output) const;
    std::optional<Operand> operand(std::size_t element, std::string_view name, Operand::Kind kind,
                                   bool of_bits);
    Operand worked_out(const PlcopenInlet& inlet, std::size_t element);
    std::optional<Coil> coil_of(std::size_t element) const;
    void push(Rung rung, std::size_t element);

    // What power passes.
    struct Way {
        PowerGraph graph;
        PowerGraph::Point rail = 0;
        std::map<PlcopenOutput, PowerGraph::Point> points;
        std::map<std::vector<PlcopenOutput>, PowerGraph::Point> joints;  ///< of several outputs
        std::set<PlcopenOutput> begun;  ///< outputs whose point is being made
        bool failed = false;
    };
    std::optional<Power> power(const PlcopenInlet& inlet, std::size_t element);
    PowerGraph::Point point_of(Way& way, const PlcopenInlet& inlet, std::size_t element);
    PowerGraph::Point point_of(Way& way, const PlcopenOutput& output);
    PowerGraph::Point make_point(Way& way, const PlcopenOutput& output);
    std::optional<Power> contact_of(const PlcopenElement& element) const;
    std::optional<Power> comparison_of(std::size_t element);
    std::optional<Power> value_of(const PlcopenElement& element) const;
    std::optional<Power> gate_of(std::size_t element);
    std::optional<Power> block_output(std::size_t element);
    bool is_pure(std::size_t element) const;
    std::int64_t rank_of(std::size_t element) const;

    const PlcopenSource& source_;
    const PlcopenElements& elements_;
    PlcopenVariables& variables_;
    Ladder& ladder_;
    std::vector<State> states_;
    std::vector<std::size_t> ends_;               ///< coils, blocks, outVariables in their order
    std::map<std::size_t, VariableId> results_;   ///< of functions: where the result is
    std::map<std::size_t, VariableId> executed_;  ///< of functions: a bit that holds their ENO
    std::size_t nesting_ = 0;
};

}  // namespace grafwire::ladder
