// SPDX-License-Identifier: MIT
// Heaps poured to know what the scan of a pile would be in another world: a first design over all that may be free or left out, an
// emulator of the reduced scan, and more heaps where they are asked for (docs/diagnose-piles.md).
#pragma once

#include "diagnose/bulk_effects.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/problem.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace diagnose {

class Piles {
  public:
    // Pours the first heaps of each apparatus of which the case has a recording to be fitted. Throws Interrupted.
    Piles(const cases::Case&, const Settings&);
    ~Piles();
    Piles(const Piles&) = delete;
    Piles& operator=(const Piles&) = delete;

    const std::vector<BulkEffect>& effects() const;  // that may have been left out of any of them

    // The recording reduced, its emulator as forward model, covariance of one heap about it. A pile of another apparatus is known
    // by fresh heaps in each world it is asked for.
    Record record(const cases::Experiment&) const;
    bool knows(const cases::Experiment&) const;
    bool same_apparatus(const cases::Experiment&, const cases::Experiment&) const;

    struct Asked {
        const cases::Experiment* experiment;
        rigs::World world;
    };
    // More heaps, one for each; then the emulators know them. `last`: also their hyperparameters are found anew. Returns how far
    // the new heaps were from what had been foreseen: mean square over the numbers, in covariances that had been foreseen, 1 where
    // these were right.
    double learn(const std::vector<Asked>&, bool last) const;

    struct Check {
        int heaps;
        double emulator;     // p-value of the mean of fresh heaps under what the emulator says
        double recording;    // p-value of all recordings under these fresh heaps
        double chi_squared;  // of all recordings about the fresh heaps
    };
    // Fresh heaps in one world, beside recordings of one apparatus. `added` by the instrument to the numbers of each.
    Check confirmed(const std::vector<const Record*>&, const rigs::World&,
                    const std::vector<Eigen::VectorXd>& added, int heaps) const;

    int heaps_poured() const;
    double softening() const;                // least E'/E; 1: none
    std::vector<std::string> words() const;  // how all this was found, for the reader

  private:
    struct Inside;
    std::unique_ptr<Inside> in_;
};

// Whether a pile's profile is to be fitted, or a pile is held out.
bool has_piles(const cases::Case&);

}  // namespace diagnose
