// SPDX-License-Identifier: MIT
#include "verify/compression_runs.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <optional>
#include <thread>

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

std::uint64_t fnv1a(const std::string& text) {
    std::uint64_t state = 14695981039346656037ULL;
    for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return state;
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

void remember(const CompressionSample& s, const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::path unfinished = file;
    unfinished += ".tmp";
    {
        std::ofstream out(unfinished);
        for (const double* number : numbers_of(s)) out << fmt::format("{:a}\n", *number);
        for (const std::vector<double>* list : lists_of(s)) {
            out << list->size();
            for (const double value : *list) out << fmt::format(" {:a}", value);
            out << '\n';
        }
        out << s.hash << "\nend\n";
        if (!out.flush())
            throw std::runtime_error(unfinished.string() + ": cannot be written (disk full?)");
    }
    std::filesystem::rename(unfinished, file);
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

// Shared by the workers of one campaign.
struct Queue {
    const std::vector<CompressionJob>& jobs;
    const Campaign& campaign;
    std::vector<std::optional<CompressionSample>> samples;
    std::vector<double> done;  // grain-steps
    double total = 0.0;
    std::size_t next = 0;
    std::mutex mutex{};
    std::exception_ptr fault{};

    bool stopped() const { return campaign.stop != nullptr && campaign.stop->load(); }
    void tell(const std::string& ended) {
        double sum = 0.0;
        for (const double part : done) sum += part;
        if (campaign.progress) campaign.progress(sum, total, ended);
    }
};

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
        remember(sample, file_of(job, queue.campaign.remembered_in));
    queue.samples[index] = sample;
    queue.done[index] = work;
    queue.tell(job.name);
}

void work(Queue& queue) {
    for (;;) {
        std::size_t index = 0;
        {
            const std::lock_guard lock(queue.mutex);
            while (queue.next < queue.jobs.size() && queue.samples[queue.next]) ++queue.next;
            if (queue.next >= queue.jobs.size() || queue.stopped() || queue.fault) return;
            index = queue.next++;
        }
        try {
            run_one(queue, index);
        } catch (...) {
            const std::lock_guard lock(queue.mutex);
            queue.fault = std::current_exception();
        }
    }
}

}  // namespace

std::filesystem::path file_of(const CompressionJob& job, const std::filesystem::path& folder) {
    return folder / fmt::format("{}-{:016x}.txt", job.name, fnv1a(described(job)));
}

std::vector<CompressionSample> run_compressions(const std::vector<CompressionJob>& jobs,
                                                const Campaign& campaign) {
    Queue queue{.jobs = jobs,
                .campaign = campaign,
                .samples = std::vector<std::optional<CompressionSample>>(jobs.size()),
                .done = std::vector<double>(jobs.size(), 0.0)};
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        queue.total += expected_work(jobs[k]);
        if (campaign.remembered_in.empty()) continue;
        queue.samples[k] = remembered(jobs[k], file_of(jobs[k], campaign.remembered_in));
        if (queue.samples[k]) queue.done[k] = expected_work(jobs[k]);
    }
    std::vector<std::thread> workers;
    for (int k = 0; k < campaign.threads; ++k) workers.emplace_back([&] { work(queue); });
    for (std::thread& worker : workers) worker.join();
    if (queue.fault) std::rethrow_exception(queue.fault);
    std::vector<CompressionSample> samples;
    for (std::optional<CompressionSample>& sample : queue.samples) {
        if (!sample) throw Interrupted{};
        samples.push_back(std::move(*sample));
    }
    return samples;
}

}  // namespace verify
