// SPDX-License-Identifier: MIT
#include "bench/machine.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <unistd.h>

namespace bench {

namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

}  // namespace

Machine this_machine() {
    double load = 0.0;
    getloadavg(&load, 1);
    return {
        processor_name(), static_cast<int>(std::thread::hardware_concurrency()),
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)),
        load};
}

bool busy(const Machine& m) { return m.load_before > 0.125 * m.cores; }

double triad_bandwidth(double bytes, int threads) {
    using Clock = std::chrono::steady_clock;
    const auto size = static_cast<std::ptrdiff_t>(std::max(1.0, bytes / (3 * sizeof(double))));
    // Left as they come: the first to write a page gets it near, and that shall be its thread.
    const std::unique_ptr<double[]> a(new double[static_cast<std::size_t>(size)]);
    const std::unique_ptr<double[]> b(new double[static_cast<std::size_t>(size)]);
    const std::unique_ptr<double[]> c(new double[static_cast<std::size_t>(size)]);
    // Small arrays are gone through several times in one measurement, for the clock to resolve it.
    const int rounds = static_cast<int>(std::max<std::ptrdiff_t>(1, 4'000'000 / size));
    double fastest = 1e300;  // s: other programs only ever slow one down
    double *const pa = a.get(), *const pb = b.get(), *const pc = c.get();
#pragma omp parallel for schedule(static) num_threads(threads)
    for (std::ptrdiff_t k = 0; k < size; ++k) {
        pa[k] = 0.0;
        pb[k] = 1.0;
        pc[k] = 2.0;
    }
    for (int pass = 0; pass < 8; ++pass) {
        const Clock::time_point start = Clock::now();
        for (int round = 0; round < rounds; ++round) {
            const double factor = 3.0 + round;
#pragma omp parallel for schedule(static) num_threads(threads)
            for (std::ptrdiff_t k = 0; k < size; ++k) pa[k] = pb[k] + factor * pc[k];
        }
        fastest = std::min(fastest, std::chrono::duration<double>(Clock::now() - start).count());
    }
    if (pa[size - 1] != 1.0 + 2.0 * (2.0 + rounds))  // also keeps the loop from being left out
        throw std::logic_error("triad: wrong sum");
    return 3.0 * sizeof(double) * static_cast<double>(size) * rounds / fastest;
}

}  // namespace bench
