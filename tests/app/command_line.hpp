// SPDX-License-Identifier: MIT
// The program as a user runs it, and folders that live as long as one test.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

struct Outcome {
    int code;  // exit code, or 128 + the signal that ended it
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

// Runs the program with these arguments, each as it is, without a shell. With `interrupt_after` > 0
// it gets SIGINT that many milliseconds after its start.
Outcome similitude(const std::vector<std::string>& arguments, int interrupt_after = 0);

std::string contents(const std::string& path);

// A case of 300 adhesive grains on a base of ten diameters, with `old` replaced by `by` where it
// stands.
std::string tiny_case(const std::string& old = "", const std::string& by = "");
