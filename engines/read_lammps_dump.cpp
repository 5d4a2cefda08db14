// SPDX-License-Identifier: MIT
// Text dumps of LAMMPS and LIGGGHTS (`dump custom`). Source: LAMMPS manual, "dump", "dump_modify" (keywords units, time), "units",
// "read_dump"; LIGGGHTS' dumps are the same without ITEM: UNITS and ITEM: TIME. Frames follow each other in one file.
#include "cases/messages.hpp"
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

#include <map>

namespace engines {
namespace {

Slot slot_named(std::string_view name) {
    // x wrapped, xu unwrapped; xs and xsu the same as shares of the box.
    static const std::map<std::string_view, Slot> known{
        {"id", Slot::id},         {"type", Slot::type},
        {"x", Slot::x},           {"y", Slot::y},
        {"z", Slot::z},           {"xu", Slot::x},
        {"yu", Slot::y},          {"zu", Slot::z},
        {"xs", Slot::scaled_x},   {"ys", Slot::scaled_y},
        {"zs", Slot::scaled_z},   {"xsu", Slot::scaled_x},
        {"ysu", Slot::scaled_y},  {"zsu", Slot::scaled_z},
        {"vx", Slot::vx},         {"vy", Slot::vy},
        {"vz", Slot::vz},         {"omegax", Slot::wx},
        {"omegay", Slot::wy},     {"omegaz", Slot::wz},
        {"radius", Slot::radius}, {"diameter", Slot::diameter},
        {"mass", Slot::mass},     {"density", Slot::density}};
    const auto found = known.find(name);
    return found == known.end() ? Slot::unused : found->second;
}

class LammpsDump : public GrainReader {
  public:
    LammpsDump(Lines lines, const GrainOptions& options)
        : lines_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::lammps_dump; }

    bool next(GrainFrame& f) override {
        do {
            if (!lines_.next()) return false;
        } while (lines_.text().empty());
        Heading h;
        read_heading(h);
        const Table table(columns(), options_, lines_.at());
        table.begin(f);
        f.frame.step = h.step, f.frame.low = h.low, f.frame.high = h.high;
        f.has_time = h.time.has_value(), f.frame.time = h.time.value_or(0.0) * units_->time;
        const Table::Where where = [this] { return lines_.at(); };
        std::vector<std::string_view> words;
        std::vector<double> values(table.columns().size());
        for (std::int64_t k = 0; k < h.grains; ++k) {
            split_words(lines_.need(fmt::format("frame {} (step {})", frames_, h.step)), words);
            if (words.size() != values.size())
                refuse(lines_.at(), fmt::format("{} values", words.size()),
                       fmt::format("must have one for each of the {} columns", values.size()),
                       "the file may be cut off, or two programs wrote into it");
            for (std::size_t i = 0; i < words.size(); ++i)
                if (table.columns()[i].slot != Slot::unused)
                    values[i] = lines_.number(words[i], table.columns()[i].name);
            table.add(f, values, where);
        }
        enclose(f.frame, true);
        ++frames_;
        return true;
    }

  private:
    struct Heading {
        std::int64_t step = 0, grains = -1;
        std::optional<double> time;
        contact::Vec3 low, high;
        bool box = false;
    };

    double single(const std::string& what) {
        std::vector<std::string_view> words;
        split_words(lines_.need(what), words);
        if (words.size() != 1)
            refuse(lines_.at(), cases::in_quotes(lines_.text()), "must be one number, the " + what,
                   "the file may be cut off");
        return lines_.number(words[0], what);
    }

    void read_box(Heading& h) {
        const std::string& text = lines_.text();
        if (text.find("xy") != std::string::npos || text.find("abc") != std::string::npos)
            refuse(lines_.at(), cases::in_quotes(text), "must be a box with right angles",
                   "a triclinic box is not read: heaps stand in none");
        double* const low[] = {&h.low.x, &h.low.y, &h.low.z};
        double* const high[] = {&h.high.x, &h.high.y, &h.high.z};
        std::vector<std::string_view> words;
        for (int k = 0; k < 3; ++k) {
            split_words(lines_.need("the box"), words);
            if (words.size() != 2)
                refuse(lines_.at(), cases::in_quotes(lines_.text()), "must be the box's two bounds",
                       "the file may be cut off");
            *low[k] = lines_.number(words[0], "bound"), *high[k] = lines_.number(words[1], "bound");
        }
        h.box = true;
    }

    // Leaves the line with the columns in lines_.
    void read_heading(Heading& h) {
        for (;; lines_.need("a frame's heading")) {
            const std::string text = lines_.text();
            if (text.starts_with("ITEM: ATOMS")) break;
            if (text.starts_with("ITEM: TIMESTEP"))
                h.step = static_cast<std::int64_t>(single("time step"));
            else if (text.starts_with("ITEM: TIME"))
                h.time = single("time");
            else if (text.starts_with("ITEM: NUMBER OF ATOMS"))
                h.grains = static_cast<std::int64_t>(single("number of grains"));
            else if (text.starts_with("ITEM: BOX BOUNDS"))
                read_box(h);
            else if (text.starts_with("ITEM: UNITS"))
                take_units();
            else
                refuse(lines_.at(), cases::in_quotes(text), "must be a heading of a dump of grains",
                       "`dump custom` writes them; `dump local` and binary dumps are not read");
        }
        if (h.grains < 0 || !h.box)
            refuse(lines_.at(), "columns without number of grains and box",
                   "must stand behind both", "the file may be cut off");
        if (!units_) units_ = options_.units;
        if (!units_)
            refuse(lines_.at(), "no ITEM: UNITS", "must say its units",
                   "state --units si, cgs or micro: what the deck's command `units` says");
        const FileUnits& u = *units_;
        h.low = u.length * h.low, h.high = u.length * h.high;
    }

    void take_units() {
        const std::string style = lines_.need("units");
        if (options_.units && options_.units->name == "stated" && style == "lj") return;
        units_ = units_named(style, lines_.at() + ": units");
        if (options_.units && options_.units->name != units_->name)
            refuse(lines_.at(), cases::in_quotes(style),
                   "must be the stated units, " + options_.units->name,
                   "leave --units out: the file says them");
    }

    std::vector<Column> columns() const {
        std::vector<std::string_view> words;
        split_words(std::string_view(lines_.text()).substr(11), words);
        std::vector<Column> all;
        const auto has = [&](Slot slot) {
            for (const Column& c : all)
                if (c.slot == slot) return true;
            return false;
        };
        for (const std::string_view w : words) {
            Slot slot = slot_named(w);
            if (has(slot)) slot = Slot::unused;  // x and xu: the first holds
            all.push_back({slot, factor_of(slot, *units_), std::string(w)});
        }
        for (Column& c : all)  // told twice over
            if ((c.slot == Slot::diameter && has(Slot::radius)) ||
                (c.slot == Slot::density && has(Slot::mass)))
                c.slot = Slot::unused;
        return all;
    }

    Lines lines_;
    GrainOptions options_;
    std::optional<FileUnits> units_;
    std::size_t frames_ = 0;
};

}  // namespace

std::unique_ptr<GrainReader> read_lammps_dump(Lines lines, const GrainOptions& options) {
    return std::make_unique<LammpsDump>(std::move(lines), options);
}

}  // namespace engines
