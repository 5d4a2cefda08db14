// SPDX-License-Identifier: MIT
#include "engines/process.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <unistd.h>

using engines::Finished;

namespace {

Finished shell(const std::string& script, double limit_s = 20.0) {
    return engines::run({"sh", "-c", script}, "/", limit_s);
}

// Not there, or dead and only not yet taken note of by its parent ("Z"; proc(5), stat).
bool dead(const std::string& pid) {
    std::ifstream stat("/proc/" + std::to_string(std::stoi(pid)) + "/stat");
    std::string number, name, state;
    return !(stat >> number >> name >> state) || state == "Z";
}

// A killed process is gone as soon as it is next scheduled: within a second.
bool gone(const std::string& pid) {
    for (int k = 0; k < 100 && !dead(pid); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return dead(pid);
}

}  // namespace

TEST_CASE("process: output, error and exit code come back, in order", "[engines][process]") {
    const Finished f = shell("echo one; echo two >&2; pwd; exit 3");
    CHECK(f.out == "one\ntwo\n/\n");
    CHECK(f.exit_code == 3);
    CHECK_FALSE(f.timed_out);
    CHECK(shell("kill -KILL $$").exit_code == 128 + SIGKILL);
}

TEST_CASE("process: an argument reaches the program as it is", "[engines][process]") {
    CHECK(engines::run({"printf", "%s", "a b'$HOME\"*"}, "/", 20.0).out == "a b'$HOME\"*");
}

TEST_CASE("process: more output than a pipe holds", "[engines][process]") {
    // A pipe of Linux holds 64 KiB.
    CHECK(shell("head -c 1000000 /dev/zero").out.size() == 1000000);
}

TEST_CASE("process: a program that does not exist says so", "[engines][process]") {
    const Finished f = engines::run({"no-such-program-here"}, "/", 20.0);
    CHECK(f.exit_code == 127);
    CHECK(f.out.find("no-such-program-here") != std::string::npos);
    CHECK(f.out.find("No such file") != std::string::npos);
    CHECK(engines::run({"true"}, "/no/such/folder", 20.0).exit_code == 127);
}

TEST_CASE("process: at the limit the program and all that it started are ended",
          "[engines][process]") {
    const Finished f = shell("sleep 60 & echo $!; wait", 0.3);
    CHECK(f.timed_out);
    CHECK(f.exit_code == 128 + SIGTERM);
    CHECK(f.seconds >= 0.3);
    CHECK(f.seconds < 20.0);
    CHECK(gone(f.out));
}

TEST_CASE("process: at the limit all of the group are asked to end, not only its first",
          "[engines][process]") {
    // The first one waits for the second, as mpirun does for its ranks.
    const Finished f = shell(
        "trap : TERM; sh -c 'trap \"echo bye; exit\" TERM; while :; do sleep 0.1; done' & wait; "
        "wait",
        0.5);
    CHECK(f.timed_out);
    CHECK(f.out.find("bye\n") != std::string::npos);  // beside what the shell says
}

TEST_CASE("process: who does not listen to SIGTERM is killed", "[engines][process]") {
    const Finished f = shell("trap '' TERM; while :; do sleep 0.1; done", 0.3);
    CHECK(f.timed_out);
    CHECK(f.exit_code == 128 + SIGKILL);
}

TEST_CASE("process: what a program left running behind it does not keep us waiting",
          "[engines][process]") {
    const Finished f = shell("sleep 60 & echo $!");
    CHECK(f.exit_code == 0);
    CHECK(f.seconds < 20.0);
    CHECK(gone(f.out));
}

namespace {
volatile std::sig_atomic_t heard = 0;
}

TEST_CASE("process: an interrupt ends the program and reaches who waited for it",
          "[engines][process]") {
    const auto before = std::signal(SIGINT, [](int) { heard = 1; });
    const Finished f = shell("kill -INT " + std::to_string(getpid()) + "; sleep 60");
    std::signal(SIGINT, before);
    CHECK(f.exit_code == 128 + SIGTERM);
    CHECK_FALSE(f.timed_out);
    CHECK(heard == 1);
}

TEST_CASE("process: programs are found on PATH, and only if they can be run",
          "[engines][process]") {
    CHECK(engines::find_program("sh").has_value());
    CHECK(engines::find_program("sh")->is_absolute());
    CHECK(engines::find_program("/bin/sh") == std::filesystem::path("/bin/sh"));
    CHECK_FALSE(engines::find_program("no-such-program-here").has_value());
    CHECK_FALSE(engines::find_program("/etc/passwd").has_value());
    CHECK_FALSE(engines::find_program("").has_value());
}

TEST_CASE("process: a command is shown so that it can be typed again", "[engines][process]") {
    CHECK(engines::command_line({"lmp", "-in", "a b", "it's"}) == R"(lmp -in 'a b' 'it'\''s')");
    const Finished f = shell("printf %s " + engines::command_line({"it's a $HOME"}));
    CHECK(f.out == "it's a $HOME");
}
