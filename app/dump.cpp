// SPDX-License-Identifier: MIT
#include "app/dump.hpp"

#include "cases/messages.hpp"
#include "cases/units.hpp"
#include "reports/frame.hpp"
#include "reports/numbers.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace app {

namespace {

namespace fs = std::filesystem;
using scaling::InvalidInput;
using scaling::mistake;

// In the order of the enumeration.
const std::vector<std::string> format_names = {"lammps", "vtp", "extxyz"};

std::string name_of(DumpFormat format) { return format_names[static_cast<std::size_t>(format)]; }

DumpFormat format_named(const std::string& name) {
    const auto at = std::find(format_names.begin(), format_names.end(), name);
    if (at == format_names.end())
        throw InvalidInput(mistake("--dump", cases::in_quotes(name),
                                   "must be of " + scaling::joined(format_names),
                                   cases::suggestion(name, format_names)));
    return static_cast<DumpFormat>(at - format_names.begin());
}

fs::path file_of(const Dump& dump, DumpFormat format) {
    switch (format) {
        case DumpFormat::lammps:
            return dump.folder / (dump.id + ".lammpstrj");
        case DumpFormat::extxyz:
            return dump.folder / (dump.id + ".extxyz");
        case DumpFormat::vtp:
            return dump.folder / (dump.id + ".pvd");
    }
    throw std::logic_error("a dump format without a file");
}

bool grows(DumpFormat format) { return format != DumpFormat::vtp; }

std::string vtp_folder(const Dump& dump) { return dump.id + "-vtp"; }
std::string vtp_name(std::size_t frame) { return fmt::format("frame-{:06}.vtp", frame); }

std::int64_t step_of_frame(const Dump& dump, std::size_t k) {
    return std::llround(static_cast<double>(k) * dump.plan.every / dump.time_step);
}

// Grains in the order of their birth, whatever order the core keeps them in.
reports::Frame frame_of(const dem_min::Simulation& s, const Box& box) {
    const dem_min::Particles& g = s.grains;
    std::vector<std::size_t> order(g.count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return g.id[a] < g.id[b]; });
    reports::Frame f;
    f.step = s.steps;
    f.time = s.time();
    f.low = box.low;
    f.high = box.high;
    for (const std::size_t k : order) {
        const contact::Vec3 x = g.position(k);
        const double r = g.radius[k];
        f.low = {std::min(f.low.x, x.x - r), std::min(f.low.y, x.y - r),
                 std::min(f.low.z, x.z - r)};
        f.high = {std::max(f.high.x, x.x + r), std::max(f.high.y, x.y + r),
                  std::max(f.high.z, x.z + r)};
        f.id.push_back(g.id[k] + 1);
        f.position.push_back(x);
        f.velocity.push_back(g.velocity(k));
        f.spin.push_back(g.spin(k));
        f.radius.push_back(r);
        f.mass.push_back(dem_min::mass_of(s, k));
        f.fixed.push_back(g.fixed(k) ? 1 : 0);
    }
    return f;
}

[[noreturn]] void cannot_write(const fs::path& file) {
    throw std::runtime_error(file.string() + ": cannot be written (disk full?)");
}

using Write = std::function<void(std::ostream&)>;

void replace_whole(const fs::path& file, const Write& write) {
    fs::path unfinished = file;
    unfinished += ".tmp";
    {
        std::ofstream out(unfinished, std::ios::binary);
        write(out);
        if (!out.flush()) cannot_write(unfinished);
    }
    fs::rename(unfinished, file);
}

// Appends all of it, or nothing where the disk is full. Returns the file's new length.
std::uintmax_t append_whole(const fs::path& file, std::uintmax_t end, const Write& write) {
    std::ofstream out(file, std::ios::binary | std::ios::app);
    write(out);
    if (out.flush()) return static_cast<std::uintmax_t>(out.tellp());
    out.close();
    std::error_code ignored;
    fs::resize_file(file, end, ignored);
    cannot_write(file);
}

void write_vtp_frame(const Dump& dump, const reports::Frame& frame) {
    const fs::path folder = dump.folder / vtp_folder(dump);
    fs::create_directories(folder);
    replace_whole(folder / vtp_name(dump.steps.size() - 1),
                  [&](std::ostream& out) { reports::write_vtp(out, frame); });
    std::vector<reports::TimedFile> list;
    for (std::size_t k = 0; k < dump.steps.size(); ++k)
        list.push_back({static_cast<double>(dump.steps[k]) * dump.time_step,
                        vtp_folder(dump) + "/" + vtp_name(k)});
    replace_whole(file_of(dump, DumpFormat::vtp),
                  [&](std::ostream& out) { reports::write_pvd(out, list); });
}

// VTP files of frames from `first` on, whoever wrote them: frames are counted without a gap.
void remove_vtp_frames(const Dump& dump, std::size_t first) {
    while (fs::remove(dump.folder / vtp_folder(dump) / vtp_name(first))) ++first;
}

[[noreturn]] void refuse_resume(const std::string& what, const std::string& got,
                                const std::string& rule) {
    throw InvalidInput(
        mistake(what, got, rule, "repeat the first command with --resume, or start anew without"));
}

