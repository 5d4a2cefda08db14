// SPDX-License-Identifier: MIT
// A blind case in the making.
#pragma once

#include "prove/blind_case.hpp"

#include <vector>

namespace prove {

struct Draft {
    Skeleton sk;
    World world;              // with the secret
    std::vector<Term> terms;  // concealed
    Key key;
    UserRun run{};  // kind numerical
    bool found = false;
};

// The key's names: case, kind, what is concealed.
void name(Draft&, const Plan&, int number);
// Its figures: mismatch, parameters with the oracle's errors, separation.
void tell(Draft&, const Plan&);
// And what the oracle and the base model predict of the held-out recordings (shape of predict() over all experiments).
void tell_held_out(Draft&, const Eigen::VectorXd& recordings);

}  // namespace prove
