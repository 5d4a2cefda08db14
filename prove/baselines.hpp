// SPDX-License-Identifier: MIT
// What others would have said to the same cases. BIC and the sparse regression see what a judge sees: the recordings, the
// stated conditions, the noise where it is given; their forward models are this room's, so they are at home here and a judge
// is not.
#pragma once

#include "prove/verdict.hpp"

namespace prove {

// Every single term and the pairs that hold one of the three best singles, fitted by least squares with white noise; the
// least BIC = chi^2 + k log n is always named, probabilities exp(-BIC/2) (Schwarz 1978, Ann. Stat. 6, 461; as PEtab Select
// ranks models).
Verdict bic_verdict(const BlindCase&);

// Thresholded least squares on the residual after the refit (Brunton, Proctor & Kutz 2016, PNAS 113, 3932): its columns are
// the derivatives by the strength of each term; a coefficient below three of its standard errors leaves. At most two named.
Verdict sparse_verdict(const BlindCase&);

// Names the effect that most keys hold, whatever was recorded.
Verdict commonest_verdict(const Keys&);

// The likelihood-ratio test at 5 % that knows the true term and the true covariance.
Verdict oracle_verdict(const Key&);

}  // namespace prove
