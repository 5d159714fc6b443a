#pragma once

#include <memory>

#include "core/arguments.h"
#include "core/check_progress.h"
#include "core/json.h"
#include "text/message.h"

namespace grafwire::playground {

class Runs;

/// What requests are answered with besides their arguments.
struct Asked {
    Runs& runs;
    const CheckProgress& progress;
};

/// `{"error":"…"}`
Json error_answer(const Localized& why, Language language);

std::unique_ptr<Runs> make_runs();

// Each answers one request; README.md says what goes in and out.

Json answer_version(const Arguments& arguments, const Asked& asked);
Json answer_words(const Arguments& arguments, const Asked& asked);
Json answer_chart(const Arguments& arguments, const Asked& asked);
Json answer_format(const Arguments& arguments, const Asked& asked);
Json answer_draw(const Arguments& arguments, const Asked& asked);
Json answer_schematic(const Arguments& arguments, const Asked& asked);
Json answer_equations(const Arguments& arguments, const Asked& asked);
Json answer_exports(const Arguments& arguments, const Asked& asked);
Json answer_export(const Arguments& arguments, const Asked& asked);
Json answer_script(const Arguments& arguments, const Asked& asked);
Json answer_check(const Arguments& arguments, const Asked& asked);

Json open_run(const Arguments& arguments, const Asked& asked);
Json do_in_run(const Arguments& arguments, const Asked& asked);
Json take_back_in_run(const Arguments& arguments, const Asked& asked);
Json answer_state_of_run(const Arguments& arguments, const Asked& asked);
Json draw_run(const Arguments& arguments, const Asked& asked);
Json answer_stimuli_of_run(const Arguments& arguments, const Asked& asked);
Json close_run(const Arguments& arguments, const Asked& asked);

}  // namespace grafwire::playground
