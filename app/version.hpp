// SPDX-License-Identifier: MIT
#pragma once

namespace app {

extern const char* const version;   // "0.1.0"
extern const char* const git;       // "a1b2c3d", "a1b2c3d-dirty", or "unknown" outside a checkout
extern const char* const compiler;  // "GNU 12.2.0, Release"

}  // namespace app
