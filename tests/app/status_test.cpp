// SPDX-License-Identifier: MIT
// What a run says on a terminal: the program gets one and is read for its first line.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// Standard error of `simulate` on a terminal of so many columns, up to the first rewritten line or
// for 60 s; then it is interrupted.
std::string on_terminal(const std::string& path, const std::string& out, unsigned short columns) {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    REQUIRE(terminal >= 0);
    REQUIRE(grantpt(terminal) == 0);
    REQUIRE(unlockpt(terminal) == 0);
    const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    REQUIRE(ioctl(terminal, TIOCSWINSZ, &size) == 0);
    const std::string name = ptsname(terminal);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        dup2(open(name.c_str(), O_RDWR | O_NOCTTY), STDERR_FILENO);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        execl(SIMILITUDE_PROGRAM, "similitude", "simulate", path.c_str(), "--out", out.c_str(),
              "--threads", "1", static_cast<char*>(nullptr));
        _exit(127);
    }
    std::string text;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (text.find("\033[K") == std::string::npos && std::chrono::steady_clock::now() < end) {
        pollfd ready{terminal, POLLIN, 0};
        char buffer[1024];
        if (poll(&ready, 1, 100) > 0) {
            const auto n = read(terminal, buffer, sizeof buffer);
            if (n <= 0) break;
            text.append(buffer, static_cast<std::size_t>(n));
        }
    }
    kill(child, SIGTERM);
    waitpid(child, nullptr, 0);
    close(terminal);
    return text;
}

}  // namespace

TEST_CASE("status: a terminal is told step, time, grains, energy, contacts, speed and what is left",
          "[app][status]") {
    const Folder f;
    // Stiff, so that it runs for long; with the first line it is stopped.
    const std::string path = f.write("case.json", tiny_case("1 MPa", "1 GPa"));
    const std::string line = on_terminal(path, f / "out", 250);
    INFO(line);
    CHECK(line.find('\r') == 0);
    CHECK(line.find('\n') == std::string::npos);
    for (const char* part : {" %  ", " left  ", "pile: step ", "/300 fed, ", " lost, ", "kinetic ",
                             "overlap ", " % of R*, ", " contacts/grain, ", " grain-steps/s"}) {
        INFO(part);
        CHECK(line.find(part) != std::string::npos);
    }
}

TEST_CASE("status: a line is cut to a narrow terminal, so that it can be written over",
          "[app][status]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("1 MPa", "1 GPa"));
    const std::string line = on_terminal(path, f / "out", 60);
    INFO(line);
    const std::size_t end = line.find("\033[K");
    REQUIRE(end != std::string::npos);
    CHECK(end == 1 + 59);  // the return that starts it, and one column less than there are
}

TEST_CASE("status: --quiet says nothing, and a short run nothing where there is no terminal",
          "[app][status]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 20"));
    CHECK(similitude({"simulate", path, "--out", f / "out"}).err.empty());
    const Outcome quiet = similitude({"simulate", path, "--out", f / "out", "--quiet"});
    CHECK(quiet.code == 0);
    CHECK(quiet.err.empty());
    CHECK(quiet.out.empty());
}
