// SPDX-License-Identifier: MIT
// Data files of LAMMPS and LIGGGHTS for spheres. Source: LAMMPS manual, "read_data" (atom_style sphere: id, type, DIAMETER, density,
// x, y, z and three image flags or none; Velocities: id, v, omega).
#include "cases/messages.hpp"
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

#include <cctype>
#include <unordered_map>

namespace engines {
namespace {

class LammpsData : public GrainReader {
  public:
    LammpsData(Lines lines, const GrainOptions& options)
        : lines_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::lammps_data; }

    bool next(GrainFrame& f) override {
        if (read_) return false;
        read_ = true;
        read_header();
        bool atoms = false;
        f = {};
        for (bool more = true; more; more = find_section()) {
            const std::string section = lines_.text();
            if (section.starts_with("Atoms")) {
                read_atoms(f, section);
                atoms = true;
            } else if (section.starts_with("Velocities") && atoms) {
                read_velocities(f);
            } else if (section.starts_with("Velocities")) {
                refuse(lines_.at(), "Velocities", "must stand behind Atoms", "swap the two");
            } else {
                skipped_.push_back("section " + section);
            }
        }
        if (!atoms)
            refuse(lines_.at(), "the end of the file", "must hold a section Atoms",
                   "write it with write_data");
        f.unused.insert(f.unused.end(), skipped_.begin(), skipped_.end());
        enclose(f.frame, true);
        return true;
    }

  private:
    // Without the comment; the words are views into the line.
    const std::vector<std::string_view>& words() {
        const std::string_view text = lines_.text();
        split_words(text.substr(0, text.find('#')), words_);
        return words_;
    }

    // The first line is a comment; write_data says the units there, as "units = si".
    void read_header() {
        const std::string title = lines_.need("the header");
        spheres_ = title.find("LIGGGHTS") != std::string::npos;  // its granular style is no other
        const std::size_t at = title.find("units = ");
        if (at != std::string::npos) {
            const std::string style =
                title.substr(at + 8, title.find_first_of(", ", at + 8) - at - 8);
            if (!(style == "lj" && options_.units && options_.units->name == "stated"))
                units_ = units_named(style, lines_.at() + ": units");
            if (units_ && options_.units && options_.units->name != units_->name)
                refuse(lines_.at(), cases::in_quotes(style),
                       "must be the stated units, " + options_.units->name,
                       "leave --units out: the file says them");
        }
        if (!units_) units_ = options_.units;
        if (!units_)
            refuse(lines_.at(), "no units", "must say its units",
                   "state --units si, cgs or micro: what the deck's command `units` says");
        bool box[3] = {false, false, false};
        while (lines_.need("the header"), !is_section()) {
            const auto& w = words();
            if (w.empty()) continue;
            const std::string_view last = w.back();
            if (last == "atoms") grains_ = static_cast<std::int64_t>(lines_.number(w[0], "atoms"));
            if (last == "yz" || last == "avec" || last == "origin")
                refuse(lines_.at(), cases::in_quotes(lines_.text()),
                       "must be a box with right angles",
                       "a triclinic box is not read: heaps stand in none");
            double* const low[] = {&low_.x, &low_.y, &low_.z};
            double* const high[] = {&high_.x, &high_.y, &high_.z};
            for (int k = 0; k < 3; ++k) {
                if (w.size() != 4 || last != std::string(1, "xyz"[k]) + "hi") continue;
                *low[k] = units_->length * lines_.number(w[0], "bound");
                *high[k] = units_->length * lines_.number(w[1], "bound");
                box[k] = true;
            }
        }
        if (grains_ < 0 || !box[0] || !box[1] || !box[2])
            refuse(lines_.at(), "a section", "must stand behind the number of atoms and the box",
                   "see read_data in LAMMPS' manual");
    }

    bool is_section() const {
        const std::string& text = lines_.text();
        return !text.empty() && std::isupper(static_cast<unsigned char>(text[0]));
    }

    bool find_section() {
        while (lines_.next())
            if (is_section()) return true;
        return false;
    }

    void need_row(const std::string& what) {
        do lines_.need(what);
        while (words().empty());
    }

    void read_atoms(GrainFrame& f, const std::string& section) {
        if (section.find("# sphere") == std::string::npos && !spheres_)
            refuse(lines_.at(), cases::in_quotes(section), "must be \"Atoms # sphere\"",
                   "other atom styles have no sizes; if it is sphere, write that comment");
        const auto column = [&](Slot slot, const char* name) {
            return Column{slot, factor_of(slot, *units_), name};
        };
        const Table table({column(Slot::id, "id"), column(Slot::type, "type"),
                           column(Slot::diameter, "diameter"), column(Slot::density, "density"),
                           column(Slot::x, "x"), column(Slot::y, "y"), column(Slot::z, "z")},
                          options_, lines_.at());
        table.begin(f);
        f.frame.low = low_, f.frame.high = high_;
        const Table::Where where = [this] { return lines_.at(); };
        std::vector<double> values(7);
        for (std::int64_t k = 0; k < grains_; ++k) {
            need_row("Atoms");
            const bool flags = words_.size() == 10;
            if (words_.size() != 7 && !flags)
                refuse(lines_.at(), fmt::format("{} values", words_.size()),
                       "must be id, type, diameter, density, x, y, z and three image flags or none",
                       fmt::format("the file announces {} atoms", grains_));
            if (flags && !flags_) f.unused.push_back("image flags");
            flags_ = flags_ || flags;
            for (std::size_t i = 0; i < 7; ++i)
                values[i] = lines_.number(words_[i], table.columns()[i].name);
            table.add(f, values, where);
            if (!place_.emplace(f.frame.id.back(), f.frame.count() - 1).second)
                refuse(lines_.at(), fmt::format("id {}", f.frame.id.back()),
                       "must stand once in Atoms", "give each grain its own");
        }
    }

    void read_velocities(GrainFrame& f) {
        const double v = units_->length / units_->time, w = 1.0 / units_->time;
        for (std::int64_t k = 0; k < grains_; ++k) {
            need_row("Velocities");
            if (words_.size() != 7)
                refuse(lines_.at(), fmt::format("{} values", words_.size()),
                       "must be id, vx, vy, vz, omegax, omegay, omegaz",
                       "as atom_style sphere has it");
            double n[7];
            for (std::size_t i = 0; i < 7; ++i) n[i] = lines_.number(words_[i], "velocity");
            const auto found = place_.find(static_cast<std::int64_t>(n[0]));
            if (found == place_.end())
                refuse(lines_.at(), fmt::format("id {}", n[0]), "must be one of those in Atoms",
                       "correct the id");
            f.frame.velocity[found->second] = {v * n[1], v * n[2], v * n[3]};
            f.frame.spin[found->second] = {w * n[4], w * n[5], w * n[6]};
        }
        f.has_velocity = f.has_spin = true;
    }

    Lines lines_;
    GrainOptions options_;
    std::optional<FileUnits> units_;
    std::vector<std::string_view> words_;
    std::vector<std::string> skipped_;
    std::unordered_map<std::int64_t, std::size_t> place_;  // by id
    std::int64_t grains_ = -1;
    contact::Vec3 low_, high_;
    bool read_ = false, flags_ = false, spheres_ = false;
};

}  // namespace

std::unique_ptr<GrainReader> read_lammps_data(Lines lines, const GrainOptions& options) {
    return std::make_unique<LammpsData>(std::move(lines), options);
}

}  // namespace engines
