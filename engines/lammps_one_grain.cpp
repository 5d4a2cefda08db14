// SPDX-License-Identifier: MIT
#include "engines/lammps_one_grain.hpp"

#include "engines/lammps_files.hpp"
#include "engines/lammps_run.hpp"
#include "engines/process.hpp"
#include "rigs/one_grain.hpp"
#include "rigs/physics.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace engines {
namespace {

using dem_min::Grain;
using dem_min::Vec3;
using rigs::OneGrain;

constexpr double steps_in_a_contact = 100.0;  // of the fastest impact: its rebound to 1e-4
constexpr double time_limit = 12.0 * 3600.0;  // s
constexpr double apart = 10.0;                // radii between the grains of an impact

struct Throw {
    const cases::Experiment& experiment;
    rigs::Stated stated;
    rigs::World world;
    OneGrain grain;

    double condition(const char* name, double otherwise) const {
        return stated.value(world, std::string("conditions.") + name, otherwise);
    }
    bool over_time() const { return experiment.rig != "impact"; }
    double angle() const {  // of the plane, rad
        return experiment.rig == "incline" ? condition("angle", 0.0) : 0.0;
    }
    // How deep the grain of an incline lies in its plane, m.
    double depth_at_rest() const {
        return grain.resting_overlap(grain.mass * grain.gravity * std::cos(angle()));
    }
};

Throw thrown(const cases::Case& c, const cases::Experiment& e, const std::string& option) {
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        throw scaling::InvalidInput(scaling::mistake(option, "lammps", what, remedy));
    };
    const char* ours = "leave the option out: dem_min runs it";
    if (!has_one_grain_deck(e)) refuse("has no deck for the rig " + e.rig, ours);
    if (c.model.numerics.integrator == "euler")
        refuse("takes steps of velocity Verlet, not of Euler (model.numerics.integrator)", ours);
    for (const std::string& effect : c.model.physics)
        if (effect != "gravity" && effect != "buoyancy" && effect != "hertz_mindlin")
            refuse(fmt::format("is told of no {} on a single grain", effect), ours);
    rigs::World world = rigs::world_of(c, e);
    if (e.rig == "impact")  // a contact alone
        world.physics.erase("gravity"), world.physics.erase("buoyancy");
    const rigs::Stated stated(e);
    Throw t{e, stated, world, rigs::one_grain(stated, world)};
    if (!t.grain.compliant) refuse("has no rigid friction", "list hertz_mindlin in model.physics");
    return t;
}

// Speed at which the grain first meets the plate, m/s, normal to it.
double fastest(const Throw& t) {
    const double speed = t.condition("speed", 0.0);
    return t.experiment.rig == "impact"
               ? speed
               : std::sqrt(speed * speed + 2.0 * t.grain.gravity * t.condition("height", 0.0));
}

// Of Hertz' impact without loss, s (Johnson 1985, eq. 11.24).
double contact_time(const OneGrain& g, double speed) {
    const double depth =
        std::pow(15.0 * g.mass * speed * speed / (16.0 * g.e_star * std::sqrt(g.r_star)), 0.4);
    return 2.94 * depth / speed;
}

// Of a grain that lies on the plane and rings, s: stiffness 2 E* a.
double period_at_rest(const Throw& t) {
    const double a = std::sqrt(t.grain.r_star * t.depth_at_rest());
    return 2.0 * std::numbers::pi * std::sqrt(t.grain.mass / (2.0 * t.grain.e_star * a));
}

double time_step(const Throw& t) {
    if (t.world.numerics && t.world.numerics->time_step)
        return t.world.numerics->time_step->value();
    const double speed = fastest(t);
    const bool lies = t.experiment.rig == "incline";
    if (lies ? !(t.depth_at_rest() > 0.0) : !(speed > 0.0))
        throw scaling::InvalidInput(
            scaling::mistake("experiment " + t.experiment.id, "a grain that does not touch",
                             "must meet the plate", "give it a height, a speed, or gravity"));
    return (lies ? period_at_rest(t) : contact_time(t.grain, speed)) / steps_in_a_contact;
}

// Step before or at each row; the grain is held until its release.
std::vector<std::int64_t> steps_of(const Throw& t, const rigs::Ordinates& at) {
    const double step = time_step(t), release = t.condition("release_time", 0.0);
    std::vector<std::int64_t> steps;
    for (const double row : at.at)
        steps.push_back(static_cast<std::int64_t>(std::floor(std::max(0.0, row - release) / step)));
    return steps;
}

