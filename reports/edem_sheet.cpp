// SPDX-License-Identifier: MIT
// Fields and their order: Altair's pages "Creator Tree-Bulk Material" (Poisson's Ratio, Shear Modulus or Young's Modulus, Solids
// Density, Work Function; then Coefficient of Restitution, of Static Friction, of Rolling Friction for each pair) and "The
// Hertz-Mindlin with JKR Model".
#include "reports/edem_sheet.hpp"

#include <cmath>

namespace reports {
namespace {

struct Writer {
    Sheet sheet{"EDEM", {"dialog", "field", "value", "unit", "note"}};
    void row(const std::string& dialog, const std::string& field, Cell value,
             const std::string& unit, const std::string& note = "") {
        const auto* number = std::get_if<double>(&value);
        const bool missing = number != nullptr && std::isnan(*number) && note.empty();
        sheet.rows.push_back({dialog, field, std::move(value), unit,
                              missing ? std::string("not stated in the case") : note});
    }
};

void write_material(Writer& w, const std::string& dialog, const EdemMaterial& m) {
    w.row(dialog, "Poisson's Ratio", m.poisson_ratio, "1");
    w.row(dialog, "Shear Modulus", m.youngs_modulus / (2.0 * (1.0 + m.poisson_ratio)), "Pa");
    w.row(dialog, "Young's Modulus", m.youngs_modulus, "Pa",
          "instead of Shear Modulus, not beside it");
    w.row(dialog, "Solids Density", m.density, "kg/m^3",
          std::isnan(m.density) ? "any: a wall that does not move has no mass" : "");
    w.row(dialog, "Work Function", std::nan(""), "eV", "leave as it is: for charging only");
}

void write_pair(Writer& w, const std::string& dialog, const EdemPair& p,
                const std::string& rolling) {
    w.row(dialog, "Coefficient of Restitution", p.restitution, "1");
    w.row(dialog, "Coefficient of Static Friction", p.static_friction, "1");
    w.row(dialog, "Coefficient of Rolling Friction", p.rolling_friction, "1", "for " + rolling);
}

void write_adhesion(Writer& w, const std::string& dialog, const EdemInput& in, const EdemPair& p) {
    w.row(dialog, "Base model", in.contact_model, "");
    w.row(dialog, "Rolling Friction", in.rolling_model, "");
    if (!(p.pull_off_force > 0.0)) return;
    w.row(dialog, "Surface Energy", p.surface_energy, "J/m^2", in.convention);
    w.row(dialog, "(check) pull-off force of one contact", p.pull_off_force, "N",
          "not typed in: draw one contact apart and compare");
}

}  // namespace

Sheet edem_sheet(const EdemInput& in) {
    Writer w;
    const std::string bulk = "Bulk Material: " + in.grains.name;
    write_material(w, bulk, in.grains);
    write_pair(w, bulk + " > Interactions: " + in.grains.name, in.grain_grain, in.rolling_model);
    write_pair(w, bulk + " > Interactions: " + in.plate.name, in.grain_plate, in.rolling_model);
    w.row(bulk + " > Particle", "Physical Radius", 0.5 * in.diameter, "m", "a single sphere");
    for (const auto& [share, d] : in.sizes)
        w.row(bulk + " > Size Distribution", "diameter with this share by volume below", d, "m",
              std::to_string(share).substr(0, 5) + " %");
    write_material(w, "Equipment Material: " + in.plate.name, in.plate);
    write_adhesion(w, "Physics > Particle to Particle", in, in.grain_grain);
    write_adhesion(w, "Physics > Particle to Geometry", in, in.grain_plate);
    w.row("Environment", "Gravity Z", -in.gravity, "m/s^2", "X and Y 0");
    for (const std::string& name : in.left_out)
        w.row("not in this sheet", name, std::string("in the case's physics"), "",
              "EDEM needs another model for it");
    return std::move(w.sheet);
}

}  // namespace reports
