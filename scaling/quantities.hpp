// SPDX-License-Identifier: MIT
// The physical quantities that similitude speaks of, as Boost.Units types in SI. A quantity crosses
// an interface with its unit; the naked number is taken out by `.value()` at one door per law (see
// contact/), never elsewhere.
#pragma once

#include <boost/units/quantity.hpp>
#include <boost/units/systems/si.hpp>
#include <boost/units/systems/si/io.hpp>

namespace scaling {

namespace si = boost::units::si;
namespace units = boost::units;

using Dimensionless = units::quantity<si::dimensionless>;
using Length = units::quantity<si::length>;
using Area = units::quantity<si::area>;
using Volume = units::quantity<si::volume>;
using Mass = units::quantity<si::mass>;
using Time = units::quantity<si::time>;
using Density = units::quantity<si::mass_density>;
using Velocity = units::quantity<si::velocity>;
using Acceleration = units::quantity<si::acceleration>;
using Force = units::quantity<si::force>;
using Pressure = units::quantity<si::pressure>;  // also stress, Young's and shear modulus
using Energy = units::quantity<si::energy>;
using EnergyPerArea = units::quantity<
    si::surface_tension>;  // work of adhesion, surface energy, surface tension; J/m^2
using Viscosity = units::quantity<si::dynamic_viscosity>;
using Frequency = units::quantity<si::frequency>;  // 1/s; also grains per second

using Stiffness = EnergyPerArea;  // N/m, the same dimension as J/m^2
using Damping = units::quantity<
    units::divide_typeof_helper<si::force, si::velocity>::type>;  // kg/s, of a dashpot
using MassRate = Damping;                                         // kg/s, the same dimension

// The typed view of a raw SI number, where a formula with roots and cubes was worked out on
// doubles.
template <class Quantity>
Quantity in_si(double value) {
    return Quantity::from_value(value);
}

}  // namespace scaling