std::vector<Grain> grains_of(const Throw& t, const rigs::Ordinates& at) {
    const OneGrain& g = t.grain;
    const double density = g.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(g.radius, 3));
    const double spin = t.condition("spin", 0.0), speed = t.condition("speed", 0.0);
    if (t.experiment.rig == "drop")
        return {{{0.0, 0.0, g.radius + t.condition("height", 0.0)},
                 {t.condition("horizontal_speed", 0.0), 0.0, -speed},
                 {0.0, spin, 0.0},
                 g.radius,
                 density}};
    if (t.experiment.rig == "incline")
        return {{{0.0, 0.0, g.radius - t.depth_at_rest()},
                 {speed, 0.0, 0.0},
                 {0.0, spin, 0.0},
                 g.radius,
                 density}};
    std::vector<Grain> grains;
    const double gap = 2.0 * time_step(t) * speed;
    for (std::size_t k = 0; k < at.at.size(); ++k)
        grains.push_back({{0.0, apart * g.radius * static_cast<double>(k), g.radius + gap},
                          {speed * std::sin(at.at[k]), 0.0, -speed * std::cos(at.at[k])},
                          {0.0, spin, 0.0},
                          g.radius,
                          density});
    return grains;
}

// Until the slowest approach has come back: Hertz' contact lasts longer by e^(-1/5) at most, with the plate's dashpot by some.
std::int64_t last_step(const Throw& t, const rigs::Ordinates& at) {
    if (t.over_time()) {
        const std::vector<std::int64_t> steps = steps_of(t, at);
        return steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end());
    }
    double slowest = std::numeric_limits<double>::infinity();
    for (const double angle : at.at)
        if (std::abs(angle) < 0.5 * std::numbers::pi)
            slowest = std::min(slowest, fastest(t) * std::cos(angle));
    const double step = time_step(t), gap = 2.0 * step * fastest(t);
    const double long_enough = 3.0 * contact_time(t.grain, slowest) + gap / slowest;
    return static_cast<std::int64_t>(std::ceil(long_enough / step));
}

Box box_of(const std::vector<Grain>& grains, const Throw& t, std::int64_t steps) {
    const double radius = t.grain.radius;
    double far = 20.0 * radius, high = 20.0 * radius, wide = 20.0 * radius;
    const double time = static_cast<double>(steps) * time_step(t);
    for (const Grain& g : grains) {
        // A spin may become a way, at 2/7 of its speed at most, and a slope another.
        far = std::max(far, 2.0 *
                                (std::abs(g.velocity.x) + radius * std::abs(g.spin.y) +
                                 t.grain.gravity * std::abs(std::sin(t.angle())) * time) *
                                time);
        wide = std::max(wide, g.position.y + 20.0 * radius);
        high = std::max(high, 2.0 * g.position.z + 20.0 * radius);
    }
    const double speed = fastest(t);
    if (t.grain.gravity > 0.0)
        high = std::max(high, speed * speed / t.grain.gravity + 20.0 * radius);
    else
        high = std::max(high, 2.0 * speed * time + 20.0 * radius);
    return {{-far, -20.0 * radius, -20.0 * radius}, {far, wide, high}};
}

rigs::ContactParameters contact_of(const OneGrain& g) {
    return {.e_star = g.e_star,
            .g_star = g.g_star,
            .work_of_adhesion = 0.0,
            .sliding_friction = g.friction.at_rest,
            .rolling_friction = 0.0,
            .restitution = g.restitution.slow};
}

std::string deck_of(const Throw& t, std::int64_t steps) {
    const std::string rules = granular_arguments(contact_of(t.grain));
    std::string deck = fmt::format(
        "# The rig {} of similitude in LAMMPS, release of 29 Sep 2021: lmp -in deck.in. SI units; "
        "the plate is "
        "z = 0.\n# One run: the dashpot of a wall changes with every further one.\n",
        t.experiment.rig);
    deck += opening_of_few(t.grain.radius, rules, time_step(t));
    deck += fmt::format(
        "fix plate all wall/gran granular {} zplane 0.0 NULL\nfix motion all nve/sphere\n", rules);
    if (t.grain.gravity > 0.0)
        deck += fmt::format("fix gravity all gravity {:.17g} vector {:.17g} 0 {:.17g}\n",
                            t.grain.gravity, std::sin(t.angle()), -std::cos(t.angle()));
    deck += "dump rows all custom 1 rows.dump id x y z vx vy vz omegax omegay omegaz\n";
    if (t.experiment.rig == "drop")
        deck +=
            "variable row file rows.txt\nvariable due equal next(row)\n"
            "dump_modify rows every v_due sort id format float %.17g first no\n";
    else
        deck += fmt::format("dump_modify rows every {} sort id format float %.17g\n", steps);
    return deck + fmt::format("thermo {}\nrun {}\n", std::max<std::int64_t>(1, steps / 20), steps);
}

std::string rows_text(std::vector<std::int64_t> steps) {
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    std::erase(steps, 0);  // known
    std::string text;
    for (const std::int64_t step : steps) text += fmt::format("{}\n", step);
    // LAMMPS reads one ahead of the last.
    return text + fmt::format("{}\n", (steps.empty() ? 0 : steps.back()) + 1000000000);
}

