// SPDX-License-Identifier: MIT
// The verb around the judge: what reaches it, what it may see, what becomes of its verdict. The judge
// here is made up; the whole command line besides is the program's own.
#include "app/diagnose.hpp"

#include "app/poured_heaps.hpp"
#include "app/program.hpp"
#include "cases/read_case.hpp"
#include "command_line.hpp"
#include "rigs/pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using diagnose::Answer;

namespace {

const std::string recording = "t [s],z [mm]\n0,500\n0.1,451\n0.2,304\n";

std::string drops() {
    return R"({
  "format": "similitude-case/1",
  "title": "two drops",
  "grain": {"diameter": "4 mm", "density": "28 kg/m^3", "youngs_modulus": "3 GPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.28},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin"], "parameters": {"restitution": {"value": 0.7, "range": [0.2, 0.98]}}},
  "experiments": [
    {"id": "drop-1", "rig": "drop", "conditions": {"height": "500 mm"}, "recording": "drop-1.csv", "role": "fit"},
    {"id": "drop-2", "rig": "drop", "conditions": {"height": "500 mm"}, "recording": "drop-2.csv", "role": "held_out"}
  ]
})";
}

// A folder with the case and both recordings.
void fill(const Folder& f, const std::string& first = recording) {
    f.write("case.json", drops());
    f.write("drop-1.csv", first);
    f.write("drop-2.csv", recording);
}

diagnose::Verdict verdict(Answer answer, const diagnose::Settings& settings = {}) {
    diagnose::Verdict v{};
    v.title = "two drops";
    v.seed = settings.seed;
    v.answer = answer;
    v.p_value = 0.5;
    v.summary = {"A sentence."};
    return v;
}

// Gives this answer and looks at nothing.
app::Judge saying(Answer answer) {
    return [answer](const cases::Case&, const diagnose::Settings& s, const auto&) {
        return verdict(answer, s);
    };
}

diagnose::Verdict must_not_judge(const cases::Case&, const diagnose::Settings&,
                                 const std::function<void(cases::Case&)>&) {
    throw std::logic_error("the judge was asked");
}

Outcome diagnosed(std::vector<std::string> arguments, const app::Judge& judge,
                  const std::vector<Signal>& signals = {}) {
    arguments.insert(arguments.begin(), {"similitude", "diagnose"});
    std::vector<char*> argv;
    for (std::string& word : arguments) argv.push_back(word.data());
    argv.push_back(nullptr);
    return in_child(
        [&] { return app::program(static_cast<int>(arguments.size()), argv.data(), judge); },
        signals);
}

// A mistake in the case: the judge is not asked, and one line says what is wrong.
void expect_refusal(const std::string& first_recording, const std::vector<std::string>& parts) {
    const Folder f;
    fill(f, first_recording);
    const Outcome o = diagnosed({f / "case.json"}, must_not_judge);
    INFO(o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    for (const std::string& part : parts) {
        INFO(part);
        CHECK(o.err.find(part) != std::string::npos);
    }
}

void expect_judged(const std::string& first_recording) {
    const Folder f;
    fill(f, first_recording);
    const Outcome o = diagnosed({f / "case.json"}, saying(Answer::undecided));
    INFO(o.err);
    CHECK(o.code == 4);
    CHECK(o.err.empty());
}

}  // namespace

TEST_CASE("diagnose: the exit code tells the answer", "[app][diagnose]") {
    const auto [answer, code] =
        GENERATE(std::pair{Answer::consistent, 0}, std::pair{Answer::explained, 3},
                 std::pair{Answer::unexplained, 3}, std::pair{Answer::ambiguous, 4},
                 std::pair{Answer::undecided, 4});
    const Folder f;
    fill(f);
    const Outcome o = diagnosed({f / "case.json"}, saying(answer));
    CHECK(o.code == code);
    CHECK(o.out.starts_with("two drops\n"));
    CHECK(o.out.find("A sentence.") != std::string::npos);
}

TEST_CASE("diagnose: --json - leaves standard output to the verdict, --quiet to nobody",
          "[app][diagnose]") {
    const Folder f;
    fill(f);
    const Outcome o =
        diagnosed({f / "case.json", "--json", "-", "--seed", "42"}, saying(Answer::consistent));
    const nlohmann::ordered_json json = o.json();
    CHECK(json["format"] == "similitude-verdict/1");
    CHECK(json["tool"]["seed"] == 42);
    CHECK(json["verdict"] == "consistent");
    const Outcome quiet = diagnosed({f / "case.json", "--quiet", "--report", f / "out/page.html"},
                                    saying(Answer::consistent));
    CHECK(quiet.out.empty());
    CHECK(contents(f / "out/page.html").find("id=\"where\"") != std::string::npos);
}

TEST_CASE("diagnose: seed, threads and alpha reach the judge", "[app][diagnose]") {
    const Folder f;
    fill(f);
    const app::Judge judge = [](const cases::Case&, const diagnose::Settings& s, const auto&) {
        const bool right = s.seed == 9 && s.threads == 3 && s.alpha == 0.01;
        return verdict(right ? Answer::consistent : Answer::undecided);
    };
    CHECK(diagnosed({f / "case.json", "--seed", "9", "--threads", "3", "--alpha", "0.01"}, judge)
              .code == 0);
    CHECK(diagnosed({f / "case.json", "--alpha", "1.5"}, must_not_judge).code == 2);
}

