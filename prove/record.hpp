// SPDX-License-Identifier: MIT
// A further recording of a blind case's world: what a judge asks for, made.
#pragma once

#include "cases/value.hpp"
#include "prove/blind_case.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace prove {

// The files of the case with one more experiment of role fit, "asked-1". `wish` is the object `next_experiment` of a verdict:
// `rig`, `conditions` and `grain` (texts with units), `channels`, `ordinate` (`from`, `to`, `rows`), `noise` (channel ->
// standard deviation); numbers are SI. Any of the four rigs: the world is the same. What is left out comes from the case's
// first experiment. Conditions are exact; the noise is the case's own instrument where it records that channel, whatever is
// wished, else what is wished, else 2 % of the range. Throws scaling::InvalidInput for what the rig does not have.
std::map<std::string, std::string> record(const BlindCase&, std::uint64_t seed,
                                          const cases::Value& wish);

}  // namespace prove
