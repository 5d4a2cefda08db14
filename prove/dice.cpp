// SPDX-License-Identifier: MIT
#include "prove/dice.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace prove {
namespace {

std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

}  // namespace

Dice::Dice(std::uint64_t seed, std::uint64_t number, std::uint64_t stream)
    : state_(mixed(mixed(mixed(seed + 0x9e3779b97f4a7c15ULL) + number) + stream)) {}

std::uint64_t Dice::next() { return mixed(state_ += 0x9e3779b97f4a7c15ULL); }

double Dice::uniform() { return (static_cast<double>(next() >> 11) + 0.5) * 0x1.0p-53; }
double Dice::uniform(double low, double high) { return low + (high - low) * uniform(); }
double Dice::log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
bool Dice::chance(double probability) { return uniform() < probability; }
std::size_t Dice::pick(std::size_t count) {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
}
double Dice::normal() { return gsl_cdf_ugaussian_Pinv(uniform()); }
double Dice::student4() { return gsl_cdf_tdist_Pinv(uniform(), 4.0) / std::sqrt(2.0); }

double rounded(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return std::strtod(text, nullptr);
}

}  // namespace prove
