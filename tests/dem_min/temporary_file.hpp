// SPDX-License-Identifier: MIT
// A file of this process for a checkpoint, gone at the end of its scope.
#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

namespace samples {

struct TemporaryFile {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("similitude_checkpoint_" + std::to_string(::getpid()) + ".bin");
    TemporaryFile() = default;
    TemporaryFile(const TemporaryFile&) = delete;
    ~TemporaryFile() { std::filesystem::remove(path); }
};

}  // namespace samples
