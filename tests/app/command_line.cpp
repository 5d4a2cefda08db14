// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "similitude-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file.is_open());
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string output_of(const std::string& command) {
    const Folder folder;
    const int code = std::system((command + " > " + folder / "out" + " 2>&1").c_str());
    const std::string said = contents(folder / "out");
    INFO(command << "\n" << said);
    REQUIRE(code == 0);
    return said;
}

namespace {

void redirect(const std::string& path, int descriptor) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(file, descriptor);
}

}  // namespace

Outcome in_child(const std::function<int()>& work, const std::vector<Signal>& signals) {
    const Folder folder;
    const std::string out = folder / "out", err = folder / "err";
    std::fflush(nullptr);  // what waits to be written is not the child's to write
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        redirect(out, STDOUT_FILENO);
        redirect(err, STDERR_FILENO);
        const int code = work();
        std::fflush(nullptr);
        _exit(code);
    }
    for (const Signal& signal : signals) {
        std::this_thread::sleep_for(std::chrono::milliseconds(signal.after));
        kill(child, signal.number);  // a child that has ended is still there until it is waited for
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), contents(out),
            contents(err)};
}

Outcome similitude(const std::vector<std::string>& arguments, const std::vector<Signal>& signals) {
    std::vector<std::string> words = {SIMILITUDE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const auto become = [&argv] {
        execv(argv[0], argv.data());
        return 127;
    };
    return in_child(become, signals);
}

Outcome similitude(const std::vector<std::string>& arguments, int interrupt_after) {
    return similitude(arguments, std::vector<Signal>{{interrupt_after, SIGINT}});
}

std::string tiny_case(const std::string& old, const std::string& by) {
    std::string text = R"({
  "format": "similitude-case/1",
  "title": "a tiny heap",
  "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "1 MPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin", "adhesion", "rolling_resistance"],
    "parameters": {"restitution": {"value": 0.3}, "sliding_friction": {"value": 0.6},
                   "rolling_friction": {"value": 0.2}, "work_of_adhesion": {"value": "20 mJ/m^2"}}},
  "experiments": [{"id": "pile", "rig": "pile",
    "conditions": {"base": "glued_grains", "base_diameter": "10 mm", "grains": 300}}]
})";
    if (old.empty()) return text;
    const std::size_t at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), by);
}
