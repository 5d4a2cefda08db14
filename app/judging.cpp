// SPDX-License-Identifier: MIT
#include "app/judging.hpp"

#include "app/child.hpp"
#include "app/common.hpp"
#include "app/exit_code.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <fstream>
#include <mutex>
#include <thread>

namespace app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

bool is_verdict(const ChildEnd& end) {
    return end.exit_code && (*end.exit_code == fine || *end.exit_code == answer_is_no ||
                             *end.exit_code == cannot_tell);
}

std::string how(const ChildEnd& end) {
    if (end.out_of_time) return "out of time";
    return end.exit_code ? fmt::format("exit {}", *end.exit_code)
                         : fmt::format("signal {}", end.signal);
}

void write_end(const fs::path& verdicts, const std::string& name, const ordered_json& record) {
    constexpr auto as_is = ordered_json::error_handler_t::replace;
    fs::create_directories(verdicts);
    write_file(ended(verdicts, name).string(), record.dump(2, ' ', false, as_is) + "\n");
}

}  // namespace

fs::path ended(const fs::path& verdicts, const std::string& name) {
    return verdicts / (name + ".ended");
}

void judge_case(std::vector<std::string> words, const fs::path& verdicts, const std::string& name,
                double limit, const std::atomic<bool>& stop) {
    fs::create_directories(verdicts);
    const fs::path verdict = verdicts / (name + ".json");
    fs::remove(verdict);
    words.insert(words.begin() + 3, {"--json", verdict.string()});
    words.push_back("--quiet");
    const ChildEnd end = run_child(words, limit, stop);
    if (stop && !end.exit_code) return;
    if (!is_verdict(end)) fs::remove(verdict);  // it may have been cut off
    write_end(verdicts, name,
              {{"ended", how(end)},
               {"is_verdict", is_verdict(end)},
               {"cpu_seconds", end.cpu_seconds},
               {"words", end.last_words}});
}

void not_judged(const fs::path& verdicts, const std::string& name, const std::string& how,
                const std::string& why) {
    write_end(verdicts, name,
              {{"ended", how}, {"is_verdict", false}, {"cpu_seconds", 0.0}, {"words", why}});
}

Times times_of(const fs::path& verdicts, const std::set<std::string>& names) {
    Times times;
    double sum = 0.0;
    for (const std::string& name : names) {
        std::ifstream in(ended(verdicts, name));
        const ordered_json record = ordered_json::parse(in, nullptr, false);
        if (!record.is_object()) continue;
        const double seconds = record.value("cpu_seconds", 0.0);
        sum += seconds, times.longest = std::max(times.longest, seconds);
        times.failures += record.value("is_verdict", false) ? 0 : 1;
        ++times.count;
    }
    times.mean = times.count > 0 ? sum / times.count : 0.0;
    return times;
}

void share(std::size_t count, int threads, const std::atomic<bool>& stop,
           const std::function<void(std::size_t)>& each) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr fault;
    std::mutex guard;
    const auto turn = [&] {
        for (std::size_t k; !stop && (k = next++) < count;) try {
                each(k);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!fault) fault = std::current_exception();
                next = count;
            }
    };
    {
        std::vector<std::jthread> team;
        for (int t = 1; t < threads; ++t) team.emplace_back(turn);
        turn();
    }
    if (fault) std::rethrow_exception(fault);
}

}  // namespace app
