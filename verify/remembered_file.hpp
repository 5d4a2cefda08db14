// SPDX-License-Identifier: MIT
// Files in which finished runs are remembered: whole or not there, named by a fingerprint of what was run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace verify {

std::uint64_t fnv1a(const std::string&);

// By way of a file beside it, so that an interrupt leaves no half. Makes the folder. Throws std::runtime_error.
void write_whole(const std::filesystem::path&, const std::string& text);

}  // namespace verify
