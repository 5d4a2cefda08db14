// SPDX-License-Identifier: MIT
#include "engines/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <string_view>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace engines {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int beat_ms = 50;       // how often the limit and the signals are looked at
constexpr double grace_s = 2.0;   // from SIGTERM to SIGKILL: mpirun ends its ranks in it
constexpr int not_started = 127;  // as a shell has it
constexpr std::array stopping = {SIGINT, SIGTERM, SIGHUP};

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

bool executable(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored) && access(file.c_str(), X_OK) == 0;
}

volatile std::sig_atomic_t caught = 0;  // the last of `stopping`; a handler can reach nothing else

void remember(int signal) { caught = signal; }

// For as long as it lives, signals that would end us are only remembered.
class HeldSignals {
  public:
    HeldSignals() {
        caught = 0;
        struct sigaction mine {};
        mine.sa_handler = remember;
        for (std::size_t k = 0; k < stopping.size(); ++k)
            sigaction(stopping[k], &mine, &before_[k]);
    }
    ~HeldSignals() {
        for (std::size_t k = 0; k < stopping.size(); ++k)
            sigaction(stopping[k], &before_[k], nullptr);
        if (caught != 0) std::raise(caught);
    }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

  private:
    std::array<struct sigaction, stopping.size()> before_{};
};

// In the child, between fork and exec: nothing but system calls.
[[noreturn]] void become(char* const* argv, const char* folder, int output) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // should we be killed outright
    for (const int signal : stopping) std::signal(signal, SIG_DFL);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    if (chdir(folder) == 0) execvp(argv[0], argv);
    const char* why = std::strerror(errno);
    const char* const program = argv[0];
    for (const char* part : {program, " in ", folder, ": ", why, "\n"})
        if (write(STDERR_FILENO, part, std::strlen(part)) < 0) break;
    _exit(not_started);
}

// Waits up to one beat for output and takes what there is; closes the pipe at its end.
void listen(int& pipe, std::string& out) {
    pollfd waiting{pipe, POLLIN, 0};  // a closed pipe is -1, which poll passes over
    if (poll(&waiting, 1, beat_ms) <= 0) return;
    std::array<char, 65536> buffer;
    const ssize_t size = read(pipe, buffer.data(), buffer.size());
    if (size > 0) out.append(buffer.data(), static_cast<std::size_t>(size));
    if (size == 0) close(std::exchange(pipe, -1));
}

// What is left in the pipe once the program has ended; somebody it started may hold the other end.
void drain(int pipe, std::string& out) {
    if (pipe < 0) return;
    fcntl(pipe, F_SETFL, O_NONBLOCK);
    std::array<char, 65536> buffer;
    for (ssize_t size; (size = read(pipe, buffer.data(), buffer.size())) > 0;)
        out.append(buffer.data(), static_cast<std::size_t>(size));
    close(pipe);
}

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
    if (name.find('/') != std::string::npos)
        return executable(name) ? std::optional<std::filesystem::path>(name) : std::nullopt;
    const char* path = std::getenv("PATH");
    std::string_view left = path == nullptr ? "" : path;
    while (!left.empty()) {
        const std::size_t end = std::min(left.find(':'), left.size());
        const std::filesystem::path file = std::filesystem::path(left.substr(0, end)) / name;
        if (!name.empty() && executable(file)) return file;
        left.remove_prefix(std::min(end + 1, left.size()));
    }
    return std::nullopt;
}

Finished run(const std::vector<std::string>& argv, const std::filesystem::path& folder,
             double limit_s, const std::function<void(const std::string&)>& watch) {
    if (argv.empty()) throw std::logic_error("run: no program");
    std::vector<char*> words;
    for (const std::string& word : argv) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("run: no pipe to be had");
    const HeldSignals held;
    const Clock::time_point start = Clock::now();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("run: no process to be had");
    if (child == 0) become(words.data(), folder.c_str(), ends[1]);
    setpgid(child, child);  // here too: whoever comes first
    close(ends[1]);
    Finished result{0, false, "", 0.0};
    int status = 0;
    double asked_at = -1.0;  // s, when the group got SIGTERM
    while (waitpid(child, &status, WNOHANG) == 0) {
        const std::size_t heard = result.out.size();
        listen(ends[0], result.out);
        if (watch && result.out.size() > heard) watch(result.out);
        const double now = since(start);
        if (asked_at < 0.0 && (now > limit_s || caught != 0)) {
            result.timed_out = caught == 0;
            kill(-child, SIGTERM);
            asked_at = now;
        }
        if (asked_at >= 0.0 && now > asked_at + grace_s) kill(-child, SIGKILL);
    }
    kill(-child, SIGKILL);  // whoever it started and left behind
    result.seconds = since(start);
    drain(ends[0], result.out);
    result.exit_code = exit_code_of(status);
    result.stopped = caught != 0;
    return result;
}

std::vector<std::string> mpirun(int ranks) {
    std::vector<std::string> argv = {"mpirun", "-np", std::to_string(ranks)};
    if (geteuid() == 0) argv.push_back("--allow-run-as-root");
    if (ranks > static_cast<int>(std::thread::hardware_concurrency()))
        argv.push_back("--oversubscribe");
    return argv;
}

std::string command_line(const std::vector<std::string>& argv) {
    std::string line;
    for (const std::string& word : argv) {
        const bool plain = !word.empty() && word.find_first_of(" \t'\"$^*()<>|&;`\\") == word.npos;
        std::string quoted;
        for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        line += (line.empty() ? "" : " ") + (plain ? word : "'" + quoted + "'");
    }
    return line;
}

}  // namespace engines
