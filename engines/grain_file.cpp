// SPDX-License-Identifier: MIT
#include "engines/grain_file.hpp"

#include "cases/messages.hpp"
#include "engines/grain_lines.hpp"
#include "scaling/nearest_name.hpp"

#include <algorithm>

namespace engines {

const std::vector<std::string>& grain_format_names() {
    static const std::vector<std::string> names{"lammps_dump", "lammps_data",  "edem_csv",
                                                "csv",         "mercury_data", "yade_text"};
    return names;
}

FileUnits units_named(const std::string& style, const std::string& where) {
    static const std::vector<FileUnits> known{{"si", 1.0, 1.0, 1.0},
                                              {"cgs", 1e-2, 1.0, 1e-3},
                                              {"micro", 1e-6, 1e-6, 1e-15},  // um, us, pg
                                              {"nano", 1e-9, 1e-9, 1e-21}};  // nm, ns, ag
    for (const FileUnits& u : known)
        if (u.name == style) return u;
    const bool lj = style == "lj";
    refuse(where, cases::in_quotes(style), "must be si, cgs, micro or nano",
           lj ? "lj has no size of its own: state --length-unit, --time-unit and --mass-unit"
              : "or state --length-unit, --time-unit and --mass-unit");
}

namespace {

// By the first line that is not blank; nothing where it could be several.
std::optional<GrainFormat> format_told_by(const std::string& line) {
    std::vector<std::string_view> words;
    split_words(line, words);
    if (line.starts_with("ITEM:")) return GrainFormat::lammps_dump;
    if (line.starts_with("TIME:") || line.starts_with("Q01")) return GrainFormat::edem_csv;
    if (line.starts_with("LAMMPS")) return GrainFormat::lammps_data;
    if (line.starts_with("#format x_y_z_r")) return GrainFormat::yade_text;
    if (line.find(',') != std::string::npos && line.find_first_of("[(") != std::string::npos)
        return GrainFormat::csv;
    if (!std::all_of(words.begin(), words.end(), is_number)) return {};
    if (words.size() == 8 || words.size() == 6) return GrainFormat::mercury_data;
    if (words.size() == 4) return GrainFormat::yade_text;
    return {};
}

}  // namespace

std::unique_ptr<GrainReader> open_grains(const std::string& path, const GrainOptions& options) {
    Lines lines(path);
    std::optional<GrainFormat> format = options.format;
    if (!format) {
        bool any = false;
        while (!any && lines.next())
            any = lines.text().find_first_not_of(" \t") != std::string::npos;
        if (!any) refuse(path, "an empty file", "must hold grains", "write it again");
        format = format_told_by(lines.text());
        if (!format)
            refuse(lines.at(), cases::in_quotes(lines.text()), "must tell the file's format",
                   "state --format as one of " + scaling::joined(grain_format_names()));
        lines.put_back();
    }
    switch (*format) {
        case GrainFormat::lammps_dump:
            return read_lammps_dump(std::move(lines), options);
        case GrainFormat::lammps_data:
            return read_lammps_data(std::move(lines), options);
        case GrainFormat::edem_csv:
            return read_edem_csv(std::move(lines), options);
        case GrainFormat::csv:
            return read_csv(std::move(lines), options);
        case GrainFormat::mercury_data:
            return read_mercury_data(std::move(lines), options);
        case GrainFormat::yade_text:
            break;
    }
    return read_yade_text(std::move(lines), options);
}

}  // namespace engines
