// SPDX-License-Identifier: MIT
#include "verify/scaling_map.hpp"

namespace verify {

const char* to_string(MapVerdict verdict) {
    switch (verdict) {
        case MapVerdict::holds:
            return "holds";
        case MapVerdict::breaks:
            return "breaks";
        case MapVerdict::not_decided:
            return "not_decided";
        case MapVerdict::not_poured:
            return "not_poured";
    }
    return "";
}

std::optional<MapVerdict> map_verdict_named(const std::string& name) {
    for (const MapVerdict v :
         {MapVerdict::holds, MapVerdict::breaks, MapVerdict::not_decided, MapVerdict::not_poured})
        if (name == to_string(v)) return v;
    return std::nullopt;
}

const std::vector<MapMargin>& map_margins() {
    static const std::vector<MapMargin> all = {
        {"angle_flank_20_80", "deg", 2.5, false,
         "half of the 5 deg by which readings of one heap differ in Niu et al. (2026)"},
        {"angle_two_h_over_d", "deg", 2.5, false, "the same"},
        {"packing_fraction", "1", 0.01, false, "2.5 % of a loose sticky heap's, as in verify"},
        {"coordination", "1", 0.15, false, "4 % of a loose sticky heap's contacts, as in verify"},
        {"height_at_0.1_R", "D", 0.03, false,
         "the axis of a cone on the base D rises by 0.03 D from 30 to 32.5 deg"},
        {"height_at_0.3_R", "D", 0.03, false, "the same height everywhere"},
        {"height_at_0.5_R", "D", 0.03, false, "the same height everywhere"},
        {"height_at_0.7_R", "D", 0.03, false, "the same height everywhere"},
        {"force_per_area", "rho g D", 0.01, false,
         "a tenth of what contacts carry in the heap of Bond 10 that was poured first, to see what "
         "a heap costs"},
    };
    return all;
}

const std::vector<MapMargin>& impact_margins() {
    static const std::vector<MapMargin> all = {
        {"pull_off_force", "m g", 0.05, true,
         "a twentieth: what friction and restitution of a powder are known to, at best"},
        {"sticking_speed", "sqrt(g d)", 0.05, true, "the same share"},
        {"restitution", "1", 0.05, true,
         "the same share, at ten times the reference's sticking speed"},
        {"contact_radius", "R", 0.05, true, "the same share, without load"},
        {"tear_off_gap", "R", 0.05, true, "the same share"},
    };
    return all;
}

}  // namespace verify
