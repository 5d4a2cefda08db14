// SPDX-License-Identifier: MIT
// A grain in the air above a plate, to its next touch, and at rest on it.
#pragma once

#include "rigs/drop_path.hpp"
#include "rigs/on_plate.hpp"

namespace rigs {

// Tells what was passed on the way.
struct DropRows {
    Rows rows;
    DropPath& path;
    bool done() const { return rows.done(); }
    void add(DropState state) {
        state.t = rows.time();
        path.states.push_back(state), ++rows.next;
    }
};

// The state along the parabola, `duration` later.
DropState thrown(const DropWorld&, DropState, double duration);

// Flies until the grain touches the plate and is approaching it; true there. False where the rows end before, or it never
// comes down.
bool fly(const DropWorld&, DropState&, DropRows&);

// Lies, slides or rolls on the plate to the end of the rows, or until a plate that vibrates lets it go; the state is then that
// of the grain at the plate's surface.
void stay(const DropWorld&, DropState&, DropRows&);

}  // namespace rigs
