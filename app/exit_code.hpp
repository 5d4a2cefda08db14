// SPDX-License-Identifier: MIT
#pragma once

namespace app {

// What the shell gets; the same for every verb.
enum ExitCode : int {
    fine = 0,
    internal_fault = 1,
    bad_input = 2,
    answer_is_no = 3,
    cannot_tell = 4,
    outside_validity = 5,
    interrupted = 130  // after a checkpoint
};

}  // namespace app
