// SPDX-License-Identifier: MIT
// Random numbers that depend on (seed, number, stream) alone: SplitMix64 (Steele, Lea & Flood 2014, OOPSLA) in counter form.
// The same on every machine and with every standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace prove {

class Dice {
  public:
    Dice(std::uint64_t seed, std::uint64_t number, std::uint64_t stream);
    double uniform();  // (0, 1)
    double uniform(double low, double high);
    double log_uniform(double low, double high);
    bool chance(double probability);
    std::size_t pick(std::size_t count);  // 0 to count - 1
    template <class T>
    const T& of(const std::vector<T>& items) {
        return items[pick(items.size())];
    }
    double normal();    // standard deviation 1
    double student4();  // Student's t with 4 degrees of freedom, scaled to standard deviation 1

  private:
    std::uint64_t next();
    std::uint64_t state_;
};

double rounded(double value, int digits);  // significant ones

}  // namespace prove
