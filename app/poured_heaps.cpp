// SPDX-License-Identifier: MIT
#include "app/poured_heaps.hpp"

#include "app/experiment.hpp"
#include "app/interrupt.hpp"
#include "diagnose/diagnose.hpp"
#include "verify/pile_runs.hpp"
#include "verify/remembered_file.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace app {

namespace {

constexpr std::int64_t steps_at_a_time = 2000;

std::optional<rigs::Heap> pour_one(const rigs::PileSetup& setup, const std::atomic<bool>& stop) {
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    while (!run.finished) {
        if (stop || interrupt_flag()) return std::nullopt;
        rigs::advance(run, setup, steps_at_a_time);
    }
    return rigs::record(run, setup).heap;
}

// Nothing where it is not there or not whole.
std::optional<rigs::Heap> recall(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) return std::nullopt;
    try {
        return heap_of(bytes_of(file.string()));
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

}  // namespace

std::string to_text(const rigs::Heap& h) {
    std::string text = fmt::format("{:a} {}\n", h.base_radius, h.radius.size());
    for (std::size_t k = 0; k < h.radius.size(); ++k)
        text += fmt::format("{:a} {:a} {:a} {:a}\n", h.centre[k].x, h.centre[k].y, h.centre[k].z,
                            h.radius[k]);
    return text + "end\n";
}

rigs::Heap heap_of(const std::string& text) {
    std::istringstream in(text);
    std::string word;
    const auto number = [&] {
        in >> word;
        return std::strtod(word.c_str(), nullptr);
    };
    rigs::Heap h{.centre = {}, .radius = {}, .base_radius = number()};
    std::size_t count = 0;
    in >> count;
    for (std::size_t k = 0; in && k < count; ++k) {
        const double x = number(), y = number(), z = number();
        h.centre.push_back({x, y, z});
        h.radius.push_back(number());
    }
    in >> word;
    if (!in || word != "end" || h.radius.size() != count)
        throw std::runtime_error("a remembered heap that is not whole");
    return h;
}

PouredHeaps::PouredHeaps(std::filesystem::path remembered_in, int threads,
                         std::function<bool(std::size_t, std::size_t)> show)
    : folder_(std::move(remembered_in)), threads_(threads), show_(std::move(show)) {}

std::vector<rigs::Heap> PouredHeaps::operator()(const std::vector<rigs::PileSetup>& setups) {
    std::vector<std::optional<rigs::Heap>> heaps(setups.size());
    std::vector<std::filesystem::path> files(setups.size());
    std::size_t done = 0;
    for (std::size_t k = 0; k < setups.size() && !folder_.empty(); ++k) {
        files[k] = verify::file_of({.name = "heap", .seed = 0, .setup = setups[k]}, folder_);
        heaps[k] = recall(files[k]);
        done += heaps[k].has_value();
    }
    recalled_ += static_cast<int>(done);
    poured_ += static_cast<int>(setups.size() - done);
    std::atomic<bool> stop = !show_(done, setups.size());
    std::atomic<std::size_t> next = 0;
    std::mutex guard;
    std::exception_ptr fault;
    const auto work = [&] {
        for (std::size_t k = next++; k < setups.size() && !stop; k = next++) {
            if (heaps[k]) continue;
            try {
                const auto start = std::chrono::steady_clock::now();
                std::optional<rigs::Heap> heap = pour_one(setups[k], stop);
                if (!heap) return;
                if (!folder_.empty()) verify::write_whole(files[k], to_text(*heap));
                const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
                const std::lock_guard lock(guard);
                heaps[k] = std::move(heap);
                seconds_ += took.count();
                if (!show_(++done, setups.size())) stop = true;
            } catch (...) {
                const std::lock_guard lock(guard);
                fault = std::current_exception();
                stop = true;
            }
        }
    };
    std::vector<std::thread> team;
    for (int n = 1; n < threads_; ++n) team.emplace_back(work);
    work();
    for (std::thread& t : team) t.join();
    if (fault) std::rethrow_exception(fault);
    std::vector<rigs::Heap> all;
    for (std::optional<rigs::Heap>& heap : heaps) {
        if (!heap) throw diagnose::Interrupted{};
        all.push_back(std::move(*heap));
    }
    return all;
}

}  // namespace app
