// SPDX-License-Identifier: MIT
// The file in which the heaps of a map are remembered: CSV, one line for each, written as soon as it is finished. It can be
// committed, read by eye and taken up on another machine; two such files are one by `cat` (docs/scaling-map.md: columns).
#pragma once

#include "verify/scaling_map.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace verify {

// By name and fingerprint of the setup: a heap of other laws is another heap.
using MapHeaps = std::map<std::pair<std::string, std::string>, MapHeap>;

// None where there is no such file. A last line without its end was cut off and is left out. Throws scaling::InvalidInput for
// any other line that is no heap.
MapHeaps read_heaps(const std::filesystem::path&);

// One line more, also while other processes append to the same file; what was cut off before it goes. Throws std::runtime_error.
void append_heap(const std::filesystem::path&, const MapHeap&);

}  // namespace verify
