// SPDX-License-Identifier: MIT
// Four threads add to their own quarter, then read the quarter of another. The loops are parted by a barrier, or not.
#include <cstddef>
#include <cstdio>
#include <vector>

int main() {
    constexpr std::size_t n = 4000;
    std::vector<double> mine(n, 1.0), theirs(n, 0.0);
    for (int round = 0; round < 20; ++round) {
#pragma omp parallel num_threads(4)
        {
#ifdef WITH_A_RACE
#pragma omp for schedule(static) nowait
#else
#pragma omp for schedule(static)
#endif
            for (std::size_t k = 0; k < n; ++k) mine[k] += 1.0;
#pragma omp for schedule(static)
            for (std::size_t k = 0; k < n; ++k) theirs[k] = mine[n - 1 - k];
        }
    }
    std::printf("%g\n", theirs[0]);
}
