// SPDX-License-Identifier: MIT
// What the rigs share: which physics of a case a rig runs, and the contact laws that come of it.
#pragma once

#include "cases/case.hpp"
#include "contact/effective.hpp"
#include "dem_min/interaction.hpp"
#include "scaling/scale_map.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigs {

// What LAMMPS' pair style granular wants to be told of SDS rolling, which our own rules have no use for.
struct LammpsRules {
    double rolling_stiffness, rolling_damping;  // N/m, kg/s
};

// The physics of one kind of contact, in SI.
struct ContactParameters {
    double e_star, g_star;    // Pa
    double work_of_adhesion;  // J/m^2; 0: Hertz
    double sliding_friction, rolling_friction, restitution;
    bool rigid_tangential = false;  // hertz_coulomb: no micro-slip
    contact::FrictionCap friction_cap = contact::FrictionCap::elastic_plus_two_pull_off;
    // Where it is there, the rules are those that LAMMPS has as well: SDS in place of EPSD, JKR torn off at the deepest tension,
    // without adhesion friction of the whole normal force, dashpot included.
    std::optional<LammpsRules> as_lammps = std::nullopt;
    contact::CapillaryBridge bridge = {};
    contact::Ageing ageing = {};
};

// Hertz or JKR, Mindlin or Coulomb, EPSD or no rolling resistance, Tsuji's dashpots; with adhesion or a bridge also twisting
// resistance, without which a sticky branch that hangs on one contact swings about its normal for ever.
dem_min::Laws laws(const ContactParameters&);

// The rules that LAMMPS has as well at both kinds of contact. SDS rolling, which wants a stiffness and has none of its own:
// k = 100 (m g + 2 F_po)/d and gamma = sqrt(k m), m and d nominal, F_po the pull-off force of `work_of_adhesion`, the largest there is,
// between two nominal grains, so that the torque is full after rolling mu_r d/100 where a contact carries m g + 2 F_po. Throws
// scaling::InvalidInput for a friction cap of another kind.
struct NominalGrain {
    double d, density, gravity;  // m, kg/m^3, m/s^2
};
void take_lammps_rules(ContactParameters& grains, ContactParameters& walls, const NominalGrain&,
                       double work_of_adhesion);

// By a name of cases::friction_caps(); elastic_plus_two_pull_off where it is empty.
contact::FrictionCap friction_cap(const std::string& name);

contact::Material grain_material(const cases::Experiment&);
contact::Material plate_material(const cases::Experiment&);  // the density takes no part

// E* and G* of the pair; all else 0.
ContactParameters elastic_parameters(const contact::Material&, const contact::Material&);

// What the bulk rigs of our core have.
const std::vector<std::string>& bulk_physics();

// Between grains of the grain's material, and between these and walls of the plate's.
struct BulkContacts {
    ContactParameters grains, walls;
};
BulkContacts bulk_contacts(const cases::Case&, const cases::Experiment&);

// Capillary bridge and ageing, as the case has them: at all contacts of a bulk rig. `grains` and `walls` must have their work of
// adhesion. Throws scaling::InvalidInput where they cannot act.
void add_pair_effects(const cases::Case&, ContactParameters& grains, ContactParameters& walls);

// Bridge, ageing and work of adhesion in the units of the scaled system.
void scale_attraction(ContactParameters&, const scaling::ScaleMap&);

// Throws scaling::InvalidInput where `model.physics` holds anything but `known`: it would be left out in silence.
void refuse_other_physics(const cases::Case&, const std::string& rig,
                          const std::vector<std::string>& known);

}  // namespace rigs
