// SPDX-License-Identifier: MIT
#include "app/photo.hpp"

#include "app/exit_code.hpp"
#include "cases/csv.hpp"
#include "cases/units.hpp"
#include "photo/measure.hpp"
#include "reports/photo.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>

namespace app {
namespace {

using reports::Json;
using scaling::InvalidInput;
using scaling::mistake;

struct PhotoOptions {
    CommonOptions common;
    std::string path, base, crop, heap, known, foot, looking_down, profile;
};

using Points = std::pair<photo::Pixel, photo::Pixel>;

// "x1,y1 x2,y2"
Points points_of(const std::string& text, const char* where) {
    double values[4];
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto skip = [&] {
        while (at != end && (*at == ' ' || *at == ',')) ++at;
    };
    std::size_t count = 0;
    for (skip(); at != end && count < 4; skip()) {
        const auto [next, error] = std::from_chars(at, end, values[count]);
        if (error != std::errc{} || !std::isfinite(values[count])) break;
        at = next, ++count;
    }
    if (count != 4 || at != end)
        throw InvalidInput(mistake(where, '"' + text + '"', "must be two points \"x1,y1 x2,y2\"",
                                   "in pixels from the picture's top left corner, y down"));
    return {{values[0], values[1]}, {values[2], values[3]}};
}

double length_of(const std::string& text, const char* where) {
    const double v = cases::to_si(text, cases::parse_unit("m", where), where);
    if (!(v > 0.0) || !std::isfinite(v))
        throw InvalidInput(
            mistake(where, '"' + text + '"', "must be > 0", "a length with its unit"));
    return v;
}

// "x1,y1 x2,y2 = 50 mm". A point that is picked by hand is good to a pixel.
reports::PhotoScale known_scale(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw InvalidInput(mistake("--known", '"' + text + '"',
                                   "must be two points and their distance",
                                   "such as \"120,300 520,304 = 50 mm\""));
    const Points p = points_of(text.substr(0, equals), "--known");
    const double pixels = std::hypot(p.second.x - p.first.x, p.second.y - p.first.y);
    if (pixels < 10.0)
        throw InvalidInput(mistake("--known", fmt::format("points {:g} pixels apart", pixels),
                                   "must be at least 10", "take a longer distance"));
    return {length_of(text.substr(equals + 1), "--known") / pixels, std::numbers::sqrt2 / pixels};
}

std::optional<reports::PhotoScale> scale_of(const PhotoOptions& o, const photo::Measurement& m) {
    if (!o.known.empty()) return known_scale(o.known);
    if (o.foot.empty()) return std::nullopt;
    const double width = length_of(o.foot, "--foot-width");
    if (!m.heap) return std::nullopt;
    if (!m.heap->foot_width)
        throw InvalidInput(mistake("--foot-width", '"' + o.foot + '"',
                                   "must be seen: the picture's border cuts a foot",
                                   "take --known instead"));
    return reports::PhotoScale{width / *m.heap->foot_width,
                               m.heap->width_error / *m.heap->foot_width};
}

photo::Settings settings_of(const PhotoOptions& o) {
    photo::Settings s;
    if (!o.base.empty()) s.base = points_of(o.base, "--base");
    if (!o.crop.empty()) s.crop = points_of(o.crop, "--crop");
    if (o.heap == "dark") s.heap = photo::Heap::dark;
    if (o.heap == "light") s.heap = photo::Heap::light;
    if (!o.looking_down.empty()) {
        s.looking_down = cases::to_si(o.looking_down, cases::parse_unit("rad", "--looking-down"),
                                      "--looking-down");
        s.looking_down_stated = true;
    }
    s.seed = o.common.seed;
    return s;
}

// The channels of the rig `pile`: left of the middle of the foot is azimuth pi, right of it 0.
void write_profile(const std::string& path, const photo::Profile& profile,
                   double metres_per_pixel) {
    cases::Column azimuth{"azimuth", "rad"}, r{"r", "m"}, z{"z", "m"};
    for (std::size_t k = 0; k < profile.along.size(); ++k) {
        azimuth.values.push_back(profile.along[k] < 0.0 ? std::numbers::pi : 0.0);
        r.values.push_back(std::abs(profile.along[k]) * metres_per_pixel);
        z.values.push_back(profile.above[k] * metres_per_pixel);
    }
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;  // writing says what is wrong
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    cases::write_csv(path, {azimuth, r, z});
}

int run(const PhotoOptions& o, const std::string& command) {
    if (!o.profile.empty() && o.known.empty() && o.foot.empty())
        throw InvalidInput(mistake("--profile", "a picture without a scale",
                                   "must have one: the profile is in metres",
                                   "state --known or --foot-width"));
    if (!o.known.empty()) known_scale(o.known);  // its mistakes before the work
    const photo::Settings settings = settings_of(o);
    const photo::Picture picture = photo::read_picture(o.path);
    const photo::Measurement m = photo::measure(picture, settings);
    const auto scale = scale_of(o, m);
    if (!o.profile.empty() && m.heap)
        write_profile(o.profile, m.heap->profile, scale->metres_per_pixel);

    Json json{{"format", "similitude-photo/1"},
              {"tool", reports::to_json(provenance(command, ""))}};
    json["picture"] = {{"path", o.path},
                       {"width", picture.width * picture.reduced_by},
                       {"height", picture.height * picture.reduced_by},
                       {"reduced_by", picture.reduced_by}};
    json.update(reports::to_json(m, scale));
    print(o.common, reports::text_of(m, scale));
    write_results(o.common, json, [&] {
        reports::Page page{.title = std::filesystem::path(o.path).filename().string(),
                           .source = "angle of repose from a photograph"};
        page.verdict = reports::verdict_of(m);
        page.runs = {reports::photo_section("Edge, base line and flanks", picture, m, scale)};
        page.runs_heading = "The picture and what was found in it";
        page.limits = reports::limits_of(m);
        page.provenance = provenance(command, "");
        page.provenance.seeds = {o.common.seed};
        return page;
    });
    return m.heap ? fine : cannot_tell;
}

constexpr const char* examples = R"(Examples:
  similitude photo heap.jpg
      angle, both flanks, 95 % interval; the base line is found
  similitude photo heap.jpg --base "210,1480 3020,1502" --known "210,1480 3020,1502 = 80 mm" --profile heap.csv --report heap.html
      base line and scale by two points each, from a picture viewer; profile for a case of the rig pile)";

}  // namespace

