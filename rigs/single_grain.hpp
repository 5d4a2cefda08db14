// SPDX-License-Identifier: MIT
// The forward models of the four rigs with a single grain; one source file each. Docs: drop.md, incline.md, impact.md,
// pull-off.md. All in SI.
#pragma once

#include "rigs/forward.hpp"
#include "rigs/one_grain.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace rigs {

std::unique_ptr<ForwardModel> drop_model(const cases::Experiment&);
std::unique_ptr<ForwardModel> incline_model(const cases::Experiment&);
std::unique_ptr<ForwardModel> impact_model(const cases::Experiment&);
std::unique_ptr<ForwardModel> pull_off_model(const cases::Experiment&);

// What can show in the channels of each, gravity and the contact laws among them.
std::set<std::string> drop_effects();
std::set<std::string> incline_effects();
std::set<std::string> impact_effects();
std::set<std::string> pull_off_effects();

// Throws scaling::InvalidInput where the model holds physics that no rig with a single grain shows. What acts in some of them
// only (docs/effects.md) is no mistake in the others: a case may hold several rigs.
void refuse_physics_of_many(const cases::Case&, const std::string& rig);

// Ordinates in rising order without those that are no number, and where each came from: a rig runs through time only once.
struct InOrder {
    explicit InOrder(const std::vector<double>& at);
    std::vector<double> at;
    std::vector<std::size_t> from;
};

}  // namespace rigs
