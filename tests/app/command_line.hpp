// SPDX-License-Identifier: MIT
// The program as a user runs it, and folders that live as long as one test.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

struct Outcome {
    int code;  // exit code, or 1000 + the signal that ended it
    std::string out, err;

    nlohmann::ordered_json json() const { return nlohmann::ordered_json::parse(out); }
};

class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    // Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const;
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

struct Signal {
    int after;  // ms since the one before, or since the start
    int number;
};

// What `work` returns and prints, done by a child of this process.
Outcome in_child(const std::function<int()>& work, const std::vector<Signal>& signals = {});

// Runs the program with these arguments, each as it is, without a shell, and sends it the signals.
Outcome similitude(const std::vector<std::string>& arguments,
                   const std::vector<Signal>& signals = {});
// Likewise, with SIGINT so many milliseconds after its start.
Outcome similitude(const std::vector<std::string>& arguments, int interrupt_after);

std::string contents(const std::string& path);

// What a shell's command prints, errors too. Fails the test where it does not exit with 0.
std::string output_of(const std::string& command);

// A case of 300 adhesive grains on a base of ten diameters, with `old` replaced by `by` where it
// stands.
std::string tiny_case(const std::string& old = "", const std::string& by = "");
