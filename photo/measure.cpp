// SPDX-License-Identifier: MIT
#include "photo/measure.hpp"

#include "photo/base_line.hpp"
#include "photo/flank.hpp"
#include "photo/outline.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace photo {
namespace {

using scaling::Finding;
using scaling::InvalidParameter;
using scaling::Judgement;
using scaling::mistake;

constexpr double deg = std::numbers::pi / 180.0;

// Thresholds are ours. Below these a wrong angle was seen on rendered heaps (docs/photo.md), or nothing is left to fit.
constexpr double least_contrast = 3.0, good_contrast = 5.0;
constexpr double least_height = 40.0;  // pixels: a tenth of a pixel over the window's 24 is 0.3 deg
constexpr double least_pieces = 5.0, good_pieces = 10.0;
constexpr double most_rough = 0.10, good_rough = 0.04;  // of the height
constexpr double steepest = 70.0 * deg;                 // columns hardly meet a steeper edge
constexpr double window_low = 0.2;  // of the height: what the border may cut off

// Along and above a base line.
struct Frame {
    Line base;
    double length;  // of (1, slope)

    explicit Frame(const Line& line) : base(line), length(std::hypot(1.0, line.slope)) {}
    EdgePoint operator()(Pixel p) const {
        return {(p.x + base.slope * (p.y - base.level)) / length, (base.y(p.x) - p.y) / length};
    }
    Pixel back(EdgePoint q) const {
        return {(q.along + base.slope * q.above) / length,
                base.level + (base.slope * q.along - q.above) / length};
    }
};

// One flank from the apex outwards, until the outline has come down to the base.
struct Side {
    std::vector<EdgePoint> points;
    std::optional<double> foot;  // along, from the apex; none where the picture ends before
};

Side side_of(const std::vector<EdgePoint>& outline, double apex, double height, bool left,
             bool cut) {
    Side side;
    const double ground = std::max(1.5, 0.01 * height);
    int low = 0;
    double first_low = 0.0;
    const auto add = [&](const EdgePoint& p) {
        const double along = left ? apex - p.along : p.along - apex;
        if (along < 0.0 || side.foot) return;
        side.points.push_back({along, p.above});
        if (p.above >= ground)
            low = 0;
        else if (++low == 1)
            first_low = along;
        else if (low == 3)
            side.foot = first_low;  // one column of dust is no foot
    };
    if (left)
        std::for_each(outline.rbegin(), outline.rend(), add);
    else
        std::for_each(outline.begin(), outline.end(), add);
    if (!side.foot && !cut && !side.points.empty()) side.foot = side.points.back().along;
    return side;
}

struct Outline {
    std::vector<EdgePoint> points;
    double height, apex;  // pixels above the base line; along it
};

// Height: the highest of medians of three neighbours. Apex: middle of what lies above 80 % of it.
Outline outline_of(const std::vector<Pixel>& edge, const Frame& frame) {
    Outline o{{}, 0.0, 0.0};
    for (const Pixel& p : edge) o.points.push_back(frame(p));
    for (std::size_t k = 2; k < o.points.size(); ++k) {
        std::array<double, 3> near{o.points[k - 2].above, o.points[k - 1].above, o.points[k].above};
        std::sort(near.begin(), near.end());
        o.height = std::max(o.height, near[1]);
    }
    double count = 0.0;
    for (const EdgePoint& p : o.points)
        if (p.above >= 0.8 * o.height) o.apex += p.along, count += 1.0;
    o.apex /= std::max(1.0, count);
    return o;
}

// Whoever judges: findings in order; false once one is unusable.
struct Judge {
    std::vector<Finding>& findings;

    bool at_least(const char* name, double value, double least, double good,
                  const std::string& text) {
        return add(name, value, fmt::format(">= {:g}", least), value >= least, value >= good, text);
    }
    bool at_most(const char* name, double value, double most, double good,
                 const std::string& text) {
        return add(name, value, fmt::format("<= {:g}", most), value <= most, value <= good, text);
    }
    bool holds(const char* name, bool value, const char* rule, const std::string& text) {
        return add(name, value ? 1.0 : 0.0, rule, value, value, text);
    }

