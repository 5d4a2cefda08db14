// SPDX-License-Identifier: MIT
#include "app/progress.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace app {

Progress::Progress(bool wanted)
    : shown_(wanted && isatty(STDERR_FILENO) != 0), start_(Clock::now()) {}

Progress::~Progress() {
    if (shown_ && first_done_ >= 0.0) fmt::print(stderr, "\r\033[K");
}

void Progress::show(double done, double of, const std::string& what) {
    const auto now = Clock::now();
    if (!shown_ || (first_done_ >= 0.0 && now - last_ < std::chrono::milliseconds(100))) return;
    if (first_done_ < 0.0) {
        first_done_ = done;
        start_ = now;
    }
    last_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double made = done - first_done_;
    const std::string left =
        made > 0.0 && seconds > 1.0
            ? reports::quantity(std::max(0.0, of - done) / made * seconds, "s") + " left"
            : "";
    fmt::print(stderr, "\r\033[K{:3.0f} %  {}  {}", 100.0 * std::min(1.0, done / of), what, left);
    std::fflush(stderr);
}

}  // namespace app
