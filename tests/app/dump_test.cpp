// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

struct Snapshot {
    long step = 0;
    double time = 0.0;                           // s
    std::vector<std::array<double, 4>> loose{};  // x, y, z, radius; m
};

double next_number(std::istream& in) {
    std::string word;
    in >> word;
    return std::strtod(word.c_str(), nullptr);
}

// A LAMMPS dump with the columns id type x y z vx vy vz omegax omegay omegaz radius mass diameter.
std::vector<Snapshot> snapshots(const std::string& path) {
    std::istringstream in(contents(path));
    std::vector<Snapshot> all;
    std::size_t grains = 0;
    for (std::string line; std::getline(in, line);) {
        if (line == "ITEM: TIME") {
            all.emplace_back();
            all.back().time = next_number(in);
        }
        if (line == "ITEM: TIMESTEP") all.back().step = static_cast<long>(next_number(in));
        if (line == "ITEM: NUMBER OF ATOMS") grains = static_cast<std::size_t>(next_number(in));
        if (line.find("ITEM: ATOMS") != 0) continue;
        for (std::size_t k = 0; k < grains; ++k) {
            std::array<double, 14> column{};
            for (double& value : column) value = next_number(in);
            if (column[1] == 1.0)
                all.back().loose.push_back({column[2], column[3], column[4], column[11]});
        }
    }
    return all;
}

std::vector<std::array<double, 4>> rows_of(const std::string& csv) {
    std::istringstream in(contents(csv));
    std::string line;
    std::getline(in, line);  // heading
    std::vector<std::array<double, 4>> rows;
    while (std::getline(in, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream cells(line);
        rows.emplace_back();
        for (double& value : rows.back()) value = next_number(cells);
    }
    return rows;
}

std::size_t times_in(const std::string& text, const std::string& part) {
    std::size_t times = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++times;
    return times;
}

void expect_complaint(const Outcome& o, const std::vector<std::string>& parts) {
    INFO(o.err);
    CHECK(o.code == 2);
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    for (const std::string& part : parts) {
        INFO(part);
        CHECK(o.err.find(part) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("dump: a frame each 20 ms and one of the heap at rest, in every format", "[app][dump]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 60"));
    const Outcome o = similitude({"simulate", path, "--out", f / "out", "--dump",
                                  "extxyz,lammps,vtp", "--dump-every", "20 ms"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const Json run = Json::parse(contents(f / "out/run.json")).at("runs").at(0);
    const double step = run.at("result").at("time_step");

    const std::vector<Snapshot> frames = snapshots(f / "out/pile.lammpstrj");
    REQUIRE(frames.size() > 3);
    for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
        // At the nearest step; half a step of room for that and 1e-9 of it for round-off.
        CHECK(std::abs(frames[k].time - 0.02 * static_cast<double>(k)) <=
              0.5 * step * (1.0 + 1e-9));
        CHECK(frames[k].time == Approx(step * static_cast<double>(frames[k].step)).epsilon(1e-12));
        CHECK(frames[k].step < frames[k + 1].step);
    }
    CHECK(frames.front().loose.empty());  // nothing has been fed at step 0
    CHECK(frames.back().step == run.at("result").at("steps"));
    CHECK(frames.back().loose == rows_of(f / "out/pile-grains.csv"));

    const std::string pvd = contents(f / "out/pile.pvd");
    CHECK(times_in(pvd, "<DataSet ") == frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        std::string number = std::to_string(k);
        number.insert(0, 6 - number.size(), '0');
        const std::string name = "pile-vtp/frame-" + number + ".vtp";
        CHECK(times_in(pvd, name) == 1);
        CHECK(std::filesystem::exists(f / ("out/" + name)));
    }
    CHECK(times_in(contents(f / "out/pile.extxyz"), "Lattice=") == frames.size());
    CHECK(run.at("dumps").at("frames") == frames.size());
    CHECK(run.at("dumps").at("files") == Json({"pile.lammpstrj", "pile.pvd", "pile.extxyz"}));
}

TEST_CASE("dump: the frames of an earlier run do not stay behind those of a shorter one",
          "[app][dump]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 20"));
    const auto frames = [&](const std::string& every) {
        REQUIRE(similitude({"simulate", path, "--out", f / "out", "--dump", "vtp,lammps",
                            "--dump-every", every})
                    .code == 0);
        const auto folder = std::filesystem::directory_iterator(f / "out/pile-vtp");
        const auto files = static_cast<std::size_t>(std::distance(begin(folder), end(folder)));
        CHECK(files == snapshots(f / "out/pile.lammpstrj").size());
        return files;
    };
    const std::size_t many = frames("10 ms");  // in this order: the longer run first
    CHECK(frames("50 ms") < many);
}

TEST_CASE("dump: nothing is dumped unasked", "[app][dump]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 20"));
    REQUIRE(similitude({"simulate", path, "--out", f / "out"}).code == 0);
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(f / "out"))
        files.push_back(entry.path().filename());
    std::sort(files.begin(), files.end());
    CHECK(files == std::vector<std::string>{"pile-grains.csv", "pile.csv", "run.json"});
}

TEST_CASE("dump: a mistake in what to dump is one line that says the way out",
          "[app][dump][input]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    const auto with = [&](const std::string& formats, const std::string& every) {
        std::vector<std::string> words = {"simulate", path, "--out", f / "out"};
        if (!formats.empty()) words.insert(words.end(), {"--dump", formats});
        if (!every.empty()) words.insert(words.end(), {"--dump-every", every});
        return similitude(words);
    };
    expect_complaint(with("lamps", "1 ms"), {"--dump", "lamps", "did you mean", "lammps"});
    expect_complaint(with("vtp", ""), {"--dump-every", "must stand beside --dump"});
    expect_complaint(with("", "1 ms"), {"--dump:", "must stand beside --dump-every"});
    expect_complaint(with("vtp", "1"), {"--dump-every", "must be a time"});
    expect_complaint(with("vtp", "1 mm"), {"--dump-every", "1 mm", "must be a time"});
    expect_complaint(with("vtp", "0 ms"), {"--dump-every", "0 ms", "must be > 0"});
    expect_complaint(with("vtp", "1 us"), {"--dump-every", "1 us", "shorter than a time step"});
    expect_complaint(with("vtp", "20 us"), {"--dump-every", "1e4 frames", "--yes"});
    expect_complaint(similitude({"simulate", path, "--checkpoint-every", "0 s"}),
                     {"--checkpoint-every", "must be > 0"});
    CHECK_FALSE(std::filesystem::exists(f / "out"));
}
