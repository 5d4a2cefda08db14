// SPDX-License-Identifier: MIT
#include "calibrate/observations.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace calibrate {

namespace {

void add_remarks(std::vector<Observation>& all, const std::vector<Remark>& remarks) {
    for (const Remark& remark : remarks) {
        const auto found = std::find_if(all.begin(), all.end(), [&](const Observation& o) {
            return o.name == remark.name && o.topic == remark.topic;
        });
        if (found == all.end()) {
            all.push_back({remark.topic, remark.name, std::numeric_limits<double>::quiet_NaN(), "1",
                           remark.where, scaling::Judgement::caution, remark.text});
            continue;
        }
        found->where = remark.where;
        if (!remark.text.empty()) found->text += "; " + remark.text;
    }
}

// Findings of one topic together, topics in the order of their first finding.
std::vector<Observation> by_topic(const std::vector<Observation>& all) {
    std::vector<std::string> topics;
    for (const Observation& o : all)
        if (std::find(topics.begin(), topics.end(), o.topic) == topics.end())
            topics.push_back(o.topic);
    std::vector<Observation> sorted;
    for (const std::string& topic : topics)
        for (const Observation& o : all)
            if (o.topic == topic) sorted.push_back(o);
    return sorted;
}

}  // namespace

Replayed replayed(Published published, const cases::Case& c, const scaling::ScaleInput& input) {
    const scaling::ScaleStudy study = scaling::study(input);
    Replayed r{std::move(published), {}, {}, {}};
    r.replay = replay(r.published, study);
    r.audit = audit(audit_input(r.published));
    r.observations = screening_observations(r.published, r.replay, r.audit);
    for (const auto& more : {refinement_observations(r.published, r.replay),
                             scaling_observations(r.published, c, input, study)})
        r.observations.insert(r.observations.end(), more.begin(), more.end());
    add_remarks(r.observations, r.published.remarks);
    r.observations = by_topic(r.observations);
    return r;
}

}  // namespace calibrate
