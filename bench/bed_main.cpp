// SPDX-License-Identifier: MIT
// bench_bed [THREADS [NX NY NZ [WARM_UP STEPS]]]: the bed of `similitude bench` on our core, once,
// in one line; for a profiler.
#include "bench/ours.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv) {
    const auto number = [&](int k, int otherwise) {
        return k < argc ? std::atoi(argv[k]) : otherwise;
    };
    engines::Bed bed;
    const int threads = number(1, 2);
    bed.nx = number(2, bed.nx);
    bed.ny = number(3, bed.ny);
    bed.nz = number(4, bed.nz);
    bed.warm_up = number(5, bed.warm_up);
    bed.steps = number(6, bed.steps);
    if (threads < 1 || bed.nx < 3 || bed.ny < 3 || bed.nz < 1 || bed.warm_up < 0 || bed.steps < 1) {
        std::fputs("bench_bed [THREADS [NX NY NZ [WARM_UP STEPS]]], all > 0, NX and NY > 2\n",
                   stderr);
        return 2;
    }
    try {
        const engines::BedFigures f = bench::run_ours(bed, threads);
        std::printf("grains %lld threads %d Mgrain-steps/s %.3f neighbours %.4f kinetic %.4g J\n",
                    static_cast<long long>(f.grains), threads, f.grain_steps_per_second(bed) / 1e6,
                    f.neighbours, f.kinetic_energy);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_bed: %s\n", error.what());
        return 1;
    }
    return 0;
}