void cut_back(Dump& dump, DumpFormat format, std::uintmax_t end) {
    const fs::path file = file_of(dump, format);
    std::error_code missing;
    const std::uintmax_t length = fs::file_size(file, missing);
    if (missing || length < end)
        refuse_resume(file.string(), missing ? "no file" : fmt::format("{} bytes", length),
                      fmt::format("must hold the {} bytes that the interrupted run left", end));
    fs::resize_file(file, end);
    dump.end_bytes[format] = end;
}

void keep_vtp_frames(const Dump& dump) {
    for (std::size_t k = 0; k < dump.steps.size(); ++k) {
        const fs::path file = dump.folder / vtp_folder(dump) / vtp_name(k);
        if (!fs::exists(file))
            refuse_resume(file.string(), "no file", "must be there as the interrupted run left it");
    }
    remove_vtp_frames(dump, dump.steps.size());
}

}  // namespace

DumpPlan dump_plan(const std::string& formats, const std::string& every) {
    DumpPlan plan;
    if (formats.empty() && every.empty()) return plan;
    if (formats.empty())
        throw InvalidInput(mistake("--dump", "none", "must stand beside --dump-every",
                                   "choose of " + scaling::joined(format_names)));
    if (every.empty())
        throw InvalidInput(mistake("--dump-every", "none", "must stand beside --dump",
                                   "write a simulated time, such as \"1 ms\""));
    for (std::size_t start = 0; start <= formats.size();) {
        const std::size_t end = std::min(formats.find(',', start), formats.size());
        plan.formats.push_back(format_named(formats.substr(start, end - start)));
        start = end + 1;
    }
    std::sort(plan.formats.begin(), plan.formats.end());
    plan.formats.erase(std::unique(plan.formats.begin(), plan.formats.end()), plan.formats.end());
    plan.every = cases::quantity<scaling::Time>(every, "--dump-every").value();
    if (!(plan.every > 0.0))
        throw InvalidInput(mistake("--dump-every", cases::in_quotes(every), "must be > 0",
                                   "write a simulated time, such as \"1 ms\""));
    return plan;
}

void begin(Dump& dump) {
    for (const DumpFormat format : dump.plan.formats) {
        fs::remove(file_of(dump, format));
        if (!grows(format))
            remove_vtp_frames(dump, 0);
        else
            dump.end_bytes[format] = 0;
    }
    dump.steps.clear();
}

nlohmann::json described(const Dump& dump) {
    std::vector<std::string> names;
    for (const DumpFormat format : dump.plan.formats) names.push_back(name_of(format));
    nlohmann::json bytes = nlohmann::json::object();
    for (const auto& [format, end] : dump.end_bytes) bytes[name_of(format)] = end;
    return {{"formats", names.empty() ? "none" : scaling::joined(names)},
            {"every", dump.plan.every},
            {"frames", dump.steps.size()},
            {"last_step", dump.steps.empty() ? -1 : dump.steps.back()},
            {"bytes", bytes}};
}

void resume(Dump& dump, const nlohmann::json& then) {
    const nlohmann::json now = described(dump);
    const std::string before = " as before the interrupt";
    if (now.at("formats") != then.at("formats"))
        refuse_resume("--dump", now.at("formats"),
                      "must be " + then.at("formats").get<std::string>() + before);
    if (now.at("every") != then.at("every"))
        refuse_resume("--dump-every", reports::quantity(dump.plan.every, "s"),
                      "must be " + reports::quantity(then.at("every"), "s") + before);
    dump.steps.clear();
    for (std::size_t k = 0; k < then.at("frames"); ++k)
        dump.steps.push_back(step_of_frame(dump, k));
    if (!dump.steps.empty()) dump.steps.back() = then.at("last_step");  // a finished run's own
    for (const DumpFormat format : dump.plan.formats)
        if (grows(format))
            cut_back(dump, format, then.at("bytes").at(name_of(format)));
        else
            keep_vtp_frames(dump);
}

std::int64_t next_frame(const Dump& dump) {
    if (dump.plan.formats.empty()) return std::numeric_limits<std::int64_t>::max();
    return step_of_frame(dump, dump.steps.size());
}

void add_frame(Dump& dump, const dem_min::Simulation& s) {
    if (dump.plan.formats.empty()) return;
    if (!dump.steps.empty() && dump.steps.back() == s.steps) return;
    const reports::Frame frame = frame_of(s, dump.box);
    const bool first = dump.steps.empty();
    dump.steps.push_back(s.steps);
    for (const DumpFormat format : dump.plan.formats) {
        if (!grows(format)) {
            write_vtp_frame(dump, frame);
            continue;
        }
        std::uintmax_t& end = dump.end_bytes.at(format);
        end = append_whole(file_of(dump, format), end, [&](std::ostream& out) {
            if (format == DumpFormat::lammps) reports::write_lammps(out, frame, first);
            if (format == DumpFormat::extxyz) reports::write_extxyz(out, frame);
        });
    }
}

std::vector<fs::path> files(const Dump& dump) {
    std::vector<fs::path> all;
    for (const DumpFormat format : dump.plan.formats) all.push_back(file_of(dump, format));
    return all;
}

}  // namespace app
