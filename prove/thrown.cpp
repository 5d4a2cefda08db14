// SPDX-License-Identifier: MIT
// The rig `impact`: one grain at many angles, one course of the contact for all that share an e.
#include "prove/collision.hpp"
#include "prove/motions.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace prove {

std::vector<double> impact(const World& w, const Setup& s) {
    const std::size_t rows = s.at.size();
    std::vector<double> all(s.size());
    std::optional<std::pair<double, std::vector<ContactNode>>> course;
    for (std::size_t k = 0; k < rows; ++k) {
        const double vn = s.speed * std::cos(s.at[k]), vt = s.speed * std::sin(s.at[k]);
        const double e = restitution_at(w, vn, s.at[k]);
        if (!course || course->first != e) course.emplace(e, hertz_course(e));
        const NormalContact contact = scaled_course(s, course->second, vn, e);
        const Slip out = after_contact(w, s, contact, {vt, s.spin});
        for (std::size_t c = 0; c < s.recorded.size(); ++c) {
            double& y = all[c * rows + k];
            switch (s.recorded[c]) {
                case Channel::rebound_angle:
                    y = std::atan2(out.velocity, e * vn);
                    break;
                case Channel::normal_restitution:
                    y = e;
                    break;
                case Channel::tangential_restitution:
                    y = vt == 0.0 ? std::numeric_limits<double>::quiet_NaN() : out.velocity / vt;
                    break;
                default:
                    y = out.spin;
            }
        }
    }
    return all;
}

}  // namespace prove
