// SPDX-License-Identifier: MIT
// Random numbers that depend on (seed, stream, index) alone, never on who drew before: Philox 4x32-10 of Random123
// (Salmon et al. 2011, doi:10.1145/2063384.2063405).
#pragma once

#include <cstdint>

namespace dem_min {

struct RandomStream {
    std::uint64_t seed;
    std::uint64_t stream;  // what for: feeding positions, sizes, ...

    // The index-th number, uniform on [0, 1), a multiple of 2^-53.
    double uniform(std::uint64_t index) const;
};

}  // namespace dem_min
