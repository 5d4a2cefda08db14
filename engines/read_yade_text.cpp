// SPDX-License-Identifier: MIT
// Four columns of text, x y z r, as Yade's ymport.text takes and its export.text writes them; lines that begin with # are comments.
// SI, as all of Yade's examples are, unless units are stated.
#include "engines/grain_lines.hpp"

#include <fmt/format.h>

namespace engines {
namespace {

class YadeText : public GrainReader {
  public:
    YadeText(Lines lines, const GrainOptions& options)
        : lines_(std::move(lines)), options_(options) {}

    GrainFormat format() const override { return GrainFormat::yade_text; }

    bool next(GrainFrame& f) override {
        if (read_) return false;
        read_ = true;
        const FileUnits units = options_.units.value_or(FileUnits{"si", 1.0, 1.0, 1.0});
        const Table table({{Slot::x, units.length, "x"},
                           {Slot::y, units.length, "y"},
                           {Slot::z, units.length, "z"},
                           {Slot::radius, units.length, "r"}},
                          options_, lines_.path());
        table.begin(f);
        const Table::Where where = [this] { return lines_.at(); };
        std::vector<std::string_view> words;
        std::vector<double> values(4);
        while (lines_.next()) {
            if (lines_.text().starts_with('#')) continue;
            split_words(lines_.text(), words);
            if (words.empty()) continue;
            if (words.size() != 4)
                refuse(lines_.at(), fmt::format("{} values", words.size()), "must be x, y, z and r",
                       "other columns of ymport.textExt are not read");
            for (std::size_t i = 0; i < 4; ++i)
                values[i] = lines_.number(words[i], table.columns()[i].name);
            table.add(f, values, where);
        }
        enclose(f.frame, false);
        return true;
    }

  private:
    Lines lines_;
    GrainOptions options_;
    bool read_ = false;
};

}  // namespace

std::unique_ptr<GrainReader> read_yade_text(Lines lines, const GrainOptions& options) {
    return std::make_unique<YadeText>(std::move(lines), options);
}

}  // namespace engines
