// SPDX-License-Identifier: MIT
#include "engines/lammps_dump.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace engines {

double DumpLines::single(const std::string& what) {
    split_words(lines_.need(what), words_);
    if (words_.size() != 1)
        refuse(lines_.at(), cases::in_quotes(lines_.text()), "must be one number, the " + what,
               "the file may be cut off");
    return lines_.number(words_[0], what);
}

void DumpLines::read_box(DumpHeading& h) {
    const std::string& text = lines_.text();
    if (text.find("xy") != std::string::npos || text.find("abc") != std::string::npos)
        refuse(lines_.at(), cases::in_quotes(text), "must be a box with right angles",
               "a triclinic box is not read: heaps stand in none");
    double* const low[] = {&h.low.x, &h.low.y, &h.low.z};
    double* const high[] = {&h.high.x, &h.high.y, &h.high.z};
    for (int k = 0; k < 3; ++k) {
        split_words(lines_.need("the box"), words_);
        if (words_.size() != 2)
            refuse(lines_.at(), cases::in_quotes(lines_.text()), "must be the box's two bounds",
                   "the file may be cut off");
        *low[k] = lines_.number(words_[0], "bound"), *high[k] = lines_.number(words_[1], "bound");
    }
}

bool DumpLines::next(DumpHeading& heading) {
    do {
        if (!lines_.next()) return false;
    } while (lines_.text().empty());
    DumpHeading h;
    bool box = false;
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
            read_box(h), box = true;
        else if (text.starts_with("ITEM: UNITS"))
            h.units = lines_.need("units");
        else
            refuse(lines_.at(), cases::in_quotes(text), "must be a heading of a dump of grains",
                   "`dump custom` writes them; `dump local` and binary dumps are not read");
    }
    if (h.grains < 0 || !box)
        refuse(lines_.at(), "columns without number of grains and box", "must stand behind both",
               "the file may be cut off");
    split_words(std::string_view(lines_.text()).substr(11), words_);
    h.columns.assign(words_.begin(), words_.end());
    ++frames_;
    heading = heading_ = std::move(h);
    return true;
}

const std::vector<std::string_view>& DumpLines::row() {
    split_words(lines_.need(fmt::format("frame {} (step {})", frames_ - 1, heading_.step)), words_);
    if (words_.size() != heading_.columns.size())
        refuse(lines_.at(), fmt::format("{} values", words_.size()),
               fmt::format("must have one for each of the {} columns", heading_.columns.size()),
               "the file may be cut off, or two programs wrote into it");
    return words_;
}

std::size_t LammpsFrame::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) throw std::runtime_error("the dump has no column " + name);
    return static_cast<std::size_t>(found - columns.begin());
}

std::vector<LammpsFrame> read_lammps_frames(const std::filesystem::path& file) try {
    DumpLines dump{Lines(file.string())};
    std::vector<LammpsFrame> frames;
    for (DumpHeading h; dump.next(h);) {
        LammpsFrame frame{h.step, h.columns, {}};
        for (std::int64_t k = 0; k < h.grains; ++k) {
            std::vector<double> values;
            // A force that is not a number is a result, too.
            for (const std::string_view word : dump.row())
                values.push_back(std::strtod(std::string(word).c_str(), nullptr));
            frame.rows.push_back(std::move(values));
        }
        frames.push_back(std::move(frame));
    }
    return frames;
} catch (const scaling::InvalidInput& e) {
    throw std::runtime_error(e.what());  // the engine's file, not the user's
}

}  // namespace engines
