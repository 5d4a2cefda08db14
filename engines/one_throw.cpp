// SPDX-License-Identifier: MIT
#include "engines/one_throw.hpp"

#include "engines/lammps_pull_off.hpp"
#include "engines/lammps_run.hpp"
#include "engines/pile_feed.hpp"
#include "engines/process.hpp"
#include "rigs/physics.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::OneGrain;

constexpr double steps_in_a_contact = 100.0;  // of the fastest impact: its rebound to 1e-4
constexpr double time_limit = 12.0 * 3600.0;  // s
constexpr double apart = 10.0;                // radii between the grains of an impact

// Of Hertz' impact without loss, s (Johnson 1985, eq. 11.24).
double contact_time(const OneGrain& g, double speed) {
    const double depth =
        std::pow(15.0 * g.mass * speed * speed / (16.0 * g.e_star * std::sqrt(g.r_star)), 0.4);
    return 2.94 * depth / speed;
}

// Of a grain that lies so deep and rings, s: stiffness 2 E* a.
double ringing_period(const OneGrain& g, double depth) {
    const double a = std::sqrt(g.r_star * depth);
    return 2.0 * std::numbers::pi * std::sqrt(g.mass / (2.0 * g.e_star * a));
}

rigs::World world_of(const cases::Case& c, const cases::Experiment& e, const DeckOptions& o,
                     const std::string& engine) {
    if (!is_thrown(e)) refuse(o, engine, "has no deck for the rig " + e.rig, ours);
    if (c.model.numerics.integrator == "euler")
        refuse(o, engine,
               "takes steps of velocity Verlet, not of Euler (model.numerics.integrator)", ours);
    for (const std::string& effect : c.model.physics)
        if (effect != "gravity" && effect != "buoyancy" && effect != "hertz_mindlin")
            refuse(o, engine, fmt::format("is told of no {} on a single grain", effect), ours);
    rigs::World world = rigs::world_of(c, e);
    if (e.rig == "impact")  // a contact alone
        world.physics.erase("gravity"), world.physics.erase("buoyancy");
    return world;
}

}  // namespace

bool is_thrown(const cases::Experiment& e) {
    return e.rig == "drop" || e.rig == "incline" || e.rig == "impact";
}

Throw::Throw(const cases::Case& c, const cases::Experiment& e, const rigs::Ordinates& at,
             const DeckOptions& o, const std::string& engine)
    : experiment_(e),
      at_(at),
      stated_(e),
      world_(world_of(c, e, o, engine)),
      grain_(rigs::one_grain(stated_, world_)) {
    if (!grain_.compliant)
        refuse(o, engine, "has no rigid friction", "list hertz_mindlin in model.physics");
    if (world_.numerics && world_.numerics->time_step) {
        step_ = world_.numerics->time_step->value();
        return;
    }
    const bool lies = rig() == "incline";
    if (lies ? !(depth_at_rest() > 0.0) : !(fastest() > 0.0))
        throw scaling::InvalidInput(
            scaling::mistake("experiment " + e.id, "a grain that does not touch",
                             "must meet the plate", "give it a height, a speed, or gravity"));
    step_ = (lies ? ringing_period(grain_, depth_at_rest()) : contact_time(grain_, fastest())) /
            steps_in_a_contact;
}

double Throw::condition(const char* name, double otherwise) const {
    return stated_.value(world_, std::string("conditions.") + name, otherwise);
}

double Throw::angle() const { return rig() == "incline" ? condition("angle", 0.0) : 0.0; }

// How deep the grain of an incline lies in its plane, m.
double Throw::depth_at_rest() const {
    return grain_.resting_overlap(grain_.mass * grain_.gravity * std::cos(angle()));
}

// Speed at which the grain first meets the plate, m/s, normal to it.
double Throw::fastest() const {
    const double speed = condition("speed", 0.0);
    return rig() == "impact"
               ? speed
               : std::sqrt(speed * speed + 2.0 * grain_.gravity * condition("height", 0.0));
}

