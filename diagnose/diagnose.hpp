// SPDX-License-Identifier: MIT
// Which physics was left out? Refit, locate, name, judge; then predict what was held out, once.
#pragma once

#include "cases/case.hpp"
#include "diagnose/verdict.hpp"
#include "rigs/heap.hpp"
#include "rigs/pile.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace diagnose {

struct Settings {
    std::uint64_t seed = 1;
    int threads = 1;      // the answer does not depend on it
    double alpha = 0.05;  // chance of calling a mismatch where there is none
    // Called now and then with the share done, 0 to 1, and what is done at present; returns false to stop (throws Interrupted).
    std::function<bool(double, const std::string&)> progress{};
    // Pours heaps, each as its setup says; without it they are poured here and forgotten. May throw Interrupted.
    std::function<std::vector<rigs::Heap>(const std::vector<rigs::PileSetup>&)> pour{};
};

struct Interrupted {};

// `open_held_out` is called once, when the verdict is fixed, and fills in the recordings of the experiments whose role is
// held_out; before that they need not be readable. Throws scaling::InvalidInput where the recordings cannot be used.
Verdict diagnose(const cases::Case&, const Settings&,
                 const std::function<void(cases::Case&)>& open_held_out);

}  // namespace diagnose
