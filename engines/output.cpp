// SPDX-License-Identifier: MIT
#include "engines/output.hpp"

#include <cstdio>
#include <stdexcept>

namespace engines {

namespace {
constexpr std::size_t shown =
    400;  // characters: an error message stands at the end, in a few lines
}

bool read_bed_line(const std::string& line, BedFigures& f) {
    long grains = 0;
    double neighbours = 0.0, kinetic = 0.0, seconds = 0.0;
    const int read =
        std::sscanf(line.c_str(), "bed: grains %ld neighbours %lf kinetic %lf seconds %lf", &grains,
                    &neighbours, &kinetic, &seconds);
    if (read < 3) return false;
    f.grains = grains;
    f.neighbours = neighbours;
    f.kinetic_energy = kinetic;
    if (read == 4) f.seconds = seconds;
    return true;
}

void throw_unreadable(const std::string& output) {
    const std::size_t from = output.size() > shown ? output.size() - shown : 0;
    throw std::runtime_error("its output ends with: " + output.substr(from));
}

}  // namespace engines
