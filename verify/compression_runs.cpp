// SPDX-License-Identifier: MIT
#include "verify/compression_runs.hpp"

#include "verify/remembered_file.hpp"
#include "verify/run_queue.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <utility>

namespace verify {
namespace {

constexpr int version_of_physics =
    1;  // raise when a change of laws, core or rig makes samples stale
constexpr std::int64_t steps_at_a_time = 2000;

// A setup, every double to the last bit: what the fingerprint is taken of.
std::string described(const CompressionJob& job) {
    std::string text = fmt::format("compression {}", version_of_physics);
    const auto add = [&](auto... values) { ((text += fmt::format(" {:a}", values)), ...); };
    const rigs::CompressionSetup& s = job.setup;
    add(s.cell.width, s.cell.height, s.cell.solid_volume, s.cell.stress, s.cell.speed,
        s.cell.crush_strain, s.cell.pause, s.d, s.density, s.gravity, s.time_step, s.skin,
        job.unit_of_length, job.unit_of_time);
    for (const rigs::ContactParameters* p : {&s.grains, &s.plates})
        add(p->e_star, p->g_star, p->work_of_adhesion, p->sliding_friction, p->rolling_friction,
            p->restitution);
    for (std::size_t k = 0; k < s.radius.size(); ++k)
        add(s.radius[k], s.place[k].x, s.place[k].y, s.place[k].z);
    return text;
}

void add_row(StressStrain& curve, const rigs::CompressionRow& row) {
    curve.strain.push_back(row.strain);
    curve.stress.push_back(row.piston_stress);
}

CompressionSample sample_of(const rigs::CompressionRun& run, const CompressionJob& job,
                            double seconds) {
    const rigs::CompressionRecord r = rigs::record(run, job.setup);
    CompressionSample s;
    s.name = job.name;
    s.seed = job.seed;
    s.grains = static_cast<double>(job.setup.radius.size());
    s.strain = r.consolidated.strain;
    s.packing_fraction = r.consolidated.packing_fraction;
    s.coordination = r.consolidated.coordination;
    s.floor_over_piston = r.consolidated.floor_stress / r.consolidated.piston_stress;
    s.strength = r.strength.stress, s.strain_at_strength = r.strength.strain;
    s.inertial_number = r.inertial_number;
    s.inertial_number_of_crush = r.inertial_number_of_crush;
    s.steps = static_cast<double>(r.steps), s.seconds = seconds;
    for (const rigs::CompressionRow& row : r.rows) {
        if (row.stage == rigs::Stage::compressing) add_row(s.confined, row);
        if (row.stage == rigs::Stage::crushing) add_row(s.crushed, row);
    }
    s.hash = dem_min::state_hash(run.simulation, job.unit_of_length, job.unit_of_time);
    return s;
}

// What a file of a sample holds, in one order for both directions.
auto numbers_of(auto& s) {
    return std::array{&s.grains,
                      &s.strain,
                      &s.packing_fraction,
                      &s.coordination,
                      &s.floor_over_piston,
                      &s.strength,
                      &s.strain_at_strength,
                      &s.inertial_number,
                      &s.inertial_number_of_crush,
                      &s.steps,
                      &s.seconds};
}
auto lists_of(auto& s) {
    return std::array{&s.confined.strain, &s.confined.stress, &s.crushed.strain, &s.crushed.stress};
}

std::string to_text(const CompressionSample& s) {
    std::string text;
    for (const double* number : numbers_of(s)) text += fmt::format("{:a}\n", *number);
    for (const std::vector<double>* list : lists_of(s)) {
        text += fmt::format("{}", list->size());
        for (const double value : *list) text += fmt::format(" {:a}", value);
        text += '\n';
    }
    return text + fmt::format("{}\nend\n", s.hash);
}

// Nothing if the file is not there or not whole.
std::optional<CompressionSample> remembered(const CompressionJob& job,
                                            const std::filesystem::path& file) {
    std::ifstream in(file);
    CompressionSample s;
    s.name = job.name, s.seed = job.seed;
    std::string word;
    const auto next = [&] {
        in >> word;
        return std::strtod(word.c_str(), nullptr);
    };
    for (double* number : numbers_of(s)) *number = next();
    for (std::vector<double>* list : lists_of(s)) {
        std::size_t count = 0;
        in >> count;
        for (std::size_t k = 0; in && k < count; ++k) list->push_back(next());
    }
    in >> s.hash >> word;
    if (!in || word != "end") return {};
    return s;
}

double expected_work(const CompressionJob& job) {  // grain-steps
    return static_cast<double>(job.setup.radius.size()) *
           static_cast<double>(rigs::expected_steps(job.setup));
}

using Queue = RunQueue<CompressionJob, CompressionSample>;

void run_one(Queue& queue, std::size_t index) {
    const CompressionJob& job = queue.jobs[index];
    const auto start = std::chrono::steady_clock::now();
    const double work = expected_work(job);
    const auto most = static_cast<double>(rigs::expected_steps(job.setup));
    rigs::CompressionRun run = rigs::begin_compression(job.setup, 1);
    while (!run.finished()) {
        if (queue.stopped()) return;
        rigs::advance(run, job.setup, steps_at_a_time);
        const std::lock_guard lock(queue.mutex);
        queue.done[index] = work * std::min(1.0, static_cast<double>(run.simulation.steps) / most);
        queue.tell("");
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const CompressionSample sample = sample_of(run, job, seconds.count());
    const std::lock_guard lock(queue.mutex);
    if (!queue.campaign.remembered_in.empty())
        write_whole(file_of(job, queue.campaign.remembered_in), to_text(sample));
    queue.samples[index] = sample;
    queue.done[index] = work;
    queue.tell(job.name);
}

}  // namespace

std::filesystem::path file_of(const CompressionJob& job, const std::filesystem::path& folder) {
    return folder / fmt::format("{}-{:016x}.txt", job.name, fnv1a(described(job)));
}

std::vector<CompressionSample> run_compressions(const std::vector<CompressionJob>& jobs,
                                                const Campaign& campaign) {
    Queue queue(jobs, campaign);
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        std::optional<CompressionSample> known;
        if (const auto& folder = campaign.remembered_in; !folder.empty())
            known = remembered(jobs[k], file_of(jobs[k], folder));
        queue.expect(k, expected_work(jobs[k]), std::move(known));
    }
    return queue.run(campaign.threads, run_one);
}

}  // namespace verify
