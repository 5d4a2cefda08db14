// SPDX-License-Identifier: MIT
// Which cases a campaign has, and which of them are done: told by files, so that it can be stopped and taken up again.
#pragma once

#include "prove/blind_case.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prove {

struct Extent {
    std::uint64_t seed = 1;
    int cases = 1200;
    std::optional<Kind> kind{};  // only this one; then the first `cases` numbers of it
    std::string rig{};           // only this one
    std::string shard = "1/1";   // i/n, i from 1
};

// Numbers from 1 on, rising. Throws scaling::InvalidInput for an unknown rig, a shard that is none, fewer than one case.
std::vector<int> numbers_of(const Extent&);

bool is_written(int number, const std::filesystem::path& cases, const std::filesystem::path& keys);

// A verdict is there and whole: VERDICTS/case-0001.json with its last brace.
bool is_judged(int number, const std::filesystem::path& verdicts);

}  // namespace prove
