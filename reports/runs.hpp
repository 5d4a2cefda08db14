// SPDX-License-Identifier: MIT
// Runs of the rigs as sections of a report: what came of it in words, one figure, a table of what
// was measured.
#pragma once

#include "cases/csv.hpp"
#include "reports/verdict.hpp"
#include "rigs/drop.hpp"
#include "rigs/flow.hpp"
#include "rigs/measure.hpp"
#include "rigs/pile.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reports {

// Cells of a table as plain text; the first row is the heading. The first and the last column are
// words, what stands between them numbers. Shape [rows][columns].
using TextTable = std::vector<std::vector<std::string>>;

struct Figure {
    std::string svg, caption;
};

struct RunSection {
    std::string name;
    Verdict verdict;
    std::vector<std::string> notes;  // one line each
    Figure figure;
    TextTable quantities;           // may be empty
    std::vector<Figure> intervals;  // one per quantity; may be empty
};

// Mean height of a heap over all azimuths, in grain diameters.
struct HeapProfile {
    std::vector<double> r, z;
};

// The repeats of one system, one profile per seed.
struct HeapGroup {
    std::string label;
    std::vector<HeapProfile> profiles;
};

// Mean of each group as a line and, of two seeds and more, lowest to highest as a band. Groups with
// other radii than their first profile's are read off by straight lines between points. Empty
// without a profile.
Figure profile_figure(const std::vector<HeapGroup>&, const std::string& id);

// One finished run of the rig `pile`: angle by every estimator, whether a heap formed, packing,
// coordination.
RunSection pile_section(const std::string& name, const rigs::PileRecord&);

// A heap that some program left: the same; contacts by geometry. Without a base there is nothing but sizes and contacts.
RunSection heap_section(const std::string& name, const rigs::Measured&);

// Angle of repose by every estimator, with its spread over sectors or views.
TextTable angle_table(const std::vector<std::pair<rigs::Estimator, std::optional<rigs::Angle>>>&);

// Criteria of a heap that were not met, with value and rule; empty where all were.
std::string failed_criteria(const rigs::Formed&);

// One run of the rig `drop`, with the recording's points where there is one.
RunSection drop_section(const std::string& name, const rigs::DropRecord&,
                        const cases::Recording* recording);

// One run of the rig `discharge`, `column` or `drum`: its quantities, its curves with the recording's points where there is one.
RunSection flow_section(const std::string& name, const rigs::FlowRecord&,
                        const cases::Recording* recording);

// One run of a rig that has a forward model: each channel but the first against the first, with the recording's points where
// there is one. `columns` begin with the ordinate.
RunSection curves_section(const std::string& name, const std::vector<cases::Column>& columns,
                          const cases::Recording* recording);

}  // namespace reports
