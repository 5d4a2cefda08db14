// SPDX-License-Identifier: MIT
// Heaps for `diagnose`: poured side by side, and remembered in a folder by all that decides them, so that cases of one family
// share them.
#pragma once

#include "rigs/heap.hpp"
#include "rigs/pile.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace app {

class PouredHeaps {
  public:
    // `remembered_in` empty: nothing is remembered. `show` hears how many of the heaps asked for together are there, and returns false
    // to stop; one at a time.
    PouredHeaps(std::filesystem::path remembered_in, int threads,
                std::function<bool(std::size_t done, std::size_t of)> show);

    // In the order of the setups. Throws diagnose::Interrupted; what is finished stays remembered.
    std::vector<rigs::Heap> operator()(const std::vector<rigs::PileSetup>&);

    int poured() const { return poured_; }
    int recalled() const { return recalled_; }
    double seconds() const { return seconds_; }  // of one core, for what was poured

  private:
    std::filesystem::path folder_;
    int threads_;
    std::function<bool(std::size_t, std::size_t)> show_;
    int poured_ = 0, recalled_ = 0;
    double seconds_ = 0.0;
};

// One heap as text, every number to its last bit, and back; throws std::runtime_error for text that is not whole.
std::string to_text(const rigs::Heap&);
rigs::Heap heap_of(const std::string& text);

}  // namespace app
