#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the language of GRAFCETs are about.
namespace code {
inline constexpr Code duration_out_of_range{"duration-out-of-range"};
inline constexpr Code transition_without_step{"transition-without-step"};
inline constexpr Code step_of_another_graph{"step-of-another-graph"};
inline constexpr Code assignment_to_input{"assignment-to-input"};
inline constexpr Code continuous_on_internal{"continuous-on-internal"};
inline constexpr Code edge_in_condition{"edge-in-condition"};
inline constexpr Code macro_not_allowed_here{"macro-not-allowed-here"};
inline constexpr Code reads_continuous_output{"reads-continuous-output"};
inline constexpr Code output_driven_twice{"output-driven-twice"};
inline constexpr Code forcing_unknown_graph{"forcing-unknown-graph"};
inline constexpr Code forcing_foreign_step{"forcing-foreign-step"};
inline constexpr Code forcing_circle{"forcing-circle"};
inline constexpr Code counter_range{"counter-range"};
inline constexpr Code not_a_counter{"not-a-counter"};
inline constexpr Code not_a_boolean{"not-a-boolean"};
inline constexpr Code enclosed_twice{"enclosed-twice"};
inline constexpr Code encloses_twice{"encloses-twice"};
inline constexpr Code enclosure_initial_mismatch{"enclosure-initial-mismatch"};
inline constexpr Code variable_clash{"variable-clash"};
inline constexpr Code expansion_entry_exit{"expansion-entry-exit"};
inline constexpr Code expansion_use{"expansion-use"};
inline constexpr Code not_a_plant_condition{"not-a-plant-condition"};
inline constexpr Code contradicting_assumptions{"contradicting-assumptions"};
inline constexpr Code no_steps{"no-steps"};
inline constexpr Code unreachable_step{"unreachable-step"};
inline constexpr Code graph_without_start{"graph-without-start"};
inline constexpr Code constant_receptivity{"constant-receptivity"};
inline constexpr Code event_without_edge{"event-without-edge"};
inline constexpr Code unused_name{"unused-name"};
inline constexpr Code conflicting_writes{"conflicting-writes"};
}  // namespace code

}  // namespace grafwire