  private:
    bool add(const char* name, double value, std::string rule, bool usable, bool good,
             const std::string& text) {
        const Judgement j = !usable ? Judgement::unusable
                            : good  ? Judgement::fine
                                    : Judgement::caution;
        findings.push_back({name, value, std::move(rule), j, j == Judgement::fine ? "" : text});
        return usable;
    }
};

struct Attempt {
    const Picture& picture;
    const Box& box;
    const Settings& settings;
    Tone tone;
    bool lighter;

    Measurement measurement{};
    Field field{};
    Region region{};
    std::vector<Pixel> edge{};  // in the field

    Pixel in_field(Pixel p) const {
        const Pixel q = picture.in_rgb(p);
        return {q.x - static_cast<double>(box.x), q.y - static_cast<double>(box.y)};
    }
    Pixel in_file(Pixel p) const {
        return picture.in_file(
            {p.x + static_cast<double>(box.x), p.y + static_cast<double>(box.y)});
    }
    double file_length(double pixels) const {
        return pixels * static_cast<double>(picture.reduced_by);
    }

    std::optional<BaseLine> given_base() const;
    std::optional<BaseLine> base_line(Judge&) const;
    void lift_to_feet(BaseLine&, Judge&) const;
    bool fit(const BaseLine&, Judge&);
    void run();
};

std::optional<BaseLine> Attempt::given_base() const {
    if (!settings.base) return std::nullopt;
    const Pixel a = in_field(settings.base->first), b = in_field(settings.base->second);
    const double slope = (b.y - a.y) / (b.x - a.x);
    // A point that is picked by hand is good to a pixel of the file, or of what is worked on.
    return BaseLine{{a.y - slope * a.x, slope}, std::numbers::sqrt2 / std::abs(b.x - a.x), 0.7};
}

// Seen from above, the near side of the foot hangs below the line through its ends, by the sine of the camera's angle of the foot's radius. The heap then
// stands on the line through its ends. Pixels of the region's shape are good enough to tell.
void Attempt::lift_to_feet(BaseLine& base, Judge& judge) const {
    std::optional<std::size_t> first;
    std::size_t last = 0;
    double above = 0.0;
    const auto column = [&](std::size_t i) {
        double sum = 0.0, count = 0.0;
        for (std::size_t j = 0; j < region.height; ++j)
            if (region.on[j * region.width + i]) sum += static_cast<double>(j), count += 1.0;
        return std::pair{sum, count};
    };
    for (std::size_t i = 0; i < region.width; ++i)
        if (column(i).second > 0.0) first = first.value_or(i), last = i;
    for (const std::size_t i : {*first, last}) {
        const auto [sum, count] = column(i);
        above += 0.5 * (base.line.y(static_cast<double>(i)) - sum / count);
    }
    const double radius = 0.5 * static_cast<double>(last - *first);
    if (above < std::max(4.0, 0.04 * radius)) return;
    base.line.level -= above;
    if (settings.looking_down_stated) return;
    const double down = std::asin(std::min(1.0, above / radius)) / deg;
    judge.at_most("camera_seems_to_look_down_degrees", down, 90.0, 0.0,
                  fmt::format("The foot hangs below its ends as if the camera looked down by "
                              "{:.0f} deg: state by how much",
                              down));
}

std::optional<BaseLine> Attempt::base_line(Judge& judge) const {
    if (settings.base) return given_base();
    const bool both = region.touches_left && region.touches_right;
    const bool none = !region.touches_left && !region.touches_right && !region.touches_bottom;
    if (!judge.holds("foot_in_picture", both || none, "both feet, or table on both sides",
                     "The heap, or what it stands on, runs out of the picture on one side or "
                     "below: crop the picture, or "
                     "state the base line by two points"))
        return std::nullopt;
    auto found = find_base_line(both ? edge : lower_edge(field, region), field.width);
    judge.holds("base_line_found", found.has_value(), "straight on both sides of the heap",
                "No straight base line was found: state it by two points");
    if (found && none) lift_to_feet(*found, judge);
    return found;
}

void Attempt::run() {
    measurement.tone = tone, measurement.lighter = lighter;
    Judge judge{measurement.findings};
    field = separate(picture, box, tone, lighter);
    if (!judge.at_least("contrast_to_noise", field.contrast_to_noise, least_contrast, good_contrast,
                        "Heap and background are hardly told apart: light the background evenly, "
                        "choose one of another colour, "
                        "or crop the picture to heap and background"))
        return;
    const auto given = given_base();
    region = largest_region(field, given ? std::optional(given->line) : std::nullopt);
    edge = upper_edge(field, region);
    for (const Pixel& p : edge) measurement.edge.push_back(in_file(p));
    if (!judge.at_least("heap_share_of_picture",
                        static_cast<double>(region.pixels) / static_cast<double>(field.v.size()),
                        0.005, 0.02,
                        "No heap was found, or a very small one: crop the picture, or go closer"))
        return;
    if (!judge.holds("background_above", !region.touches_top, "background at the upper border",
                     "What was taken for the heap reaches the upper border: leave room above it, "
                     "or crop what else is in the picture"))
        return;
    const auto base = base_line(judge);
    if (base) fit(*base, judge);
}

Flank flank_of(const FlankFit& f, double slope_error, double light, const Settings& settings) {
    const double apparent = std::atan(f.slope), angle = seen_level(apparent, settings.looking_down);
    const double step = 1e-4;
    const double gain = (seen_level(apparent + step, settings.looking_down) - angle) / step;
    const double roughness = gain * f.slope_error / (1.0 + f.slope * f.slope);
    const double all =
        std::sqrt(roughness * roughness + gain * gain * slope_error * slope_error + light * light);
    const double t = statistics::student_quantile(0.975, f.degrees_of_freedom);
    return {angle, roughness, {angle - t * all, angle + t * all}, f.roughness, f.pieces, {}, {}};
}

// What left and right differ by beyond what their own errors explain, as the standard error of their mean: two of the many views
// of a heap whose flanks differ. Variance between views: (left - right)^2 / 2 less its expectation.
Parts parts_of(const Flank& left, const Flank& right, double tilt_error, double light) {
    const double own =
        left.standard_error * left.standard_error + right.standard_error * right.standard_error;
    const double apart = left.angle - right.angle;
    const double between =
        std::max(0.0, 0.5 * (apart * apart - own) - 2.0 * tilt_error * tilt_error);
    Parts p{0.5 * std::sqrt(own), light, std::sqrt(0.5 * between), 0.0};
    p.total =
        std::sqrt(p.roughness * p.roughness + p.light * p.light + p.difference * p.difference);
    return p;
}

// Welch and Satterthwaite: only the roughness is an estimate of few freedoms.
double freedoms(const Flank& left, const Flank& right, const FlankFit& l, const FlankFit& r,
                const Parts& parts) {
    const double a = std::pow(0.5 * left.standard_error, 4) / l.degrees_of_freedom;
    const double b = std::pow(0.5 * right.standard_error, 4) / r.degrees_of_freedom;
    return std::max(1.0, std::pow(parts.total, 4) / std::max(a + b, 1e-300));
}

// Whether the flanks reach over the window, and are straight enough for one angle.
bool shape(std::span<const EdgePoint> left, const FlankFit& l, std::span<const EdgePoint> right,
           const FlankFit& r, double height, Judge& judge) {
    const auto reach = [&](const FlankFit& f) {
        const auto [low, high] = std::minmax_element(
            f.points.begin(), f.points.end(),
            [](const EdgePoint& a, const EdgePoint& b) { return a.above < b.above; });
        return (high->above - low->above) / (0.6 * height);
    };
    if (!judge.at_least("share_of_window_seen", std::min(reach(l), reach(r)), 0.8, 0.9,
                        "The flank's edge is not seen from 20 to 80 % of the height: see whether "
                        "the marked edge and the base line are the heap's"))
        return false;
    const auto bend = [&](std::span<const EdgePoint> points) {
        const auto lower = flank_slope(points, 0.2 * height, 0.5 * height),
                   upper = flank_slope(points, 0.5 * height, 0.8 * height);
        return lower && upper ? std::atan(*lower) - std::atan(*upper) : std::nan("");
    };
    const double bent = 0.5 * (bend(left) + bend(right)) / deg;
    if (!std::isfinite(bent)) return true;  // half of a short flank may have too few columns
    return judge.at_most("flanks_bent_degrees", std::abs(bent), 20.0, 8.0,
                         bent > 0.0 ? "The flanks are round: steeper below the middle than above "
                                      "it; one angle describes them badly"
                                    : "The flanks are hollow: steeper above the middle than below "
                                      "it; one angle describes them badly");
}

bool Attempt::fit(const BaseLine& base, Judge& judge) {
    const Frame frame(base.line);
    const Outline outline = outline_of(edge, frame);
    const double height = outline.height;
    if (!judge.at_least(
            "height_in_pixels", height, least_height, 2.0 * least_height,
            "The heap is too small in the picture: go closer, or take a picture with more pixels"))
        return false;
    const double last = static_cast<double>(field.width) - 1.5;
    const auto cut = [&](const EdgePoint& p, Pixel q) {
        return q.x < 0.5 || q.x > last ? std::max(0.0, p.above / height) : 0.0;
    };
    const double cut_left = cut(outline.points.front(), edge.front()),
                 cut_right = cut(outline.points.back(), edge.back());
    if (!judge.at_most("cut_by_border", std::max(cut_left, cut_right), window_low, 0.05,
                       "The picture's border cuts the heap: take in its feet"))
        return false;
    const Side left_side = side_of(outline.points, outline.apex, height, true, cut_left > 0.0);
    const Side right_side = side_of(outline.points, outline.apex, height, false, cut_right > 0.0);
    if (!settings.base && region.touches_left && region.touches_right && left_side.foot &&
        right_side.foot) {
        double flat = 0.0, all = 0.0;
        for (const EdgePoint& p : outline.points) {
            const double along = p.along - outline.apex;
            if (-along <= *left_side.foot && along <= *right_side.foot) continue;
            all += 1.0, flat += std::abs(p.above) <= 3.0;
        }
        if (!judge.at_least("share_of_table_on_base_line", all > 0.0 ? flat / all : 1.0, 0.7, 0.9,
                            "What lies beside the heap is no straight table: state the base line "
                            "by two points, or light more evenly"))
            return false;
    }
    const auto l = fit_flank(left_side.points, height, settings.seed),
               r = fit_flank(right_side.points, height, settings.seed + 1);
    if (!judge.holds(
            "flanks_found", l && r, "at least 12 columns each, falling outwards",
            "There is no flank to fit on one side: see whether the marked edge is the heap's"))
        return false;
    if (!judge.at_least("independent_pieces_of_flank", std::min(l->pieces, r->pieces), least_pieces,
                        good_pieces,
                        "The flank is short against its bumps: its angle is known badly; a larger "
                        "heap, or finer grains, helps") ||
        !judge.at_most("roughness_over_height", std::max(l->roughness, r->roughness) / height,
                       most_rough, good_rough,
                       "The flanks are no straight lines: one angle describes them badly"))
        return false;

    if (!shape(left_side.points, *l, right_side.points, *r, height, judge)) return false;

    // === The same with the edge taken farther out and farther in
    std::array<double, 2> shifted{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Outline other = outline_of(upper_edge(field, region, k == 0 ? 0.35 : 0.65), frame);
        const auto slope = [&](bool left) {
            return flank_slope(side_of(other.points, outline.apex, height, left, false).points,
                               0.2 * height, 0.8 * height);
        };
        const auto a = slope(true), b = slope(false);
        shifted[k] = a && b ? 0.5 * (std::atan(*a) + std::atan(*b)) : std::nan("");
    }
    const double middle = 0.5 * (std::atan(l->slope) + std::atan(r->slope));
    double light = 0.0;
    for (const double angle : shifted)
        light = std::max(light, std::abs(angle - middle) / std::numbers::sqrt3);
    if (!judge.at_most("edge_uncertainty_degrees",
                       std::isfinite(shifted[0] + shifted[1]) ? light / deg : 90.0, 3.0, 0.5,
                       "The angle depends on where in the blurred edge it is taken: sharpen the "
                       "focus, light more evenly"))
        return false;

    Heaped h{};
    h.left = flank_of(*l, base.slope_error, light, settings);
    h.right = flank_of(*r, base.slope_error, light, settings);
    const auto drawn = [&](Flank& flank, const FlankFit& f, double sign) {
        const auto at = [&](double share) {
            const double along = (f.level - share * height) / f.slope;
            return in_file(frame.back({outline.apex + sign * along, share * height}));
        };
        flank.foot = at(0.2), flank.top = at(0.8);
        flank.roughness = file_length(flank.roughness);
    };
    drawn(h.left, *l, -1.0), drawn(h.right, *r, 1.0);
    if (!judge.at_most("steeper_flank_degrees", std::max(h.left.angle, h.right.angle) / deg,
                       steepest / deg, 60.0,
                       "So steep an edge is hardly met by the picture's columns: turn the picture, "
                       "or distrust the angle"))
        return false;
    h.angle = 0.5 * (h.left.angle + h.right.angle);
    h.parts = parts_of(h.left, h.right, base.slope_error, light);
    const double t =
        statistics::student_quantile(0.975, freedoms(h.left, h.right, *l, *r, h.parts));
    h.interval = {h.angle - t * h.parts.total, h.angle + t * h.parts.total};
    h.tilt = -std::atan(base.line.slope), h.tilt_error = base.slope_error;
    const double end = static_cast<double>(field.width) - 1.0;
    h.base_left = in_file({0.0, base.line.y(0.0)}), h.base_right = in_file({end, base.line.y(end)});
    h.height = file_length(height);
    judge.at_most("flanks_differ_degrees", std::abs(h.left.angle - h.right.angle) / deg, 90.0,
                  std::max(1.0, 3.0 *
                                    std::hypot(h.left.standard_error, h.right.standard_error,
                                               2.0 * h.tilt_error) /
                                    deg),
                  "Left and right differ by more than their roughness: the heap is not round, was "
                  "fed off its middle, or the base line is not its "
                  "own; one picture shows two flanks of many");

    // === Foot and profile
    double middle_of_foot = outline.apex;
    if (left_side.foot && right_side.foot) {
        const double width = *left_side.foot + *right_side.foot;
        middle_of_foot = outline.apex + 0.5 * (*right_side.foot - *left_side.foot);
        h.foot_width = file_length(width);
        const double left_end = std::max(1.0, l->roughness) / l->slope,
                     right_end = std::max(1.0, r->roughness) / r->slope;
        h.width_error = file_length(
            std::hypot(left_end, right_end, base.level_error * (1.0 / l->slope + 1.0 / r->slope)));
        if (settings.looking_down == 0.0) h.two_h_over_d = std::atan(2.0 * height / width);
    }
    const auto append = [&](const EdgePoint& p, double sign) {
        h.profile.along.push_back(file_length(outline.apex + sign * p.along - middle_of_foot));
        h.profile.above.push_back(file_length(std::max(0.0, p.above)) /
                                  std::cos(settings.looking_down));
    };
    for (auto p = left_side.points.rbegin(); p != left_side.points.rend(); ++p) append(*p, -1.0);
    for (const EdgePoint& p : right_side.points) append(p, 1.0);
    measurement.heap = std::move(h);
    return true;
}

void check(const Picture& picture, const Settings& settings) {
    const Pixel end = picture.in_file(
        {static_cast<double>(picture.width) - 1.0, static_cast<double>(picture.height) - 1.0});
    const double more = static_cast<double>(picture.reduced_by);
    const auto inside = [&](const char* name, const std::pair<Pixel, Pixel>& pair) {
        for (const Pixel& p : {pair.first, pair.second})
            if (!(p.x >= 0.0 && p.y >= 0.0 && p.x <= end.x + more && p.y <= end.y + more))
                throw InvalidParameter(
                    mistake(name, fmt::format("{:g},{:g}", p.x, p.y),
                            fmt::format("must lie in the picture of {:.0f} x {:.0f} pixels",
                                        end.x + 1.0, end.y + 1.0),
                            "x from the left, y from the top"));
    };
    if (settings.base) {
        inside("base", *settings.base);
        const double across = std::abs(settings.base->second.x - settings.base->first.x);
        const double up = std::abs(settings.base->second.y - settings.base->first.y);
        if (!(across >= 16.0 * more) || up > across)
            throw InvalidParameter(mistake(
                "base", fmt::format("{:g} pixels across, {:g} up", across, up),
                fmt::format("must be at least {:g} across and flatter than 45 deg", 16.0 * more),
                "take points left and right of the heap"));
    }
    if (settings.crop) {
        inside("crop", *settings.crop);
        const double across = std::abs(settings.crop->second.x - settings.crop->first.x);
        const double up = std::abs(settings.crop->second.y - settings.crop->first.y);
        if (std::min(across, up) < 32.0 * more)
            throw InvalidParameter(
                mistake("crop", fmt::format("{:g} x {:g} pixels", across, up),
                        fmt::format("must be at least {:g} each way", 32.0 * more),
                        "take in the heap and background"));
    }
    if (!(std::abs(settings.looking_down) < 45.0 * deg))
        throw InvalidParameter(mistake("looking_down",
                                       fmt::format("{:g} deg", settings.looking_down / deg),
                                       "must be below 45 deg", "take the picture from the side"));
}

Box box_of(const Picture& picture, const Settings& settings) {
    if (!settings.crop) return {0, 0, picture.width, picture.height};
    const Pixel a = picture.in_rgb(settings.crop->first), b = picture.in_rgb(settings.crop->second);
    const auto index = [](double v, std::size_t size) {
        return static_cast<std::size_t>(
            std::clamp(std::round(v), 0.0, static_cast<double>(size) - 1.0));
    };
    const std::size_t x = index(std::min(a.x, b.x), picture.width),
                      y = index(std::min(a.y, b.y), picture.height);
    return {x, y, index(std::max(a.x, b.x), picture.width) + 1 - x,
            index(std::max(a.y, b.y), picture.height) + 1 - y};
}

// The one that was measured; of two or none the one with the better contrast.
bool better(const Measurement& a, const Measurement& b) {
    if (a.heap.has_value() != b.heap.has_value()) return a.heap.has_value();
    return a.findings.front().value > b.findings.front().value;
}

}  // namespace