Verb photo_verb(CLI::App& app, const std::string& command) {
    const auto o = std::make_shared<PhotoOptions>();
    CLI::App* verb =
        app.add_subcommand("photo", "angle of repose and profile of a heap in a photograph");
    verb->footer(examples);
    verb->add_option("image", o->path, "PNG or JPEG of a heap, seen from the side")->required();
    verb->add_option(
        "--base", o->base,
        "two points of the line it stands on, \"x1,y1 x2,y2\" in pixels; found otherwise");
    verb->add_option("--crop", o->crop, "two corners of what is looked at, \"x1,y1 x2,y2\"");
    verb->add_option("--heap", o->heap, "dark or light against its background; found otherwise")
        ->check(CLI::IsMember({"dark", "light"}));
    verb->add_option("--known", o->known, "a distance in the picture, \"x1,y1 x2,y2 = 50 mm\"");
    verb->add_option("--foot-width", o->foot, "instead: how wide the heap's foot is, \"50 mm\"")
        ->excludes("--known");
    verb->add_option(
        "--looking-down", o->looking_down,
        "angle by which the camera looks down at the apex, with its unit; 0 otherwise");
    verb->add_option("--profile", o->profile,
                     "write azimuth, r, z for a case of the rig pile; needs a scale")
        ->type_name("FILE.csv");
    verb->add_option("--json", o->common.json,
                     "write the result as JSON to FILE, or to standard output with -")
        ->type_name("FILE");
    verb->add_option("--report", o->common.report, "write a self-contained HTML page")
        ->type_name("FILE.html");
    verb->add_option("--seed", o->common.seed, "of the bootstrap")->capture_default_str();
    verb->add_flag("--quiet", o->common.quiet, "no table");
    return {verb, [=] { return run(*o, command); }};
}

}  // namespace app
