// SPDX-License-Identifier: MIT
#include "app/forward_curves.hpp"

#include "cases/rig_table.hpp"

#include <string>

namespace app {

std::vector<cases::Column> forward_curves(const cases::Experiment& e, const rigs::World& world,
                                          const rigs::Ordinates& at) {
    return curve_columns(e, rigs::forward_model(e)->predict(world, at), at);
}

std::vector<cases::Column> curve_columns(const cases::Experiment& e, const rigs::Curves& curves,
                                         const rigs::Ordinates& at) {
    const cases::RigRule& rig = cases::rig_rule(e.rig);
    const auto unit = [&](const std::string& channel) {
        return cases::find_channel(rig, channel)->units.front();
    };
    const std::string ordinate = rigs::ordinate_name(e);
    std::vector<cases::Column> columns{{ordinate, unit(ordinate), at.at, {}}};
    for (const auto& [name, values] : curves) columns.push_back({name, unit(name), values, {}});
    if (!at.retract.empty()) {
        columns.push_back({"branch", "", {}, {}});
        for (const bool back : at.retract)
            columns.back().words.emplace_back(back ? "retract" : "approach");
    }
    return columns;
}

}  // namespace app
