// SPDX-License-Identifier: MIT
#include "verify/remembered_file.hpp"

#include <fstream>
#include <stdexcept>

namespace verify {

std::uint64_t fnv1a(const std::string& text) {
    std::uint64_t state = 14695981039346656037ULL;
    for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    return state;
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::filesystem::path unfinished = file;
    unfinished += ".tmp";
    {
        std::ofstream out(unfinished);
        out << text;
        if (!out.flush())
            throw std::runtime_error(unfinished.string() + ": cannot be written (disk full?)");
    }
    std::filesystem::rename(unfinished, file);
}

}  // namespace verify