// Where a grain is at an instant less than a step after the one that was written: LAMMPS' own step would carry it there.
rigs::Curves rows_over_time(const Throw& t, const rigs::Ordinates& at,
                            const std::vector<LammpsFrame>& frames) {
    const std::vector<std::int64_t> steps = steps_of(t, at);
    const double step = time_step(t), release = t.condition("release_time", 0.0);
    const bool drop = t.experiment.rig == "drop";
    const Grain start = grains_of(t, at).front();
    rigs::Curves c;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        Grain g = start;
        if (steps[k] > 0) {
            const auto found =
                std::find_if(frames.begin(), frames.end(),
                             [&](const LammpsFrame& f) { return f.step == steps[k]; });
            if (found == frames.end() || found->rows.size() != 1)
                throw std::runtime_error(
                    fmt::format("rows.dump: no grain at step {}: LAMMPS lost it", steps[k]));
            const std::vector<double>& row = found->rows.front();
            g.position = {row[found->column("x")], 0.0, row[found->column("z")]};
            g.velocity = {row[found->column("vx")], 0.0, row[found->column("vz")]};
            g.spin.y = row[found->column("omegay")];
        }
        const double rest =
            std::max(0.0, at.at[k] - release) - static_cast<double>(steps[k]) * step;
        c[drop ? "x" : "s"].push_back(g.position.x + g.velocity.x * rest);
        if (drop)
            c["z"].push_back(g.position.z + g.velocity.z * rest - t.grain.radius);
        else
            c["spin"].push_back(g.spin.y);
    }
    return c;
}

rigs::Curves impact_curves(const Throw& t, const rigs::Ordinates& at, const LammpsFrame& last) {
    if (last.rows.size() != at.at.size())
        throw std::runtime_error("rows.dump: LAMMPS lost a grain");
    const double speed = t.condition("speed", 0.0);
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    rigs::Curves c;
    for (std::size_t k = 0; k < at.at.size(); ++k) {
        const std::vector<double>& row = last.rows[k];
        const double v = row[last.column("vx")], n = row[last.column("vz")];
        const double in_n = speed * std::cos(at.at[k]), in_v = speed * std::sin(at.at[k]);
        const bool met = std::abs(at.at[k]) < 0.5 * std::numbers::pi;
        c["rebound_angle"].push_back(met ? std::atan2(v, n) : nothing);
        c["normal_restitution"].push_back(met ? n / in_n : nothing);
        c["tangential_restitution"].push_back(met && in_v != 0.0 ? v / in_v : nothing);
        c["rebound_spin"].push_back(met ? row[last.column("omegay")] : nothing);
    }
    return c;
}

}  // namespace

bool has_one_grain_deck(const cases::Experiment& e) {
    return e.rig == "drop" || e.rig == "incline" || e.rig == "impact";
}

double lammps_time_step(const cases::Case& c, const cases::Experiment& e,
                        const std::string& option) {
    return time_step(thrown(c, e, option));
}

LammpsDeck lammps_one_grain(const cases::Case& c, const cases::Experiment& e,
                            const rigs::Ordinates& at, const std::string& option) {
    const Throw t = thrown(c, e, option);
    refuse_restitution(t.grain.restitution.slow, option);
    const std::int64_t steps = last_step(t, at);
    const std::vector<Grain> grains = grains_of(t, at);
    LammpsDeck result{deck_of(t, steps), {}};
    result.files.emplace_back("start.data", lammps_data(grains, box_of(grains, t, steps), 1));
    if (t.over_time()) result.files.emplace_back("rows.txt", rows_text(steps_of(t, at)));
    return result;
}

LammpsCurvesRun run_lammps_one_grain(const std::filesystem::path& lmp, const cases::Case& c,
                                     const cases::Experiment& e, const rigs::Ordinates& at,
                                     const std::filesystem::path& folder) {
    const Throw t = thrown(c, e, "--engine");
    write_lammps_deck(lammps_one_grain(c, e, at), folder);
    std::filesystem::remove(folder / "rows.dump");
    LammpsCurvesRun result{.release = {},
                           .interrupted = false,
                           .seconds = 0.0,
                           .command = {lmp.string(), "-in", "deck.in", "-log", "log.lammps"},
                           .curves = {}};
    const auto start = std::chrono::steady_clock::now();
    const Finished f = run(result.command, folder, time_limit);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.release = lammps_release(f.out);
    result.interrupted = f.stopped;
    if (f.stopped) return result;
    if (f.exit_code != 0 || f.timed_out)
        throw std::runtime_error(fmt::format("{}: LAMMPS ended with {}: {}", folder.string(),
                                             f.exit_code, lammps_complaint(f.out)));
    const std::string dump = (folder / "rows.dump").string();
    const std::vector<LammpsFrame> frames = std::filesystem::exists(dump)
                                                ? read_lammps_dump(file_text(dump), dump)
                                                : std::vector<LammpsFrame>{};
    if (t.over_time()) {
        result.curves = rows_over_time(t, at, frames);
    } else {
        if (frames.empty()) throw std::runtime_error(dump + ": LAMMPS wrote no grain");
        result.curves = impact_curves(t, at, frames.back());
    }
    return result;
}

}  // namespace engines
