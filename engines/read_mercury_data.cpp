// SPDX-License-Identifier: MIT
// MercuryDPM's .data in three dimensions. Source: MercuryDPM, Kernel/DPMBase.cc, DPMBase::readNextDataFile, format 14: a line
// "N time xmin ymin zmin xmax ymax zmax", then N lines "x y z vx vy vz r a b c wx wy wz species", a b c an orientation.
#include "cases/messages.hpp"
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

namespace engines {
namespace {

class MercuryData : public GrainReader {
  public:
    MercuryData(Lines lines, const GrainOptions& options)
        : lines_(std::move(lines)), options_(options) {
        if (!options_.units)
            refuse(lines_.path(), "numbers without units", "must have their units stated",
                   "MercuryDPM's are the user's own: state --units si, or --length-unit, "
                   "--time-unit and --mass-unit");
        const auto column = [&](Slot slot, const char* name) {
            return Column{slot, factor_of(slot, *options_.units), name};
        };
        columns_ = {column(Slot::x, "x"),
                    column(Slot::y, "y"),
                    column(Slot::z, "z"),
                    column(Slot::vx, "vx"),
                    column(Slot::vy, "vy"),
                    column(Slot::vz, "vz"),
                    column(Slot::radius, "radius"),
                    column(Slot::unused, "orientation 1"),
                    column(Slot::unused, "orientation 2"),
                    column(Slot::unused, "orientation 3"),
                    column(Slot::wx, "omegax"),
                    column(Slot::wy, "omegay"),
                    column(Slot::wz, "omegaz"),
                    column(Slot::type, "species")};
    }

    GrainFormat format() const override { return GrainFormat::mercury_data; }

    bool next(GrainFrame& f) override {
        do {
            if (!lines_.next()) return false;
        } while (lines_.text().empty());
        std::vector<std::string_view> words;
        split_words(lines_.text(), words);
        if (words.size() != 8)
            refuse(lines_.at(), fmt::format("{} values", words.size()),
                   "must be N, time and six bounds of the box",
                   words.size() == 6 ? "a .data of two dimensions holds no heap"
                                     : "the file may be cut off, or no .data of MercuryDPM");
        double head[8];
        for (std::size_t k = 0; k < 8; ++k) head[k] = lines_.number(words[k], "heading");
        const Table table(columns_, options_, lines_.at());
        table.begin(f);
        const double m = options_.units->length;
        f.has_time = true, f.frame.time = head[1] * options_.units->time;
        f.frame.step = frames_;
        f.frame.low = {m * head[2], m * head[3], m * head[4]};
        f.frame.high = {m * head[5], m * head[6], m * head[7]};
        const Table::Where where = [this] { return lines_.at(); };
        std::vector<double> values(columns_.size());
        for (double k = 0.0; k < head[0]; ++k) {
            split_words(lines_.need(fmt::format("frame {}", frames_)), words);
            if (words.size() != columns_.size())
                refuse(lines_.at(), fmt::format("{} values", words.size()),
                       "must be the 14 of a grain in three dimensions",
                       "formats 7, 8 and 15 of MercuryDPM are not read");
            for (std::size_t i = 0; i < words.size(); ++i)
                values[i] = lines_.number(words[i], columns_[i].name);
            values.back() += 1.0;  // species count from 0, types from 1
            table.add(f, values, where);
        }
        enclose(f.frame, true);
        ++frames_;
        return true;
    }

  private:
    Lines lines_;
    GrainOptions options_;
    std::vector<Column> columns_;
    std::int64_t frames_ = 0;
};

}  // namespace

std::unique_ptr<GrainReader> read_mercury_data(Lines lines, const GrainOptions& options) {
    return std::make_unique<MercuryData>(std::move(lines), options);
}

}  // namespace engines
