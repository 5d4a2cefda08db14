// SPDX-License-Identifier: MIT
// The verb around the measurement: which engines run, in which order, what is told. Engines are
// played by scripts, so that no test depends on what is installed or on how fast it is.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

// PATH as given, for as long as it lives.
class Path {
  public:
    explicit Path(const std::string& value) : before_(std::getenv("PATH")) {
        setenv("PATH", value.c_str(), 1);
    }
    ~Path() { setenv("PATH", before_.c_str(), 1); }
    Path(const Path&) = delete;
    Path& operator=(const Path&) = delete;

  private:
    std::string before_;
};

void write_script(const Folder& f, const std::string& name, const std::string& body) {
    using std::filesystem::perms;
    std::filesystem::permissions(f.write(name, "#!/bin/sh\n" + body + "\n"), perms::owner_all);
}

// A machine with LAMMPS alone: mpirun prints what the real one printed.
void play_lammps(const Folder& f) {
    write_script(f, "lmp", "exit 1");
    write_script(f, "mpirun",
                 "exec /bin/cat '" +
                     std::filesystem::absolute("tests/engines/data/lammps-output.txt").string() +
                     "'");
}

std::vector<std::string> small(const Folder& f, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"bench",   "--bed", "10x10x3",   "--warm-up", "300",
                                    "--steps", "200",   "--repeats", "2",         "--threads",
                                    "1",       "--out", f / "out"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace

TEST_CASE("bench: ours and the others run in turn, and each pair gives a ratio", "[app][bench]") {
    const Folder f;
    play_lammps(f);
    const Path path(f / "");
    const Outcome o = similitude(small(f, {"--json", "-", "--report", f / "page.html"}));
    INFO(o.err);
    REQUIRE(o.code == 0);
    const auto json = o.json();
    for (const char* key : {"ratio", "runs", "bed", "engines", "machine", "stream"}) {
        INFO(key);
        CHECK(json.contains(key));
    }
    const auto runs = json.at("runs");
    REQUIRE(runs.size() == 4);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(runs[k].at("engine") == (k % 2 == 0 ? "similitude" : "lammps"));
    CHECK(runs[0].at("grains") == 300);
    CHECK(runs[1].at("seconds") == 0.00294303);  // stands in the sample
    std::vector<double> ratios;
    for (std::size_t k = 0; k < 4; k += 2)
        ratios.push_back(0.00294303 / runs[k].at("seconds").get<double>());
    const auto ratio = json.at("ratios").at("lammps");
    CHECK(json.at("ratio") == ratio.at("median"));
    CHECK(ratio.at("low").get<double>() == Approx(std::min(ratios[0], ratios[1])));
    CHECK(ratio.at("high").get<double>() == Approx(std::max(ratios[0], ratios[1])));
    CHECK(ratio.at("median").get<double>() == Approx(0.5 * (ratios[0] + ratios[1])));
    CHECK(json.at("engines").at(1).at("version") == "LAMMPS (29 Sep 2021 - Update 2)");
    CHECK(json.at("engines").at(1).at("command").get<std::string>().find("mpirun -np 1") == 0);
    CHECK(json.at("bed").at("grains") == 300);
    const std::string page = contents(f / "page.html");
    CHECK(page.find("times the speed of LAMMPS") != std::string::npos);
    CHECK(page.find("id=\"runs\"") != std::string::npos);
}

TEST_CASE("bench: decks and outputs stay where the commands say", "[app][bench]") {
    const Folder f;
    play_lammps(f);
    const Path path(f / "");
    const Outcome o = similitude(small(f, {}));
    INFO(o.err);
    REQUIRE(o.code == 0);
    CHECK(o.out.find("cd " + f / "out/bench/lammps" + " && mpirun -np 1") != std::string::npos);
    CHECK(contents(f / "out/bench/lammps/bed.in").find("read_data bed.data") != std::string::npos);
    CHECK(contents(f / "out/bench/lammps/output-2.txt") ==
          contents("tests/engines/data/lammps-output.txt"));
}

TEST_CASE("bench: without another engine it still times ours, and says so", "[app][bench]") {
    const Folder f;
    const Path path(f / "");
    const Outcome o = similitude(small(f, {}));
    INFO(o.err);
    CHECK(o.code == 0);
    CHECK(o.out.find("No other engine was found") != std::string::npos);
}

TEST_CASE("bench: an engine that is not there is named with its package", "[app][bench]") {
    const Folder f;
    const Path path(f / "");
    for (const std::string name : {"lammps", "liggghts", "yade"}) {
        const Outcome o = similitude(small(f, {"--against", name}));
        CHECK(o.code == 2);
        CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
        CHECK(o.err.find("apt-get install " + name) != std::string::npos);
    }
}

TEST_CASE("bench: an engine that fails is quoted in one line", "[app][bench]") {
    const Folder f;
    write_script(f, "lmp", "exit 1");
    write_script(f, "mpirun", "echo 'ERROR: Unknown pair style granular'; exit 7");
    const Path path(f / "");
    const Outcome o = similitude(small(f, {"--against", "lammps"}));
    CHECK(o.code == 1);
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    CHECK(o.err.find("Unknown pair style granular") != std::string::npos);
    CHECK(o.err.find("exit code 7") != std::string::npos);
}

TEST_CASE("bench: an interrupt ends the other engine too", "[app][bench]") {
    const Folder f;
    write_script(f, "lmp", "exit 1");
    write_script(f, "mpirun", "echo $$ > '" + f / "pid" + "'; exec /bin/sleep 60");
    const Path path(f / "");
    const Outcome o = similitude(small(f, {"--against", "lammps"}), {{2000, SIGINT}});
    CHECK(o.code == 130);
    REQUIRE(std::filesystem::exists(f / "pid"));  // it had been started by then
    std::ifstream stat("/proc/" + std::to_string(std::stoi(contents(f / "pid"))) + "/stat");
    std::string number, name, state = "gone";
    stat >> number >> name >> state;
    CHECK((state == "gone" || state == "Z"));
}

TEST_CASE("bench: mistakes on the command line", "[app][bench][input]") {
    const auto complaint = [](const std::vector<std::string>& more) {
        std::vector<std::string> all = {"bench"};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome o = similitude(all);
        CHECK(o.code == 2);
        CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
        return o.err;
    };
    CHECK(complaint({"--against", "lamps"}).find("did you mean lammps?") != std::string::npos);
    CHECK(complaint({"--bed", "30x30"}).find("write 30x30x50") != std::string::npos);
    CHECK(complaint({"--bed", "2x30x50"}).find("at least 3x3x1") != std::string::npos);
    CHECK(complaint({"--bed", "30x30x50m"}).find("--bed") != std::string::npos);
    CHECK(complaint({"--resume"}).find("--resume") != std::string::npos);
    CHECK(complaint({"--scaling", "--against", "lammps"}).find("--scaling") != std::string::npos);
    CHECK(complaint({"--repeats", "0"}).find("repeats") != std::string::npos);
}
