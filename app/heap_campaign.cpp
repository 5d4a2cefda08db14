// SPDX-License-Identifier: MIT
#include "app/heap_campaign.hpp"

#include "app/child.hpp"
#include "app/common.hpp"
#include "prove/case_text.hpp"
#include "prove/heap_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr double longest_pour = 3600.0;  // s of processor time

std::string text_of(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Families of this shard, and the numbers of the cases in each.
std::vector<std::vector<int>> families_of(const Campaign& c) {
    prove::Extent all = c.extent;
    all.kind.reset(), all.rig.clear();
    const int families = (all.cases + prove::family_size - 1) / prove::family_size;
    all.cases = families;
    std::vector<std::vector<int>> list(static_cast<std::size_t>(families));
    for (const int family : prove::numbers_of(all)) {
        const int first = (family - 1) * prove::family_size;
        for (int k = first + 1; k <= std::min(first + prove::family_size, c.extent.cases); ++k)
            list[static_cast<std::size_t>(family - 1)].push_back(k);
    }
    return list;
}

// One heap: what is poured, and the file that keeps its heights.
struct Task {
    prove::Pour pour;
    const std::vector<prove::Spot>* spots;
    fs::path file;
};

// "# grains left", one height a line, "end".
std::vector<double> heights_in(const fs::path& file) {
    std::istringstream in(text_of(file));
    std::string line;
    std::getline(in, line);
    std::vector<double> all;
    while (std::getline(in, line) && line != "end")
        all.push_back(std::strtod(line.c_str(), nullptr));
    if (line != "end") all.clear();
    return all;
}

class Work {
  public:
    Work(const HeapCampaign& c, const std::function<void(double, double, const std::string&)>& show,
         const std::atomic<bool>& stop)
        : c_(c), show_(show), stop_(stop) {
        const auto families = families_of(c.common);
        for (std::size_t f = 0; f < families.size(); ++f)
            if (!families[f].empty()) {
                families_.push_back(
                    prove::heap_family(c.common.extent.seed, static_cast<int>(f) + 1, c.size));
                cases_.push_back(families[f]);
            }
    }

    bool all() {
        std::vector<Task> tasks;
        for (const prove::HeapFamily& f : families_)
            for (std::size_t a = 0; a < f.arrangements.size(); ++a)
                for (Task& t : tasks_of(f, a)) tasks.push_back(std::move(t));
        pour(tasks, "heaps behind the keys");
        if (stop_) return false;
        tasks.clear();
        std::vector<prove::HeapSecret> secrets;
        std::vector<std::size_t> family_of;
        std::vector<std::vector<prove::Response>> responses;
        for (std::size_t f = 0; f < families_.size(); ++f) {
            responses.push_back(responses_of(families_[f]));
            for (const int number : cases_[f]) {
                secrets.push_back(prove::heap_secret(seed(),
                                                     prove::heap_plan(seed(), number, families_[f]),
                                                     families_[f], responses.back()));
                family_of.push_back(f);
                for (const auto& t : tasks_of(families_[f], secrets.back().plan))
                    tasks.push_back(t);
            }
        }
        pour(tasks, "heaps of the cases");
        if (stop_) return false;
        for (std::size_t k = 0; k < secrets.size(); ++k)
            write(families_[family_of[k]], secrets[k], responses[family_of[k]]);
        if (c_.common.write_only) return true;
        std::mutex guard;
        double done = 0.0;
        const auto judged = [&](int number, int threads) {
            judge(prove::case_name(number), threads);
            const std::lock_guard lock(guard);
            show_(++done, static_cast<double>(secrets.size()), prove::case_name(number));
        };
        // A family's first case pours what the others find: alone, and with all threads.
        for (const std::vector<int>& numbers : cases_) {
            if (stop_) break;
            judged(numbers.front(), c_.common.threads);
            share(numbers.size() - 1, c_.common.threads, stop_,
                  [&](std::size_t k) { judged(numbers[k + 1], 1); });
        }
        return !stop_;
    }

  private:
    std::uint64_t seed() const { return c_.common.extent.seed; }
    fs::path home() const { return c_.common.out; }

    std::vector<prove::DesignPour> design(const prove::HeapFamily& f, std::size_t a) const {
        return prove::heap_design(seed(), f, a);
    }

    // The design's heaps, in its order.
    std::vector<Task> tasks_of(const prove::HeapFamily& f, std::size_t a) const {
        const prove::Arrangement& at = f.arrangements[a];
        std::vector<Task> tasks;
        for (const prove::DesignPour& d : design(f, a)) {
            const std::string name =
                fmt::format("family-{}-{}-{:02}.txt", f.number, at.id, tasks.size());
            tasks.push_back({{at.grain, at.rig,
                              prove::with_effect(f, d.effect, d.strength, d.friction), d.seed},
                             &at.spots,
                             home() / "heaps" / name});
        }
        return tasks;
    }

    std::vector<Task> tasks_of(const prove::HeapFamily& f, const prove::HeapPlan& p) const {
        std::vector<Task> tasks;
        for (const prove::HeapRecording& r : prove::heap_recordings(seed(), p, f))
            tasks.push_back(
                {r.pour, &f.arrangements[r.arrangement].spots,
                 home() / "heaps" / fmt::format("{}-{}.txt", prove::case_name(p.number), r.id)});
        return tasks;
    }

    void pour(const std::vector<Task>& tasks, const std::string& what) const {
        std::mutex guard;
        double done = 0.0;
        share(tasks.size(), c_.common.threads, stop_, [&](std::size_t k) {
            if (!c_.common.resume || heights_in(tasks[k].file).empty()) pour(tasks[k]);
            const std::lock_guard lock(guard);
            show_(++done, static_cast<double>(tasks.size()), what);
        });
    }

    void pour(const Task& task) const {
        const fs::path folder = fs::path(task.file).replace_extension("run");
        for (const auto& [name, text] : prove::lammps_files(task.pour))
            write_file((folder / name).string(), text);
        const ChildEnd end = run_child(
            {c_.lammps, "-in", (folder / "deck.in").string(), "-var", "folder", folder.string(),
             "-log", (folder / "log.lammps").string(), "-screen", "none"},
            longest_pour, stop_);
        if (stop_ && !end.exit_code) return;
        const std::string dump = text_of(folder / "heap.dump");
        if (end.exit_code != 0 || dump.empty())
            throw std::runtime_error(
                fmt::format("LAMMPS did not pour the heap of {}: its words are in {}",
                            folder.string(), (folder / "log.lammps").string()));
        const std::vector<prove::Ball> heap = prove::read_heap(dump);
        for (const prove::Ball& ball : heap)
            if (ball.z + 2.0 * ball.radius > task.pour.rig.drop_height)
                throw std::runtime_error(
                    fmt::format("the heap of {} has grown up to its feed, where grains would "
                                "appear within others: it is no truth",
                                folder.string()));
        std::string text = fmt::format("# {} grains\n", heap.size());
        for (const prove::Spot& spot : *task.spots)
            text += fmt::format("{:.9g}\n", prove::height_above(heap, spot));
        write_file(task.file.string(), text + "end\n");
        fs::remove_all(folder);
    }

    std::vector<prove::Response> responses_of(const prove::HeapFamily& f) const {
        std::vector<prove::Response> all;
        for (std::size_t a = 0; a < f.arrangements.size(); ++a) {
            std::vector<std::vector<double>> heights;
            std::vector<Eigen::VectorXd> features;
            for (const Task& t : tasks_of(f, a)) {
                heights.push_back(heights_in(t.file));
                features.push_back(prove::heap_features(f.arrangements[a], heights.back()));
            }
            all.push_back(
                prove::heap_response(f, f.arrangements[a], design(f, a), features, heights));
        }
        return all;
    }

    void write(const prove::HeapFamily& f, const prove::HeapSecret& secret,
               const std::vector<prove::Response>& responses) const {
        const prove::HeapPlan& p = secret.plan;
        const auto recordings = prove::heap_recordings(seed(), p, f);
        const std::vector<Task> tasks = tasks_of(f, p);
        std::vector<std::vector<double>> rows;
        for (std::size_t k = 0; k < recordings.size(); ++k)
            rows.push_back(prove::recorded(seed(), p, f.arrangements[recordings[k].arrangement],
                                           heights_in(tasks[k].file), k));
        prove::BlindCase made;
        made.number = p.number;
        made.files = prove::heap_files(p, f, recordings, rows);
        made.key = prove::heap_key(secret, f, responses, rows.back());
        made.key_text = prove::key_text(made.key);
        prove::write(made, (home() / "cases").string(), (home() / "keys").string());
    }

    void judge(const std::string& name, int threads) const {
        const Campaign& c = c_.common;
        const fs::path verdicts = home() / "verdicts";
        if (stop_ || (c.resume && fs::exists(ended(verdicts, name)))) return;
        judge_case({c.judge, "diagnose", (home() / "cases" / name).string(), "--contact", "lammps",
                    "--heaps", (home() / "judge-heaps").string(), "--seed",
                    std::to_string(c.judge_seed), "--threads", std::to_string(threads)},
                   verdicts, name, c.limit, stop_);
    }

    const HeapCampaign& c_;
    const std::function<void(double, double, const std::string&)>& show_;
    const std::atomic<bool>& stop_;
    std::vector<prove::HeapFamily> families_;
    std::vector<std::vector<int>> cases_;  // numbers, by family
};

}  // namespace

bool work(const HeapCampaign& campaign,
          const std::function<void(double, double, const std::string&)>& show,
          const std::atomic<bool>& stop) {
    return Work(campaign, show, stop).all();
}

Result score(const HeapCampaign& campaign) {
    const fs::path out = campaign.common.out;
    std::set<std::string> names;
    for (const std::vector<int>& family : families_of(campaign.common))
        for (const int number : family) names.insert(prove::case_name(number));
    prove::Keys keys = prove::read_keys((out / "keys").string());
    prove::Verdicts verdicts = prove::read_verdicts((out / "verdicts").string());
    std::erase_if(keys, [&](const auto& entry) { return !names.contains(entry.first); });
    std::erase_if(verdicts, [&](const auto& entry) { return !names.contains(entry.first); });
    return {prove::heap_score(keys, verdicts), times_of(out / "verdicts", names)};
}

}  // namespace app
