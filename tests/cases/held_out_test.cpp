// SPDX-License-Identifier: MIT
// What is held out is not touched before it is asked for: a file that cannot be read is the proof.
#include "cases/read_case.hpp"
#include "sample_case.hpp"
#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

namespace {

// The sample case with a recording to its held-out experiment.
std::string held_out_case() {
    return replaced(sample_case, "\"role\": \"held_out\"",
                    "\"recording\": \"drop-2.csv\", \"role\": \"held_out\"");
}

std::string written_into(const TemporaryFolder& folder) {
    folder.write("drop-1.csv", sample_recording);
    return folder.write("case.json", held_out_case());
}

// What opening says, after sealed reading has said nothing; the same as reading all at once.
std::string mistake_on_opening(const std::string& path) {
    cases::Case sealed = cases::read_case(path, cases::HeldOut::sealed);
    CHECK_FALSE(sealed.find("drop-2")->recording);
    const std::string late =
        message_of<scaling::InvalidInput>([&] { cases::open_held_out(sealed); });
    CHECK(message_of<scaling::InvalidInput>([&] { cases::read_case(path); }) == late);
    return late;
}

}  // namespace

TEST_CASE("sealed: a held-out recording is known by its place and read when it is opened",
          "[cases][held_out]") {
    const TemporaryFolder folder;
    const std::string path = written_into(folder);
    folder.write("drop-2.csv", "t [s],z [mm]\n0,1200\n0.1,1151\n");
    cases::Case c = cases::read_case(path, cases::HeldOut::sealed);
    const cases::Experiment& held = *c.find("drop-2");
    CHECK(c.find("drop-1")->recording);
    CHECK_FALSE(held.recording);
    CHECK(held.recording_file->path == folder.path() + "/drop-2.csv");
    CHECK(held.recording_file->name.written_text == "drop-2.csv");

    cases::open_held_out(c);
    CHECK(held.recording->values("z")[1] == Approx(1.151).epsilon(1e-15));
    CHECK(cases::read_case(path).find("drop-2")->recording);
}

TEST_CASE("sealed: a file that comes into being after the verdict is in time",
          "[cases][held_out]") {
    const TemporaryFolder folder;
    cases::Case c = cases::read_case(written_into(folder), cases::HeldOut::sealed);
    folder.write("drop-2.csv", "t [s],z [mm]\n0,1200\n");
    cases::open_held_out(c);
    CHECK(c.find("drop-2")->recording->rows() == 1);
    // Once read, it stays: the file may go.
    std::filesystem::remove(folder.path() + "/drop-2.csv");
    cases::open_held_out(c);
    CHECK(c.find("drop-2")->recording->rows() == 1);
}

TEST_CASE("sealed: a missing file is a mistake only when it is opened", "[cases][held_out]") {
    const TemporaryFolder folder;
    const std::string mistake = mistake_on_opening(written_into(folder));
    CHECK(mistake.find("experiments[1].recording: got \"drop-2.csv\", must be a file") !=
          std::string::npos);
}

TEST_CASE("sealed: content that is no recording is a mistake only when it is opened",
          "[cases][held_out]") {
    const TemporaryFolder folder;
    const std::string path = written_into(folder);
    folder.write("drop-2.csv", "t [s],z [kg]\n0,1200\n");
    CHECK(mistake_on_opening(path).find("drop-2.csv: column \"z [kg]\"") != std::string::npos);
}

TEST_CASE("sealed: a folder in place of the file is a mistake only when it is opened",
          "[cases][held_out]") {
    const TemporaryFolder folder;
    const std::string path = written_into(folder);
    std::filesystem::create_directory(folder.path() + "/drop-2.csv");
    CHECK(mistake_on_opening(path).find("must be a file beside case.json") != std::string::npos);
}

TEST_CASE("sealed: recordings to be fitted are read at once", "[cases][held_out]") {
    const TemporaryFolder folder;
    const std::string path = written_into(folder);
    std::filesystem::remove(folder.path() + "/drop-1.csv");
    CHECK_THROWS_AS(cases::read_case(path, cases::HeldOut::sealed), scaling::InvalidInput);
}
