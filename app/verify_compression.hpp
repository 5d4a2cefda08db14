// SPDX-License-Identifier: MIT
#pragma once

#include "app/common.hpp"

#include <string>

namespace app {

struct CompressionOptions {
    CommonOptions common;
    std::string out = "out";
    bool small = false, among_larger = false;
    int seeds = 0;  // a side; 0: 3 with `small`, else 10
};

// The sub-command of `verify`; its options live as long as the command line.
CLI::App* add_compression(CLI::App& verify, CompressionOptions&);

// `verify compression`: a powder of larger grains compressed and crushed under several rules for its adhesion. Exit as `verify`.
int verify_compression(const CompressionOptions&, const std::string& command);

}  // namespace app