rigs::ContactParameters Throw::contact() const {
    return {.e_star = grain_.e_star,
            .g_star = grain_.g_star,
            .work_of_adhesion = 0.0,
            .sliding_friction = grain_.friction.at_rest,
            .rolling_friction = 0.0,
            .restitution = grain_.restitution.slow};
}

// Step before or at each row; the grain is held until its release.
std::vector<std::int64_t> Throw::steps_before_rows() const {
    const double release = condition("release_time", 0.0);
    std::vector<std::int64_t> steps;
    for (const double row : at_.at)
        steps.push_back(
            static_cast<std::int64_t>(std::floor(std::max(0.0, row - release) / step_)));
    return steps;
}

std::vector<std::int64_t> Throw::row_steps() const {
    if (!over_time()) return {};
    std::vector<std::int64_t> steps = steps_before_rows();
    std::sort(steps.begin(), steps.end());
    steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
    std::erase(steps, 0);  // known
    return steps;
}

std::vector<Grain> Throw::grains() const {
    const double r = grain_.radius;
    const double density = grain_.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(r, 3));
    const double spin = condition("spin", 0.0), speed = condition("speed", 0.0);
    if (rig() == "drop")
        return {{{0.0, 0.0, r + condition("height", 0.0)},
                 {condition("horizontal_speed", 0.0), 0.0, -speed},
                 {0.0, spin, 0.0},
                 r,
                 density}};
    if (rig() == "incline")
        return {{{0.0, 0.0, r - depth_at_rest()}, {speed, 0.0, 0.0}, {0.0, spin, 0.0}, r, density}};
    std::vector<Grain> grains;
    const double gap = 2.0 * step_ * speed;
    for (std::size_t k = 0; k < at_.at.size(); ++k)
        grains.push_back({{0.0, apart * r * static_cast<double>(k), r + gap},
                          {speed * std::sin(at_.at[k]), 0.0, -speed * std::cos(at_.at[k])},
                          {0.0, spin, 0.0},
                          r,
                          density});
    return grains;
}

// Until the slowest approach has come back: Hertz' contact lasts longer by e^(-1/5) at most, with the plate's dashpot by some.
std::int64_t Throw::steps() const {
    if (over_time()) {
        const std::vector<std::int64_t> rows = row_steps();
        return rows.empty() ? 0 : rows.back();
    }
    double slowest = std::numeric_limits<double>::infinity();
    for (const double angle : at_.at)
        if (std::abs(angle) < 0.5 * std::numbers::pi)
            slowest = std::min(slowest, fastest() * std::cos(angle));
    const double gap = 2.0 * step_ * fastest();
    const double long_enough = 3.0 * contact_time(grain_, slowest) + gap / slowest;
    return static_cast<std::int64_t>(std::ceil(long_enough / step_));
}

Box Throw::box() const {
    const double margin = 20.0 * grain_.radius;
    double far = margin, high = margin, wide = margin;
    const double time = static_cast<double>(steps()) * step_;
    for (const Grain& g : grains()) {
        // A spin may become a way, at 2/7 of its speed at most, and a slope another.
        far = std::max(far, 2.0 *
                                (std::abs(g.velocity.x) + grain_.radius * std::abs(g.spin.y) +
                                 grain_.gravity * std::abs(std::sin(angle())) * time) *
                                time);
        wide = std::max(wide, g.position.y + margin);
        high = std::max(high, 2.0 * g.position.z + margin);
    }
    const double speed = fastest();
    high = std::max(high, margin + (grain_.gravity > 0.0 ? speed * speed / grain_.gravity
                                                         : 2.0 * speed * time));
    return {{-far, -margin, -margin}, {far, wide, high}};
}

rigs::Curves Throw::curves(const std::vector<LammpsFrame>& frames) const {
    if (over_time()) return of_rows(frames);
    if (frames.empty() || frames.back().rows.size() != at_.at.size())
        throw std::runtime_error("rows.dump: a grain was lost");
    return of_impacts(frames.back());
}

