// SPDX-License-Identifier: MIT
// Verdicts made up by hand, for reports to show; none comes from a judge.
#pragma once

#include "diagnose/verdict.hpp"

// Air drag named in drops: one curve fitted, one held out, gates of all three results, a next
// recording.
diagnose::Verdict air_drag_verdict();

// A force of the distance that nothing explains, in a force curve with two branches.
diagnose::Verdict unknown_verdict();

// One recording that says nothing: no probabilities, no scores, numbers that are none.
diagnose::Verdict undecided_verdict();
