// SPDX-License-Identifier: MIT
// Grains out of dumps. Source of the columns and units: LAMMPS manual, "dump", "units", "read_dump".
#include "cases/messages.hpp"
#include "engines/lammps_dump.hpp"

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
        : dump_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::lammps_dump; }

    bool next(GrainFrame& f) override {
        DumpHeading h;
        if (!dump_.next(h)) return false;
        take_units(h);
        const std::string at = dump_.lines().at();
        const Table table(columns(h), options_, at);
        table.begin(f);
        f.frame.step = h.step;
        f.frame.low = units_->length * h.low, f.frame.high = units_->length * h.high;
        f.has_time = h.time.has_value(), f.frame.time = h.time.value_or(0.0) * units_->time;
        const Table::Where where = [this] { return dump_.lines().at(); };
        std::vector<double> values(table.columns().size());
        for (std::int64_t k = 0; k < h.grains; ++k) {
            const std::vector<std::string_view>& words = dump_.row();
            for (std::size_t i = 0; i < words.size(); ++i)
                if (table.columns()[i].slot != Slot::unused)
                    values[i] = dump_.lines().number(words[i], table.columns()[i].name);
            table.add(f, values, where);
        }
        enclose(f.frame, true);
        return true;
    }

  private:
    void take_units(const DumpHeading& h) {
        if (h.units && !(options_.units && options_.units->name == "stated" && *h.units == "lj")) {
            units_ = units_named(*h.units, dump_.lines().at() + ": units");
            if (options_.units && options_.units->name != units_->name)
                refuse(dump_.lines().at(), cases::in_quotes(*h.units),
                       "must be the stated units, " + options_.units->name,
                       "leave --units out: the file says them");
        }
        if (!units_) units_ = options_.units;
        if (!units_)
            refuse(dump_.lines().at(), "no ITEM: UNITS", "must say its units",
                   "state --units si, cgs or micro: what the deck's command `units` says");
    }

    std::vector<Column> columns(const DumpHeading& h) const {
        std::vector<Column> all;
        const auto has = [&](Slot slot) {
            for (const Column& c : all)
                if (c.slot == slot) return true;
            return false;
        };
        for (const std::string& w : h.columns) {
            Slot slot = slot_named(w);
            if (has(slot)) slot = Slot::unused;  // x and xu: the first holds
            all.push_back({slot, factor_of(slot, *units_), w});
        }
        for (Column& c : all)  // told twice over
            if ((c.slot == Slot::diameter && has(Slot::radius)) ||
                (c.slot == Slot::density && has(Slot::mass)))
                c.slot = Slot::unused;
        return all;
    }

    DumpLines dump_;
    GrainOptions options_;
    std::optional<FileUnits> units_;
};

}  // namespace

std::unique_ptr<GrainReader> read_lammps_dump(Lines lines, const GrainOptions& options) {
    return std::make_unique<LammpsDump>(std::move(lines), options);
}

}  // namespace engines
