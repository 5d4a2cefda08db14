// SPDX-License-Identifier: MIT
#include "app/progress.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sys/ioctl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr std::chrono::seconds on_a_terminal{1}, elsewhere{10};

// Of the terminal on standard error; 80 where it does not say.
std::size_t terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

}  // namespace

Progress::Progress(bool wanted)
    : wanted_(wanted), terminal_(isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
    if (line_open_) fmt::print(stderr, "\r\033[K");
}

void Progress::start(double done) {
    first_done_ = done;
    start_ = Clock::now();
}

bool Progress::due() const {
    return wanted_ && Clock::now() - last_ >= (terminal_ ? on_a_terminal : elsewhere);
}

void Progress::show(double done, double of, const std::string& what) {
    if (first_done_ < 0.0) start(done);
    if (!due()) return;
    last_ = Clock::now();
    const double seconds = std::chrono::duration<double>(last_ - start_).count();
    const double made = done - first_done_;
    const std::string left =
        made > 0.0 ? reports::quantity(std::max(0.0, of - done) / made * seconds, "s") + " left  "
                   : "";
    const std::string line =
        fmt::format("{:3.0f} %  {}{}", 100.0 * std::min(1.0, done / of), left, what);
    if (terminal_)
        fmt::print(stderr, "\r{}\033[K", line.substr(0, terminal_columns() - 1));
    else
        fmt::print(stderr, "{}\n", line);
    line_open_ = terminal_;
    std::fflush(stderr);
}

}  // namespace app