double seen_level(double apparent, double looking_down) {
    if (looking_down == 0.0) return apparent;
    const double s = std::sin(looking_down);
    return std::atan(std::hypot(std::tan(apparent), s) / std::cos(looking_down));
}

Measurement measure(const Picture& picture, const Settings& settings) {
    check(picture, settings);
    const Box box = box_of(picture, settings);
    std::optional<Measurement> best;
    for (const Tone tone : {Tone::brightness, Tone::red_less_blue, Tone::green_less_rest}) {
        if (best && best->heap) break;  // colours only where brightness does not do
        for (const bool lighter : {false, true}) {
            if (settings.heap != Heap::either && lighter != (settings.heap == Heap::light) &&
                tone == Tone::brightness)
                continue;
            Attempt attempt{picture, box, settings, tone, lighter};
            attempt.run();
            if (!best || better(attempt.measurement, *best)) best = std::move(attempt.measurement);
        }
    }
    if (best->heap) {
        const double low = seen_level(best->heap->angle, 10.0 * deg) - best->heap->angle;
        if (!settings.looking_down_stated)
            best->findings.push_back(
                {"camera_level_assumed", low / deg, "stated", Judgement::caution,
                 fmt::format(
                     "The camera is taken to look level at the apex. Had it looked down or up by "
                     "10 deg, the heap would be {:.1f} deg "
                     "steeper than read, by 5 deg {:.1f} deg",
                     low / deg,
                     (seen_level(best->heap->angle, 5.0 * deg) - best->heap->angle) / deg)});
    }
    return std::move(*best);
}

}  // namespace photo
