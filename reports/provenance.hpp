// SPDX-License-Identifier: MIT
// What it takes to repeat a result: which program, which command, which chance.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reports {

struct Provenance {
    std::string version, git, compiler;
    std::string command;               // as typed
    std::string case_path;             // empty where no case was read
    std::vector<std::uint64_t> seeds;  // empty where nothing is drawn by chance
    std::optional<int> threads;
};

}  // namespace reports
