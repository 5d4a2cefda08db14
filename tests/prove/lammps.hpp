// SPDX-License-Identifier: MIT
// LAMMPS in a folder of its own, for the tests of blind heaps.
#pragma once

#include "prove/heap_pour.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

struct Folder {
    std::filesystem::path path;
    explicit Folder(const std::string& name) : path(std::filesystem::temp_directory_path() / name) {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

inline std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// Writes the files, runs deck.in and returns the log.
inline std::string run_lammps(const Folder& folder,
                              const std::map<std::string, std::string>& files) {
    for (const auto& [name, text] : files) std::ofstream(folder.path / name) << text;
    const std::string where = folder.path.string();
    REQUIRE(std::system(("lmp -in " + where + "/deck.in -var folder " + where + " -log " + where +
                         "/log -screen none")
                            .c_str()) == 0);
    return content(folder.path / "log");
}

inline std::vector<prove::Ball> heap_in(const Folder& folder) {
    return prove::read_heap(content(folder.path / "heap.dump"));
}
