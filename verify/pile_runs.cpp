// SPDX-License-Identifier: MIT
#include "verify/pile_runs.hpp"

#include "verify/remembered_file.hpp"
#include "verify/run_queue.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <utility>

namespace verify {
namespace {

constexpr int version_of_physics =
    4;  // raise when a change of laws, core or estimators makes remembered piles stale
constexpr std::int64_t steps_at_a_time = 2000;

// A setup as text, every double to the last bit: what the fingerprint is taken of.
std::string described(const rigs::PileSetup& s) {
    std::string text = fmt::format("physics {} base {} grains {}", version_of_physics,
                                   static_cast<int>(s.conditions.base), s.conditions.grains);
    const auto add = [&](double value) { text += fmt::format(" {:a}", value); };
    const rigs::PileConditions& c = s.conditions;
    for (const double value : {c.base_diameter, c.rim_height, c.drop_height, c.feed_diameter,
                               c.feed_rate, s.d, s.density, s.gravity, s.time_step, s.skin,
                               s.lost_below, s.rest_duration, s.longest, s.sleep_speed})
        add(value);
    if (s.fluid.acts()) {
        text += " fluid";
        for (const double value : {s.fluid.drag.factor, s.fluid.drag.density,
                                   s.fluid.drag.viscosity, s.fluid.lifting_density})
            add(value);
    }
    if (s.stand.tilt_angle != 0.0)
        text += " tilt", add(s.stand.tilt_angle), add(s.stand.tilt_azimuth);
    if (const dem_min::Shaking& base = s.stand.shaking; base.acts())
        text += " shaking", add(base.amplitude), add(base.omega), add(base.phase);
    const auto add_laws = [&](const rigs::ContactParameters& p) {
        for (const double value : {p.e_star, p.g_star, p.work_of_adhesion, p.sliding_friction,
                                   p.rolling_friction, p.restitution})
            add(value);
        text += p.rigid_tangential ? " rigid" : " elastic";
        if (p.friction_cap != contact::FrictionCap::elastic_plus_two_pull_off)
            text += fmt::format(" cap {}", static_cast<int>(p.friction_cap));
        if (p.bridge.acts()) {
            text += " bridge";
            add(p.bridge.pull_per_radius), add(p.bridge.volume), add(p.bridge.rupture_gap);
        }
        if (p.ageing.acts()) {
            text += " ageing";
            add(p.ageing.rate), add(p.ageing.onset);
        }
        if (p.as_lammps) {
            text += " sds";
            add(p.as_lammps->rolling_stiffness), add(p.as_lammps->rolling_damping);
        }
    };
    add_laws(s.grains), add_laws(s.walls);
    for (const rigs::PairParameters& pair : s.materials.pairs) {
        text += fmt::format(" pair {} {} {}", pair.grain, pair.partner, pair.at_wall);
        add_laws(pair.laws);
    }
    text += fmt::format(" of {} {}", s.materials.of_wall.base, s.materials.of_wall.funnel);
    for (const auto* numbers : {&s.materials.of_wall.meshes, &s.materials.of_grain})
        for (const int number : *numbers) text += fmt::format(" {}", number);
    if (c.funnel)
        for (const double value : {c.funnel->outlet_diameter, c.funnel->top_diameter,
                                   c.funnel->height, c.funnel->outlet_height})
            add(value);
    for (const dem_min::Surface& mesh : c.meshes) {
        for (const contact::Vec3& v : mesh.vertices) add(v.x), add(v.y), add(v.z);
        for (const auto& [i, j, k] : mesh.triangles) text += fmt::format(" {} {} {}", i, j, k);
    }
    for (const auto* list : {&s.feed_time, &s.feed_x, &s.feed_y, &s.radius, &s.materials.density})
        for (const double value : *list) add(value);
    if (!s.feed_axis.empty()) text += " shape", add(s.aspect_ratio);
    for (const contact::Vec3& axis : s.feed_axis) add(axis.x), add(axis.y), add(axis.z);
    return text;
}

PileSample sample_of(const rigs::PileEnd& end, const PileJob& job, double seconds) {
    const rigs::PileRecord& record = end.record;
    PileSample sample;
    sample.name = job.name;
    sample.seed = job.seed;
    sample.formed = record.formed.formed;
    sample.at_rest = record.at_rest;
    for (const rigs::Criterion& c : record.formed.criteria)
        if (!c.pass) sample.missed.push_back(c.name);
    constexpr double degree = std::numbers::pi / 180.0;
    for (std::size_t k = 0; k < record.angles.size(); ++k) {
        if (const auto& angle = record.angles[k].second)
            sample.angles_deg.at(k) = angle->angle / degree;
    }
    sample.packing_fraction = record.packing_fraction;
    sample.coordination = record.coordination;
    sample.grains_on_base = static_cast<double>(record.heap.grains());
    sample.grains_lost = static_cast<double>(record.grains_lost);
    sample.steps = static_cast<double>(record.steps);
    sample.seconds = seconds;
    sample.mean_compression = dem_min::mean_compression(end.run.simulation);
    sample.grain_steps = static_cast<double>(record.work.asked - record.work.slept);
    sample.slept = record.work.share_slept();
    sample.slept_while_fed = record.work_while_fed.share_slept();
    for (std::size_t k = 0; k < record.profile.r.size(); ++k) {
        sample.profile_r.push_back(record.profile.r[k] / record.grain_diameter);
        sample.profile_z.push_back(record.profile.z[k] / record.grain_diameter);
    }
    sample.hash = dem_min::state_hash(end.run.simulation, job.unit_of_length, job.unit_of_time);
    return sample;
}

// One line per field: name, count, values as hexadecimal doubles.
std::string to_text(const PileSample& s) {
    std::string text;
    const auto line = [&](const char* name, const std::vector<double>& values) {
        text += fmt::format("{} {}", name, values.size());
        for (const double value : values) text += fmt::format(" {:a}", value);
        text += '\n';
    };
    const auto optional = [](const std::optional<double>& value) {
        return value ? std::vector{*value} : std::vector<double>{};
    };
    line("flags", {s.formed ? 1.0 : 0.0, s.at_rest ? 1.0 : 0.0});
    std::vector<double> angles;
    for (const std::optional<double>& angle : s.angles_deg) angles.push_back(angle.value_or(NAN));
    line("angles_deg", angles);
    line("packing_fraction", optional(s.packing_fraction));
    line("numbers", {s.coordination, s.grains_on_base, s.grains_lost, s.steps, s.seconds, s.slept,
                     s.slept_while_fed, s.mean_compression, s.grain_steps});
    line("profile_r", s.profile_r);
    line("profile_z", s.profile_z);
    text += fmt::format("missed {} {}\nhash {}\nend\n", s.missed.size(), fmt::join(s.missed, " "),
                        s.hash);
    return text;
}

// Nothing if the file is not there or not whole.
std::optional<PileSample> remembered(const PileJob& job, const std::filesystem::path& file) {
    std::ifstream in(file);
    PileSample s;
    s.name = job.name;
    s.seed = job.seed;
    const auto line = [&](const char* wanted) {
        std::string name, number;
        std::size_t count = 0;
        in >> name >> count;
        if (name != wanted || count > 1'000'000) in.setstate(std::ios::failbit);
        std::vector<double> values;
        for (std::size_t k = 0; in && k < count; ++k) {
            in >> number;
            values.push_back(std::strtod(number.c_str(), nullptr));
        }
        return values;
    };
    const auto optional = [](const std::vector<double>& values) {
        return values.empty() ? std::optional<double>{} : std::optional<double>{values[0]};
    };
    const std::vector<double> flags = line("flags");
    const std::vector<double> angles = line("angles_deg");
    s.packing_fraction = optional(line("packing_fraction"));
    const std::vector<double> numbers = line("numbers");
    s.profile_r = line("profile_r");
    s.profile_z = line("profile_z");
    std::string word, end;
    std::size_t missed = 0;
    in >> word >> missed;
    for (std::size_t k = 0; in && k < missed && missed < 100; ++k)
        in >> word, s.missed.push_back(word);
    in >> word >> s.hash >> end;
    if (!in || end != "end" || flags.size() != 2 || numbers.size() != 9 ||
        angles.size() != s.angles_deg.size())
        return {};
    for (std::size_t k = 0; k < angles.size(); ++k)
        if (std::isfinite(angles[k])) s.angles_deg[k] = angles[k];
    s.formed = flags[0] != 0.0, s.at_rest = flags[1] != 0.0;
    s.coordination = numbers[0], s.grains_on_base = numbers[1], s.grains_lost = numbers[2];
    s.steps = numbers[3], s.seconds = numbers[4];
    s.slept = numbers[5], s.slept_while_fed = numbers[6];
    s.mean_compression = numbers[7], s.grain_steps = numbers[8];
    return s;
}

using Queue = RunQueue<PileJob, PileSample>;

// Nothing where it was stopped. `show` hears how many steps are done.
std::optional<rigs::PileEnd> run_here(const Queue& queue, const rigs::PileSetup& setup,
                                      const std::function<void(std::int64_t)>& show) {
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    while (!run.finished && !queue.stopped()) {
        rigs::advance(run, setup, steps_at_a_time);
        show(run.simulation.steps);
    }
    if (!run.finished) return {};
    rigs::PileRecord record = rigs::record(run, setup);
    return rigs::PileEnd{std::move(run), std::move(record)};
}

void run_one(Queue& queue, std::size_t index) {
    const PileJob& job = queue.jobs[index];
    rigs::PileEngine* engine = queue.campaign.engine;
    const auto start = std::chrono::steady_clock::now();
    const double expected = expected_grain_steps(job.setup);
    const auto most = static_cast<double>(rigs::expected_steps(job.setup));
    const auto show = [&](std::int64_t steps) {
        const std::lock_guard lock(queue.mutex);
        queue.done[index] = expected * std::min(1.0, static_cast<double>(steps) / most);
        queue.tell("");
    };
    const std::optional<rigs::PileEnd> end =
        engine != nullptr ? engine->run(job.setup, show) : run_here(queue, job.setup, show);
    if (!end) return;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const PileSample sample = sample_of(*end, job, seconds.count());
    const std::lock_guard lock(queue.mutex);
    if (!queue.campaign.remembered_in.empty())
        write_whole(file_of(job, queue.campaign.remembered_in, engine), to_text(sample));
    queue.samples[index] = sample;
    queue.done[index] = expected;
    queue.tell(job.name);
}

}  // namespace

std::optional<double> PileSample::angle_deg(rigs::Estimator estimator) const {
    for (std::size_t k = 0; k < angles_deg.size(); ++k)
        if (rigs::computed_estimators[k] == estimator) return angles_deg[k];
    return std::nullopt;
}

std::string fingerprint(const PileJob& job, const rigs::PileEngine* engine) {
    const std::string units = fmt::format(" units {:a} {:a}", job.unit_of_length, job.unit_of_time);
    const std::string by = engine != nullptr ? " by " + engine->key(job.setup) : "";
    return fmt::format("{:016x}", fnv1a(described(job.setup) + units + by));
}

std::filesystem::path file_of(const PileJob& job, const std::filesystem::path& folder,
                              const rigs::PileEngine* engine) {
    return folder / fmt::format("{}-{}.txt", job.name, fingerprint(job, engine));
}

double expected_grain_steps(const rigs::PileSetup& s) {
    const double feeding = s.feed_time.back() / s.time_step;
    return static_cast<double>(s.conditions.grains) *
           (static_cast<double>(rigs::expected_steps(s)) - 0.5 * feeding);
}

std::vector<PileSample> run_piles(const std::vector<PileJob>& jobs, const Campaign& campaign) {
    Queue queue(jobs, campaign);
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        std::optional<PileSample> known;
        if (const auto& folder = campaign.remembered_in; !folder.empty())
            known = remembered(jobs[k], file_of(jobs[k], folder, campaign.engine));
        queue.expect(k, expected_grain_steps(jobs[k].setup), std::move(known));
    }
    return queue.run(campaign.engine != nullptr ? 1 : campaign.threads, run_one);
}

}  // namespace verify
