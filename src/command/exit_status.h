#pragma once

namespace grafwire {

/// What the program ends with.
enum ExitStatus : int {
    done = 0,
    answer_is_no = 1,
    bad_request = 2,
    out_of_bounds = 3,
};

}  // namespace grafwire
