// SPDX-License-Identifier: MIT
#include "calibrate/observations.hpp"

namespace calibrate {

Replayed replayed(const cases::Case& c, const scaling::ScaleInput& input) {
    const scaling::ScaleStudy study = scaling::study(input);
    Replayed r{read_published(c.path), {}, {}, {}};
    r.replay = replay(r.published, study);
    r.audit = audit(audit_input(r.published));
    r.observations = screening_observations(r.published, r.replay, r.audit);
    for (const auto& more : {refinement_observations(r.published, r.replay),
                             scaling_observations(r.published, c, input, study)})
        r.observations.insert(r.observations.end(), more.begin(), more.end());
    return r;
}

}  // namespace calibrate
