// SPDX-License-Identifier: MIT
// One case given to a judge in a process of its own, and what is kept of how it ended: in a folder of verdicts NAME.json and, written
// last, NAME.ended.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace app {

std::filesystem::path ended(const std::filesystem::path& verdicts, const std::string& name);

// `words`: judge, "diagnose", case and further arguments; --json FILE behind the case and --quiet at the end are added. A verdict is
// kept only where the judge ended with an exit code of one. `limit`: s of processor time. Nothing is written where `stop` came first.
void judge_case(std::vector<std::string> words, const std::filesystem::path& verdicts,
                const std::string& name, double limit, const std::atomic<bool>& stop);

// NAME.ended of a case that no judge has seen, with the reason.
void not_judged(const std::filesystem::path& verdicts, const std::string& name,
                const std::string& how, const std::string& why);

struct Times {
    double mean = 0.0, longest = 0.0;  // s of processor time of a case's first judgement
    int count = 0, failures = 0;  // crashes, refusals and time-outs, whose verdict counts as wrong
};
Times times_of(const std::filesystem::path& verdicts, const std::set<std::string>& names);

// each(k) for k in [0, count), by so many threads; the first exception is thrown on.
void share(std::size_t count, int threads, const std::atomic<bool>& stop,
           const std::function<void(std::size_t)>& each);

}  // namespace app