TEST_CASE("diagnose: the judge has the held-out recording when it asks for it, not before",
          "[app][diagnose]") {
    const Folder f;
    fill(f);
    const app::Judge judge = [](const cases::Case& c, const diagnose::Settings&,
                                const std::function<void(cases::Case&)>& open) {
        const bool sealed = !c.find("drop-2")->recording && c.find("drop-1")->recording;
        cases::Case whole = c;
        open(whole);
        const bool opened = whole.find("drop-2")->recording.has_value();
        return verdict(sealed && opened ? Answer::consistent : Answer::undecided);
    };
    CHECK(diagnosed({f / "case.json"}, judge).code == 0);

    std::filesystem::remove(f / "drop-2.csv");
    CHECK(diagnosed({f / "case.json"}, saying(Answer::explained)).code == 3);  // never missed
    const Outcome late = diagnosed({f / "case.json"}, judge);
    CHECK(late.code == 2);
    CHECK(late.err.find("experiments[1].recording: got \"drop-2.csv\"") != std::string::npos);
}

TEST_CASE("diagnose: a signal ends the judge between two of its steps", "[app][diagnose]") {
    const Folder f;
    fill(f);
    const app::Judge judge = [](const cases::Case&, const diagnose::Settings& s,
                                const auto&) -> diagnose::Verdict {
        for (int k = 0; k < 3000; ++k) {  // half a minute at most
            if (!s.progress(k / 3000.0, "waiting")) throw diagnose::Interrupted{};
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return verdict(Answer::consistent);
    };
    const Outcome o =
        diagnosed({f / "case.json", "--json", f / "verdict.json"}, judge, {{500, SIGINT}});
    CHECK(o.code == 130);
    CHECK(o.err.find("interrupted") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(f / "verdict.json"));
}

TEST_CASE("diagnose: --predict writes base and extended of each channel, with units",
          "[app][diagnose]") {
    const Folder f;
    fill(f);
    const app::Judge judge = [](const cases::Case&, const diagnose::Settings&, const auto&) {
        diagnose::Verdict v = verdict(Answer::consistent);
        diagnose::PredictedCurve c{};
        c.experiment = "curve";
        c.ordinate = "separation";
        c.ordinate_unit = c.unit = "m";
        c.channel = "force";
        c.unit = "N";
        c.at = {2e-9, 1e-9, 1e-9, 2e-9};
        c.branch = {"approach", "approach", "retract", "retract"};
        c.base = {0.0, 1.0, 2.0, 3.0};
        c.extended = {0.5, 1.5, 2.5, 3.5};
        v.curves.push_back(c);
        c.experiment = "run";
        c.ordinate = "t";
        c.ordinate_unit = "s";
        c.channel = "s";
        c.unit = "m";
        c.branch.clear();
        c.at = {0.0, 0.1, 0.2, 0.3};
        v.curves.push_back(c);
        c.channel = "spin";
        c.unit = "rad/s";
        c.at = {0.1, 0.3};  // two cells of the recording were empty
        c.base = {7.0, 8.0};
        c.extended = {7.5, 8.5};
        v.curves.push_back(c);
        return v;
    };
    CHECK(diagnosed({f / "case.json", "--predict", f / "out/predicted"}, judge).code == 0);
    CHECK(contents(f / "out/predicted/curve.csv") ==
          "separation [m],branch,force_base [N],force_extended [N]\n"
          "2e-09,approach,0,0.5\n1e-09,approach,1,1.5\n1e-09,retract,2,2.5\n2e-09,retract,3,3.5\n");
    CHECK(contents(f / "out/predicted/run.csv") ==
          "t [s],s_base [m],s_extended [m],spin_base [rad/s],spin_extended [rad/s]\n"
          "0,0,0.5,,\n0.1,1,1.5,7,7.5\n0.2,2,2.5,,\n0.3,3,3.5,8,8.5\n");
}

TEST_CASE("diagnose: a folder that cannot be made is refused before the work begins",
          "[app][diagnose]") {
    const Folder f;
    fill(f);
    const Outcome o =
        diagnosed({f / "case.json", "--predict", f / "case.json/inside"}, must_not_judge);
    CHECK(o.code == 2);
    CHECK(o.err.find("--predict") != std::string::npos);
}

TEST_CASE("diagnose: a missing column", "[app][diagnose][input]") {
    expect_refusal("t [s],x [mm]\n0,1\n",
                   {"drop-1.csv: got t, x, must hold t, z", "add the missing columns"});
}

TEST_CASE("diagnose: a unit of another dimension", "[app][diagnose][input]") {
    expect_refusal("t [s],z [kg]\n0,1\n",
                   {"drop-1.csv: column \"z [kg]\"", "must have the dimension of m", "correct"});
    expect_refusal("t [s],z\n0,1\n", {"no unit", "write the header as \"z [m]\""});
}

TEST_CASE("diagnose: a cell that is no number", "[app][diagnose][input]") {
    expect_refusal("t [s],z [mm]\n0,500\n0.1,high\n",
                   {"drop-1.csv: row 3, z", "\"high\"", "must be a finite number"});
    expect_refusal("t [s],z [mm]\n0,inf\n", {"row 2, z", "\"inf\"", "must be a finite number"});
}

TEST_CASE("diagnose: a recording without rows", "[app][diagnose][input]") {
    expect_refusal("t [s],z [mm]\n", {"drop-1.csv", "a header only", "must have rows"});
}

TEST_CASE("diagnose: missing values, two rows and a constant channel are for the judge to judge",
          "[app][diagnose][input]") {
    expect_judged("t [s],z [mm]\n0,500\n0.1,nan\n0.2,\n0.3,59\n");
    expect_judged("t [s],z [mm]\n0,500\n0.1,451\n");
    expect_judged("t [s],z [mm]\n0,500\n0.1,500\n0.2,500\n0.3,500\n");
}

TEST_CASE("diagnose: a case with nothing but held-out recordings is for the judge to judge",
          "[app][diagnose][input]") {
    const Folder f;
    std::string text = drops();
    text.replace(text.find("\"fit\""), 5, "\"held_out\"");
    f.write("case.json", text);
    CHECK(diagnosed({f / "case.json"}, saying(Answer::undecided)).code == 4);
}

TEST_CASE("diagnose: --help shows two examples", "[app][diagnose]") {
    const Outcome o = diagnosed({"--help"}, must_not_judge);
    CHECK(o.code == 0);
    const std::size_t first = o.out.find("  similitude diagnose ");
    REQUIRE(first != std::string::npos);
    CHECK(o.out.find("  similitude diagnose ", first + 1) != std::string::npos);
}

namespace {

// A scanned heap of a few grains that stick and resist rolling.
void fill_with_heap(const Folder& f) {
    f.write("case.json", R"({
  "format": "similitude-case/1",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "0.2 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "0.2 MPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin", "adhesion", "rolling_resistance"], "parameters": {"restitution": {"value": 0.5},
    "sliding_friction": {"value": 0.5}, "rolling_friction": {"value": 0.2},
    "work_of_adhesion": {"value": "0.1 J/m^2"}}},
  "experiments": [{"id": "heap", "rig": "pile", "conditions": {"base": "glued_grains", "base_diameter": "8 mm", "grains": 15,
    "drop_height": "6 mm"}, "recording": "heap.csv", "noise": {"z": "0.1 mm"}, "role": "fit"}]
})");
    f.write("heap.csv", "azimuth [deg],r [mm],z [mm]\n0,1,2\n90,1,2\n180,1,2\n270,1,2\n");
}

