// SPDX-License-Identifier: MIT
#pragma once

#include "app/diagnose.hpp"

namespace app {

// The whole command line: reads it, runs the verb, says on standard error what went wrong. Returns
// the exit code. Without a judge there is no verb `diagnose`.
int program(int argc, char** argv, const Judge&);

}  // namespace app
