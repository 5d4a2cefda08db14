// SPDX-License-Identifier: MIT
// Cases that a test writes for itself, and what a verdict names.
#pragma once

#include "cases/read_case.hpp"
#include "diagnose/verdict.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <unistd.h>
#include <vector>

// Read back by way of a folder that no other process uses; `files`: name to contents, case.json among them.
inline cases::Case case_of(const std::map<std::string, std::string>& files) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                         ("similitude-diagnose-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    for (const auto& [name, contents] : files) std::ofstream(folder / name) << contents;
    cases::Case read = cases::read_case(folder / "case.json");
    std::filesystem::remove_all(folder);
    return read;
}

inline std::vector<std::string> named(const diagnose::Verdict& v) {
    std::vector<std::string> list;
    for (const diagnose::Effect& e : v.effects)
        if (e.named) list.push_back(e.name);
    return list;
}
