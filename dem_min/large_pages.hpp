// SPDX-License-Identifier: MIT
// Memory for arrays of a page and more, out of chunks that the system may map in pages of 2 MB. A million grains have arrays of
// some 20 000 places in memory, and with pages of 4 kB each new piece costs a walk through the tables of pages.
#pragma once

#include <cstddef>

namespace dem_min {

constexpr std::size_t smallest_block = 4096;  // bytes; smaller ones are left to operator new

// At least `bytes` bytes (>= smallest_block), at the beginning of a cache line. Throws std::bad_alloc. May be called by several
// threads at once.
void* take_block(std::size_t bytes);
void give_back_block(void* block, std::size_t bytes);  // the same number as when it was taken

}  // namespace dem_min
