// SPDX-License-Identifier: MIT
#include "app/campaign.hpp"

#include "app/common.hpp"
#include "app/judging.hpp"
#include "cases/json_tree.hpp"
#include "prove/baselines.hpp"
#include "prove/record.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

namespace app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

class Worker {
  public:
    Worker(const Campaign& campaign, const std::atomic<bool>& stop)
        : campaign_(campaign), stop_(stop) {}

    // Everything of one case but its further seeds.
    void work_on(int number) {
        const std::string name = prove::case_name(number);
        std::optional<prove::BlindCase> made;
        const fs::path cases = campaign_.out / "cases", keys = campaign_.out / "keys";
        if (!campaign_.resume || !prove::is_written(number, cases, keys)) {
            made = prove::make_case(campaign_.extent.seed, number);
            prove::write(*made, cases, keys);
        }
        if (campaign_.write_only) return;
        judge(cases / name, campaign_.out / "verdicts", name, campaign_.judge_seed);
        if (stop_) return;
        const auto again = [&]() -> const prove::BlindCase& {
            if (!made) made = prove::make_case(campaign_.extent.seed, number, prove::Figures::none);
            return *made;
        };
        ask_and_judge_again(name, again);
        baseline("bic", name, again, prove::bic_verdict);
        baseline("sparse", name, again, prove::sparse_verdict);
    }

    void work_on_seeds(const std::string& name) {
        for (int k = 1; k <= further_seeds && !stop_; ++k)
            judge(campaign_.out / "cases" / name, campaign_.out / "seeds" / std::to_string(k), name,
                  campaign_.judge_seed + static_cast<std::uint64_t>(k));
    }

  private:
    void judge(const fs::path& folder, const fs::path& verdicts, const std::string& name,
               std::uint64_t seed) {
        if (stop_ || (campaign_.resume && fs::exists(ended(verdicts, name)))) return;
        judge_case({campaign_.judge, "diagnose", folder.string(), "--seed", std::to_string(seed),
                    "--threads", "1"},
                   verdicts, name, campaign_.limit, stop_);
    }

    template <class Again>
    void ask_and_judge_again(const std::string& name, const Again& again) {
        const fs::path first = campaign_.out / "verdicts" / (name + ".json");
        const fs::path after = campaign_.out / "after";
        if (!fs::exists(first) || (campaign_.resume && fs::exists(ended(after, name)))) return;
        const cases::Value verdict = cases::read_json(first.string());
        if (!verdict.has("verdict") || verdict.at("verdict").text() != "ambiguous") return;
        if (!verdict.has("next_experiment")) return;
        const cases::Value wish = verdict.at("next_experiment");
        if (wish.kind != cases::Value::Kind::object) return;
        const fs::path folder = campaign_.out / "asked" / name;
        try {
            for (const auto& [file, content] : prove::record(again(), campaign_.extent.seed, wish))
                write_file((folder / file).string(), content);
        } catch (const std::exception& e) {  // a wish that nobody can fulfil
            not_judged(after, name, "not recorded", e.what());
            return;
        }
        judge(folder, after, name, campaign_.judge_seed);
    }

    template <class Again, class Say>
    void baseline(const std::string& kind, const std::string& name, const Again& again,
                  const Say& say) {
        const fs::path path = campaign_.out / "baselines" / kind / (name + ".json");
        if (stop_ || (campaign_.resume && fs::exists(path))) return;
        write_file(path.string(), prove::verdict_text(name, say(again())));
    }

    const Campaign& campaign_;
    const std::atomic<bool>& stop_;
};

std::set<std::string> names_of(const Campaign& campaign) {
    std::set<std::string> names;
    for (const int number : prove::numbers_of(campaign.extent))
        names.insert(prove::case_name(number));
    return names;
}

template <class All>
All only(All all, const std::set<std::string>& names) {
    std::erase_if(all, [&](const auto& entry) { return !names.contains(entry.first); });
    return all;
}

// Cases whose verdict should not depend on chance.
std::vector<std::string> stable_cases(const Campaign& campaign) {
    constexpr double clear = 5.0;  // separation D
    std::vector<std::string> names;
    for (const auto& [name, key] :
         only(prove::read_keys((campaign.out / "keys").string()), names_of(campaign)))
        if (key.kind == prove::Kind::single && key.separation.d >= clear) names.push_back(name);
    names.resize(std::min(names.size(), static_cast<std::size_t>(std::max(campaign.stability, 0))));
    return names;
}

}  // namespace

bool work(const Campaign& campaign,
          const std::function<void(double, double, const std::string&)>& show,
          const std::atomic<bool>& stop) {
    const std::vector<int> numbers = prove::numbers_of(campaign.extent);
    Worker worker(campaign, stop);
    std::mutex guard;
    double done = 0.0;
    const auto all = static_cast<double>(numbers.size());
    share(numbers.size(), campaign.threads, stop, [&](std::size_t k) {
        worker.work_on(numbers[k]);
        const std::lock_guard lock(guard);
        show(++done, all, prove::case_name(numbers[k]));
    });
    if (campaign.write_only || stop) return !stop;
    const std::vector<std::string> stable = stable_cases(campaign);
    double judged = 0.0;
    share(stable.size(), campaign.threads, stop, [&](std::size_t k) {
        worker.work_on_seeds(stable[k]);
        const std::lock_guard lock(guard);
        show(++judged, static_cast<double>(stable.size()), stable[k] + ", further seeds");
    });
    return !stop;
}

Result score(const Campaign& campaign) {
    const std::set<std::string> names = names_of(campaign);
    const auto verdicts = [&](const fs::path& folder) {
        return only(prove::read_verdicts((campaign.out / folder).string()), names);
    };
    const prove::Keys keys = only(prove::read_keys((campaign.out / "keys").string()), names);
    prove::Judgements judged{.first = verdicts("verdicts"), .after = verdicts("after")};
    const std::vector<std::string> stable = stable_cases(campaign);
    const std::set<std::string> of_seeds(stable.begin(), stable.end());
    for (int k = 1; k <= further_seeds && !stable.empty(); ++k)
        judged.other_seeds.push_back(
            only(verdicts(fs::path("seeds") / std::to_string(k)), of_seeds));
    judged.baselines["bic"] = verdicts("baselines/bic");
    judged.baselines["sparse regression"] = verdicts("baselines/sparse");
    for (const auto& [name, key] : keys) {
        judged.baselines["most common effect"].emplace(name, prove::commonest_verdict(keys));
        judged.baselines["oracle"].emplace(name, prove::oracle_verdict(key));
    }
    return {prove::score(keys, judged), times_of(campaign.out / "verdicts", names)};
}

}  // namespace app
