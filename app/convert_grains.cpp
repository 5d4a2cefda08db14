// SPDX-License-Identifier: MIT
#include "app/convert_grains.hpp"

#include "app/exit_code.hpp"
#include "app/grain_input.hpp"
#include "cases/csv.hpp"
#include "cases/messages.hpp"
#include "reports/frame.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <stdexcept>

namespace app {

namespace {

namespace fs = std::filesystem;
using scaling::InvalidInput;
using scaling::mistake;

struct Options {
    GrainInput input;
    std::string to, out;
    bool quiet = false;
};

const std::vector<std::string> targets = {"lammps_dump", "lammps_data", "vtp",      "pvd",
                                          "extxyz",      "csv",         "yade_text"};

bool holds_mass(const std::string& to) { return to != "vtp" && to != "pvd" && to != "yade_text"; }
bool holds_many(const std::string& to) {
    return to == "lammps_dump" || to == "pvd" || to == "extxyz";
}

// A file that gets its name when it is whole.
class Target {
  public:
    explicit Target(const fs::path& file) : file_(file), unfinished_(file.string() + ".tmp") {
        if (file.has_parent_path()) {
            std::error_code ignored;  // the opening says what is wrong
            fs::create_directories(file.parent_path(), ignored);
        }
        out_.open(unfinished_, std::ios::binary);
        if (!out_) refuse();
    }
    ~Target() {
        std::error_code ignored;
        out_.close();
        fs::remove(unfinished_, ignored);
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    std::ostream& stream() { return out_; }
    void finish() {
        out_.close();
        if (!out_)
            throw std::runtime_error(unfinished_.string() + ": cannot be written (disk full?)");
        fs::rename(unfinished_, file_);
    }

  private:
    [[noreturn]] void refuse() const {
        throw InvalidInput(mistake(file_.string(), "a place that cannot be written",
                                   "must be writable", "choose another file or folder"));
    }
    fs::path file_, unfinished_;
    std::ofstream out_;
};

void write_whole(const fs::path& file, const std::function<void(std::ostream&)>& write) {
    Target target(file);
    write(target.stream());
    target.finish();
}

void check(const Options& o, const engines::GrainFrame& g) {
    if (holds_mass(o.to) && o.to != "csv" && !g.has_mass && g.frame.count() > 0)
        throw InvalidInput(mistake(o.input.path, "grains without mass",
                                   "must have a mass for " + o.to, "state --density"));
    if (o.to != "lammps_data" && o.to != "lammps_dump") return;
    for (const int type : g.frame.type)
        if (type < 1)
            throw InvalidInput(mistake(o.input.path, fmt::format("type {}", type),
                                       "must be >= 1 in LAMMPS", "number the types from 1"));
}

std::vector<cases::Column> table_of(const engines::GrainFrame& g) {
    std::vector<cases::Column> table;
    const rigs::Frame& f = g.frame;
    const auto add = [&](const char* name, const char* unit, auto&& value) {
        table.push_back({name, unit});
        for (std::size_t k = 0; k < f.count(); ++k)
            table.back().values.push_back(static_cast<double>(value(k)));
    };
    const auto add_vector = [&](const std::string& name, const char* unit, const auto& vectors) {
        add((name + "x").c_str(), unit, [&](std::size_t k) { return vectors[k].x; });
        add((name + "y").c_str(), unit, [&](std::size_t k) { return vectors[k].y; });
        add((name + "z").c_str(), unit, [&](std::size_t k) { return vectors[k].z; });
    };
    add("id", "1", [&](std::size_t k) { return f.id[k]; });
    add("type", "1", [&](std::size_t k) { return f.type_of(k); });
    add_vector("", "m", f.position);
    add("radius", "m", [&](std::size_t k) { return f.radius[k]; });
    if (g.has_mass) add("mass", "kg", [&](std::size_t k) { return f.mass[k]; });
    if (g.has_velocity) add_vector("v", "m/s", f.velocity);
    if (g.has_spin) add_vector("omega", "rad/s", f.spin);
    return table;
}

void write_one(const Options& o, const engines::GrainFrame& g) {
    if (o.to == "csv") return cases::write_csv(o.out, table_of(g));
    write_whole(o.out, [&](std::ostream& out) {
        if (o.to == "lammps_dump") reports::write_lammps(out, g.frame, true);
        if (o.to == "lammps_data") reports::write_lammps_data(out, g.frame);
        if (o.to == "extxyz") reports::write_extxyz(out, g.frame);
        if (o.to == "vtp") reports::write_vtp(out, g.frame);
        if (o.to == "yade_text") reports::write_yade_text(out, g.frame);
    });
}

// Frames of a collection stand in a folder beside it.
std::string vtp_name(const fs::path& out, std::size_t k) {
    return fmt::format("{}-vtp/frame-{:06}.vtp", out.stem().string(), k);
}

void write_vtp_frame(const Options& o, const rigs::Frame& f, std::size_t k,
                     std::vector<reports::TimedFile>& list) {
    const std::string name = vtp_name(o.out, k);
    write_whole(fs::path(o.out).parent_path() / name,
                [&](std::ostream& out) { reports::write_vtp(out, f); });
    list.push_back({f.time, name});
}

void say(const Options& o, const engines::GrainFrame& g, std::size_t frames) {
    if (o.quiet) return;
    fmt::print(stderr, "similitude: {} frame{}, {} grains in the last -> {}\n", frames,
               frames == 1 ? "" : "s", g.frame.count(), o.out);
    std::string lost;
    const auto add = [&](const std::string& what) { lost += (lost.empty() ? "" : ", ") + what; };
    for (const std::string& name : g.unused) add(name);
    if (o.to == "yade_text")
        for (const char* what : {"id", "type"}) add(what);
    if (o.to == "yade_text" && g.has_velocity) add("velocity");
    if (o.to == "yade_text" && g.has_spin) add("spin");
    if (!holds_mass(o.to) && g.has_mass) add("mass");
    if (o.to == "vtp" || o.to == "pvd" || o.to == "extxyz") add("type (fixed is kept)");
    if (!lost.empty()) fmt::print(stderr, "similitude: left out: {}\n", lost);
    if (o.to == "yade_text" || o.to == "csv") return;
    if (!g.has_velocity || !g.has_spin)
        fmt::print(stderr, "similitude: {} not in {}: written as 0\n",
                   g.has_velocity ? "spins are" : "velocities are", o.input.path);
    if (!g.has_time && o.to != "lammps_data")
        fmt::print(stderr, "similitude: no times in {}: written as 0\n", o.input.path);
}

int run(const Options& o) {
    if (fs::exists(o.out) && fs::equivalent(o.input.path, o.out))
        throw InvalidInput(mistake("OUT", cases::in_quotes(o.out),
                                   "must not be the file that is read", "choose another name"));
    std::vector<reports::TimedFile> list;
    if (o.input.frame != "all") {
        const ChosenFrame chosen = read_frame(o.input, "--from");
        check(o, chosen.grains);
        if (o.to == "pvd")
            write_vtp_frame(o, chosen.grains.frame, 0, list);
        else
            write_one(o, chosen.grains);
        if (o.to == "pvd")
            write_whole(o.out, [&](std::ostream& out) { reports::write_pvd(out, list); });
        say(o, chosen.grains, 1);
        return fine;
    }
    if (!holds_many(o.to))
        throw InvalidInput(mistake("--frame", "all", "must be one frame for " + o.to,
                                   "lammps_dump, extxyz and pvd hold many"));
    const auto reader = engines::open_grains(o.input.path, grain_options(o.input, "--from"));
    std::optional<Target> target;
    if (o.to != "pvd") target.emplace(o.out);
    engines::GrainFrame g;
    std::size_t frames = 0;
    for (; reader->next(g); ++frames) {
        check(o, g);
        if (o.to == "lammps_dump")
            reports::write_lammps(target->stream(), g.frame, frames == 0);
        else if (o.to == "extxyz")
            reports::write_extxyz(target->stream(), g.frame);
        else
            write_vtp_frame(o, g.frame, frames, list);
    }
    if (target)
        target->finish();
    else
        write_whole(o.out, [&](std::ostream& out) { reports::write_pvd(out, list); });
    say(o, g, frames);
    return fine;
}

}  // namespace

Verb convert_grains_verb(CLI::App& convert) {
    const auto o = std::make_shared<Options>();
    CLI::App* verb =
        convert.add_subcommand("grains", "a file of grains in another program's format");
    verb->add_option("IN", o->input.path, "what is read, as in similitude measure")->required();
    verb->add_option("OUT", o->out, "what is written")->required();
    verb->add_option("--from", o->input.format,
                     "lammps_dump, lammps_data, edem_csv, csv, mercury_data, yade_text; told by "
                     "the first line otherwise");
    verb->add_option("--to", o->to, "lammps_dump, lammps_data, vtp, pvd, extxyz, csv, yade_text")
        ->required()
        ->check(CLI::IsMember(targets));
    add_grain_input(*verb, o->input);
    verb->get_option("--frame")->description("last, the number of a frame from 0 on, or all");
    verb->add_flag("--quiet", o->quiet, "do not say what is left out");
    return {verb, [=] { return run(*o); }};
}

}  // namespace app
