// SPDX-License-Identifier: MIT
#include "prove/campaign.hpp"

#include "scaling/errors.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace prove {
namespace {

struct Shard {
    int part, of;
};

Shard read_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    Shard s{0, 0};
    if (slash != std::string::npos)
        s = {std::atoi(text.c_str()), std::atoi(text.c_str() + slash + 1)};
    if (s.part < 1 || s.of < 1 || s.part > s.of)
        throw scaling::InvalidInput(scaling::mistake(
            "--shard", '"' + text + '"', "must be i/n with 1 <= i <= n", "write --shard 1/4"));
    return s;
}

bool is_whole(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::size_t last = text.find_last_not_of(" \n\r\t");
    return last != std::string::npos && text[last] == '}';
}

}  // namespace

std::vector<int> numbers_of(const Extent& extent) {
    if (extent.cases < 1)
        throw scaling::InvalidInput(scaling::mistake("--cases", std::to_string(extent.cases),
                                                     "must be at least 1", "write --cases 1200"));
    bool known = extent.rig.empty();
    for (const Rig rig : {Rig::drop, Rig::incline, Rig::impact, Rig::pull_off})
        known = known || extent.rig == to_string(rig);
    if (!known)
        throw scaling::InvalidInput(scaling::mistake("--rig", '"' + extent.rig + '"',
                                                     "must be a rig of single grains",
                                                     "known: drop, incline, impact, pull_off"));
    const Shard shard = read_shard(extent.shard);
    std::vector<int> numbers;
    int found = 0;
    for (int number = 1; found < extent.cases; ++number) {
        const Plan p = plan(extent.seed, number);
        if (extent.kind && p.kind != *extent.kind) continue;
        if (!extent.rig.empty() && extent.rig != to_string(p.rig)) continue;
        if (found % shard.of == shard.part - 1) numbers.push_back(number);
        ++found;
    }
    return numbers;
}

bool is_written(int number, const std::filesystem::path& cases, const std::filesystem::path& keys) {
    // The key is written last.
    return is_whole(cases / case_name(number) / "case.json") &&
           is_whole(keys / (case_name(number) + ".json"));
}

bool is_judged(int number, const std::filesystem::path& verdicts) {
    return is_whole(verdicts / (case_name(number) + ".json"));
}

}  // namespace prove
