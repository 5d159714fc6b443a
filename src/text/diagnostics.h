#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/location.h"

namespace grafwire {

/// The text of one input, with the name to show in messages ("-" is shown as "<stdin>").
struct SourceFile {
    std::string name;
    std::string text;
};

enum class Severity { warning, error };

/// What a diagnostic is about; tests and tools match on this, never on the wording.
enum class Code {
    unreadable_file,
    not_utf8,
    unexpected_character,
    unexpected_token,
    unterminated_text,
    number_too_large,
    nested_too_deep,
    duration_out_of_range,
    unknown_name,
    duplicate_name,
    transition_without_step,
    step_of_another_graph,
    assignment_to_input,
    continuous_on_internal,
    edge_in_condition,
    macro_not_allowed_here,
    reads_continuous_output,
    output_driven_twice,
    forcing_unknown_graph,
    forcing_foreign_step,
    forcing_circle,
    counter_range,
    not_a_counter,
    not_a_boolean,
    enclosed_twice,
    encloses_twice,
    enclosure_initial_mismatch,
    variable_clash,
    expansion_entry_exit,
    expansion_use,
    not_a_plant_condition,
    contradicting_assumptions,
    no_steps,
    // Warnings.
    unreachable_step,
    graph_without_start,
    constant_receptivity,
    event_without_edge,
    unused_name,
    conflicting_writes,
    wiring_hazard,
    // Stimuli.
    bad_time,
    time_order,
    bad_value,
    // Netlists.
    bad_netlist,
    unsupported_by_style,
    // Programs for PLCs and in other languages.
    beyond_limit,
    unassigned_name,  ///< a warning
    // S7-200 listings and tables of assignment.
    unknown_instruction,
    bad_operand,
    address_out_of_range,
    bad_address,
    bad_network,
    bad_control_flow,
    bad_stack,
    bad_offset,
    program_too_long,
    read_leniently,  ///< a warning: something was put right while reading
    // Programs.
    unsupported_by_language,
    // Ladder diagrams.
    bad_ladder,
};

/// One message with its place. Notes name the other parties (the earlier declaration, the other
/// action, …) and may lie anywhere in the same file.
struct Diagnostic {
    Severity severity = Severity::error;
    Code code = Code::unexpected_token;
    Location where;
    std::string message;

    struct Note {
        Location where;
        std::string message;
    };
    std::vector<Note> notes;
};

/// All that is to be said about one source file.
class Diagnostics {
  public:
    /// Both return the diagnostic so that notes can be added to it; the reference lives until the
    /// next call.
    Diagnostic& error(Code code, Location where, std::string message);
    Diagnostic& warning(Code code, Location where, std::string message);

    bool has_errors() const { return error_count_ != 0; }
    std::size_t error_count() const { return error_count_; }
    const std::vector<Diagnostic>& items() const { return items_; }

    /// Puts the messages in the order of their places; those without a place come first.
    void sort_by_place();

  private:
    std::vector<Diagnostic> items_;
    std::size_t error_count_ = 0;
};

/// The messages as shown to people: `file:line:column: error: message`, the source line, a caret
/// under the column, then the notes in the same form. At most `limit` errors and as many warnings
/// are shown, followed by counts of the rest; 0 shows all.
std::string format_diagnostics(const Diagnostics& diagnostics, const SourceFile& source,
                               std::size_t limit = 0);

/// The declared name nearest to a mistyped one, or empty where none is near enough to suggest: a
/// third of its characters may differ, or one of two. Of equally near names the first is taken.
std::string_view nearest_name(std::string_view mistyped,
                              const std::vector<std::string_view>& names);

/// Reports (as Code::not_utf8, with its place) the first byte at which `text` is not UTF-8.
/// Returns whether the text is well-formed.
bool check_utf8(std::string_view text, Diagnostics& diagnostics);

}  // namespace grafwire
