// SPDX-License-Identifier: MIT
// Memory for large arrays: what one owner writes no other one sees.
#include "dem_min/large_pages.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <vector>

namespace {

struct Owned {
    unsigned char* bytes;
    std::size_t size;
    unsigned char mark;
};

bool whole(const Owned& block) {
    for (std::size_t k = 0; k < block.size; ++k)
        if (block.bytes[k] != block.mark) return false;
    return true;
}

}  // namespace

TEST_CASE("memory: blocks do not overlap, whatever their sizes and however often they come back",
          "[dem_min][memory]") {
    std::vector<Owned> held;
    std::size_t size = dem_min::smallest_block;
    for (int k = 0; k < 400; ++k) {
        size = size * 13 / 10 + 1;  // from one page to beyond the largest that share a chunk
        if (size > 5'000'000) size = dem_min::smallest_block + static_cast<std::size_t>(k);
        Owned one{static_cast<unsigned char*>(dem_min::take_block(size)), size,
                  static_cast<unsigned char>(k)};
        REQUIRE(reinterpret_cast<std::uintptr_t>(one.bytes) % 64 == 0);
        std::memset(one.bytes, one.mark, one.size);
        held.push_back(one);
        if (k % 3 != 2) continue;
        const std::size_t old = held.size() / 2;
        REQUIRE(whole(held[old]));
        dem_min::give_back_block(held[old].bytes, held[old].size);
        held.erase(held.begin() + static_cast<std::ptrdiff_t>(old));
    }
    for (const Owned& one : held) {
        REQUIRE(whole(one));
        dem_min::give_back_block(one.bytes, one.size);
    }
}