// Says what heap it was given for the first experiment.
diagnose::Verdict heap_in_words(const cases::Case& c, const diagnose::Settings& s, const auto&) {
    diagnose::Verdict v = verdict(Answer::undecided, s);
    v.summary = {app::to_text(s.pour({rigs::pile_setup(c, c.experiments.at(0), 1)}).at(0))};
    return v;
}

}  // namespace

TEST_CASE("diagnose: heaps are poured under the rules of --contact, and remembered apart",
          "[app][diagnose]") {
    const Folder f;
    fill_with_heap(f);
    const app::Judge judge = [](const auto&... all) { return heap_in_words(all...); };
    // Lines of the report are broken where they are long.
    const auto in_one_line = [](std::string text) {
        std::erase_if(text, [](char letter) { return letter == ' ' || letter == '\n'; });
        return text;
    };
    const auto told = [&](const std::string& contact) {
        return in_one_line(
            diagnosed({f / "case.json", "--contact", contact, "--heaps", f / "heaps"}, judge).out);
    };
    const cases::Case c = cases::read_case(f / "case.json");
    const auto poured = [&](bool as_lammps) {
        rigs::PileSetup s = rigs::pile_setup(c, c.experiments.at(0), 1);
        if (as_lammps) rigs::take_lammps_rules(s);
        rigs::PileRun run = rigs::begin_pile(s, 1);
        while (!run.finished) rigs::advance(run, s, 1000);
        std::string text = app::to_text(rigs::record(run, s).heap);
        return in_one_line(text.substr(0, text.find("end")));
    };
    REQUIRE(poured(false) != poured(true));
    for (int k = 0; k < 2; ++k) {  // the second time recalled
        CHECK(told("own").find(poured(false)) != std::string::npos);
        CHECK(told("lammps").find(poured(true)) != std::string::npos);
    }
}

TEST_CASE("diagnose: --contact lammps is refused where no heap is poured",
          "[app][diagnose][input]") {
    const Folder f;
    fill(f);
    const Outcome o = diagnosed({f / "case.json", "--contact", "lammps"}, must_not_judge);
    INFO(o.err);
    CHECK(o.code == 2);
    CHECK(o.err.find("--contact: got lammps") != std::string::npos);
}
