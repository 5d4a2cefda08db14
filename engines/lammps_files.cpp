// SPDX-License-Identifier: MIT
#include "engines/lammps_files.hpp"

#include "engines/lammps_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace engines {
namespace {

// The lines of a dump, one after the other.
class Lines {
  public:
    Lines(const std::string& text, const std::string& name) : in_(text), name_(name) {}

    bool next(std::string& line) { return static_cast<bool>(std::getline(in_, line)); }
    std::string need(std::size_t frame) {
        std::string line;
        if (!next(line))
            throw std::runtime_error(
                fmt::format("{}: frame {} of the dump is cut off", name_, frame));
        return line;
    }
    void expect(const std::string& line, const std::string& start, std::size_t frame) {
        if (!line.starts_with(start))
            throw std::runtime_error(fmt::format(
                "{}: frame {} of the dump has '{}' in place of '{}'", name_, frame, line, start));
    }

  private:
    std::istringstream in_;
    const std::string& name_;
};

std::vector<std::string> words(const std::string& line) {
    std::istringstream in(line);
    std::vector<std::string> all;
    for (std::string word; in >> word;) all.push_back(word);
    return all;
}

LammpsFrame frame_from(Lines& lines, std::size_t index) {
    LammpsFrame frame{};
    frame.step = std::atoll(lines.need(index).c_str());
    lines.expect(lines.need(index), "ITEM: NUMBER OF ATOMS", index);
    const auto grains = static_cast<std::size_t>(std::atoll(lines.need(index).c_str()));
    lines.expect(lines.need(index), "ITEM: BOX BOUNDS", index);
    for (int k = 0; k < 3; ++k) lines.need(index);
    const std::string heading = lines.need(index);
    lines.expect(heading, "ITEM: ATOMS ", index);
    frame.columns = words(heading.substr(12));
    for (std::size_t k = 0; k < grains; ++k) {
        std::vector<double> row;
        for (const std::string& word : words(lines.need(index)))
            row.push_back(std::strtod(word.c_str(), nullptr));
        if (row.size() != frame.columns.size())
            throw std::runtime_error(
                fmt::format("a dump's row has {} numbers under {} names (frame {})", row.size(),
                            frame.columns.size(), index));
        frame.rows.push_back(std::move(row));
    }
    return frame;
}

}  // namespace

std::string opening_of_few(double skin, const std::string& rules, double time_step) {
    return fmt::format(R"(units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
read_data start.data
neighbor {:.17g} bin
neigh_modify delay 0 every 1 check yes
pair_style granular
pair_coeff * * {}
timestep {:.17g}
)",
                       skin, rules, time_step);
}

std::string lammps_data(const std::vector<dem_min::Grain>& grains, const Box& box, int types) {
    std::string text =
        fmt::format("written by similitude\n\n{} atoms\n{} atom types\n\n", grains.size(), types);
    text +=
        fmt::format("{:.17g} {:.17g} xlo xhi\n{:.17g} {:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n",
                    box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z);
    text += "\nAtoms # sphere\n\n";
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const dem_min::Grain& g = grains[k];
        text +=
            fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1, g.fixed ? 2 : 1,
                        2.0 * g.radius, g.density, g.position.x, g.position.y, g.position.z);
    }
    text += "\nVelocities\n\n";
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const dem_min::Grain& g = grains[k];
        text += fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1,
                            g.velocity.x, g.velocity.y, g.velocity.z, g.spin.x, g.spin.y, g.spin.z);
    }
    return text;
}

std::size_t LammpsFrame::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) throw std::runtime_error("the dump has no column " + name);
    return static_cast<std::size_t>(found - columns.begin());
}

std::vector<LammpsFrame> read_lammps_dump(const std::string& text, const std::string& name) {
    Lines lines(text, name);
    std::vector<LammpsFrame> frames;
    for (std::string line; lines.next(line);) {
        lines.expect(line, "ITEM: TIMESTEP", frames.size());
        frames.push_back(frame_from(lines, frames.size()));
    }
    return frames;
}

FinalGrains read_final_grains(const std::filesystem::path& folder, double density,
                              const std::string& extra) {
    const std::string file = (folder / "final.dump").string();
    const auto frames = read_lammps_dump(file_text(file), file);
    if (frames.size() != 1) throw std::runtime_error(file + ": not one frame");
    const LammpsFrame& f = frames.front();
    const std::size_t x = f.column("x"), v = f.column("vx"), w = f.column("omegax");
    const std::size_t radius = f.column("radius"), type = f.column("type");
    const auto glued = std::find(f.columns.begin(), f.columns.end(), "v_glued");
    const auto fixed = [&](const std::vector<double>& row) {
        return glued == f.columns.end()
                   ? row[type] == 2.0
                   : row[static_cast<std::size_t>(glued - f.columns.begin())] == 1.0;
    };
    FinalGrains all{f.step, {}, {}};
    for (const std::vector<double>& row : f.rows) {
        all.grains.push_back({{row[x], row[x + 1], row[x + 2]},
                              {row[v], row[v + 1], row[v + 2]},
                              {row[w], row[w + 1], row[w + 2]},
                              row[radius],
                              density,
                              fixed(row)});
        if (!extra.empty()) all.extra.push_back(row[f.column(extra)]);
    }
    return all;
}

}  // namespace engines