// Where a grain is at an instant less than a step after the one that was written: the engine's own step would carry it there.
rigs::Curves Throw::of_rows(const std::vector<LammpsFrame>& frames) const {
    const std::vector<std::int64_t> steps = steps_before_rows();
    const double release = condition("release_time", 0.0);
    const bool drop = rig() == "drop";
    const Grain start = grains().front();
    rigs::Curves c;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        Grain g = start;
        if (steps[k] > 0) {
            const auto found =
                std::find_if(frames.begin(), frames.end(),
                             [&](const LammpsFrame& f) { return f.step == steps[k]; });
            if (found == frames.end() || found->rows.size() != 1)
                throw std::runtime_error(
                    fmt::format("rows.dump: no grain at step {}: it was lost", steps[k]));
            const std::vector<double>& row = found->rows.front();
            g.position = {row[found->column("x")], 0.0, row[found->column("z")]};
            g.velocity = {row[found->column("vx")], 0.0, row[found->column("vz")]};
            g.spin.y = row[found->column("omegay")];
        }
        const double rest =
            std::max(0.0, at_.at[k] - release) - static_cast<double>(steps[k]) * step_;
        c[drop ? "x" : "s"].push_back(g.position.x + g.velocity.x * rest);
        if (drop)
            c["z"].push_back(g.position.z + g.velocity.z * rest - grain_.radius);
        else
            c["spin"].push_back(g.spin.y);
    }
    return c;
}

rigs::Curves Throw::of_impacts(const LammpsFrame& last) const {
    const double speed = condition("speed", 0.0);
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    rigs::Curves c;
    for (std::size_t k = 0; k < at_.at.size(); ++k) {
        const std::vector<double>& row = last.rows[k];
        const double v = row[last.column("vx")], n = row[last.column("vz")];
        const double in_n = speed * std::cos(at_.at[k]), in_v = speed * std::sin(at_.at[k]);
        const bool met = std::abs(at_.at[k]) < 0.5 * std::numbers::pi;
        c["rebound_angle"].push_back(met ? std::atan2(v, n) : nothing);
        c["normal_restitution"].push_back(met ? n / in_n : nothing);
        c["tangential_restitution"].push_back(met && in_v != 0.0 ? v / in_v : nothing);
        c["rebound_spin"].push_back(met ? row[last.column("omegay")] : nothing);
    }
    return c;
}

PeerCurvesRun run_one_grain(const Peer& peer, const std::filesystem::path& program,
                            const cases::Case& c, const cases::Experiment& e,
                            const rigs::Ordinates& at, const std::filesystem::path& folder) {
    const DeckOptions options;
    const Deck deck = peer.one_grain(c, e, at, options);
    write_deck(deck, folder);
    PeerCurvesRun result{};
    result.deck = deck.name;
    result.command = peer.command(program.string(), 1);
    const Finished f = run(result.command, folder, time_limit);
    result.seconds = f.seconds;
    result.release = peer.release(f.out);
    keep_output(peer, folder, f.out);
    result.interrupted = f.stopped;
    if (f.stopped) return result;
    if (f.exit_code != 0 || f.timed_out)
        throw std::runtime_error(fmt::format("{}: {} ended with {}: {}", folder.string(),
                                             peer.title, f.exit_code, peer.complaint(f.out)));
    const std::string dump = (folder / "rows.dump").string();
    const std::vector<LammpsFrame> frames =
        std::filesystem::exists(dump) ? read_lammps_frames(dump) : std::vector<LammpsFrame>{};
    if (is_thrown(e)) {
        result.curves = Throw(c, e, at, options, peer.name).curves(frames);
    } else {
        result.curves = pull_off_curves(c, e, at, frames);
        result.note = tear_off_note(c, e);
    }
    return result;
}

}  // namespace engines
