// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace app {

// How far a long task is, on standard error: on a terminal one line that is written over once a
// second, elsewhere a line of its own every ten seconds.
class Progress {
  public:
    explicit Progress(bool wanted);
    ~Progress();  // leaves an empty line behind on a terminal
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // What had been done before the task went on; without it the first `show` says so.
    void start(double done);

    bool due() const;  // whether `show` would write now

    // done/of in any unit that grows evenly with time; the time left is guessed from it.
    void show(double done, double of, const std::string& what);

  private:
    using Clock = std::chrono::steady_clock;
    bool wanted_, terminal_;
    bool line_open_ = false;
    double first_done_ = -1.0;
    Clock::time_point start_, last_;
};

}  // namespace app
