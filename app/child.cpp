// SPDX-License-Identifier: MIT
#include "app/child.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace app {
namespace {

struct Pipe {
    int ends[2];
    Pipe() {
        if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to a child process");
    }
    ~Pipe() {
        ::close(ends[0]);
        close_writing();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_writing() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
};

pid_t start(const std::vector<std::string>& words, int error_end) {
    std::vector<char*> arguments;
    for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, error_end, STDERR_FILENO);
    // A group of its own: a signal from the keyboard reaches us alone, and we end the child.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    pid_t child = -1;
    const int fault =
        ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (fault != 0) throw std::runtime_error("cannot start " + words[0]);
    return child;
}

// Takes what has been written so far; never waits.
void listen(int end, std::string& words) {
    constexpr std::size_t kept = 2000;
    std::array<char, 4096> buffer{};
    for (ssize_t n; (n = ::read(end, buffer.data(), buffer.size())) > 0;) {
        words.append(buffer.data(), static_cast<std::size_t>(n));
        if (words.size() > kept) words.erase(0, words.size() - kept);
    }
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& words, double cpu_limit,
                   const std::atomic<bool>& stop) {
    using Clock = std::chrono::steady_clock;
    Pipe errors;
    ::fcntl(errors.ends[0], F_SETFL, O_NONBLOCK);
    const pid_t child = start(words, errors.ends[1]);
    errors.close_writing();
    const auto seconds = static_cast<rlim_t>(std::ceil(cpu_limit));
    const rlimit limit{seconds, seconds};
    ::prlimit(child, RLIMIT_CPU, &limit, nullptr);
    const auto end_of_patience = Clock::now() + std::chrono::duration<double>(10.0 * cpu_limit);
    ChildEnd end;
    int status = 0;
    rusage use{};
    for (;;) {
        listen(errors.ends[0], end.last_words);
        if (::wait4(child, &status, WNOHANG, &use) == child) break;
        if (stop || Clock::now() > end_of_patience) {
            end.out_of_time = !stop;
            ::kill(-child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    listen(errors.ends[0], end.last_words);
    const auto time = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    end.cpu_seconds = time(use.ru_utime) + time(use.ru_stime);
    if (WIFEXITED(status))
        end.exit_code = WEXITSTATUS(status);
    else
        end.signal = WTERMSIG(status);
    const bool at_the_limit = end.cpu_seconds >= cpu_limit - 0.5;
    end.out_of_time = end.out_of_time || (!stop && !end.exit_code && at_the_limit);
    return end;
}

}  // namespace app
