// SPDX-License-Identifier: MIT
// A folder that is gone when the test ends.
#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

struct Scratch {
    std::filesystem::path path;
    explicit Scratch(const std::string& name)
        : path(std::filesystem::temp_directory_path() /
               ("similitude-" + name + '-' + std::to_string(getpid()))) {
        std::filesystem::create_directories(path);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { std::filesystem::remove_all(path); }
};
