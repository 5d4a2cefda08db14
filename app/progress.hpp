// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace app {

// One line on standard error that is written over and over, on a terminal only, ten times a second
// at most.
class Progress {
  public:
    explicit Progress(bool wanted);
    ~Progress();  // leaves an empty line behind
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // done/of in any unit that grows evenly with time; the time left is guessed from it.
    void show(double done, double of, const std::string& what);

  private:
    using Clock = std::chrono::steady_clock;
    bool shown_;
    double first_done_ = -1.0;
    Clock::time_point start_, last_;
};

}  // namespace app
