// SPDX-License-Identifier: MIT
#include "diagnose/piles.hpp"

#include "diagnose/candidates.hpp"
#include "diagnose/pile_emulator.hpp"
#include "diagnose/pile_heaps.hpp"
#include "diagnose/pile_profile.hpp"
#include "rigs/pile.hpp"
#include "rigs/scanner.hpp"
#include "scaling/errors.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::uint64_t fresh_seeds = 1'000'000;
constexpr int heaps_of_other = 8;  // in each world of an apparatus without an emulator

double upper_tail(double squares, double count) {
    // Wilson & Hilferty 1931.
    const double z =
        (std::cbrt(squares / count) - (1.0 - 2.0 / (9.0 * count))) / std::sqrt(2.0 / (9.0 * count));
    return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

// No heap lies below its base: a scanner that reads too low does not make one that is like none.
VectorXd lifted(VectorXd numbers, Index rings) {
    double lowest = 0.0;
    for (const double z : numbers.head(rings)) lowest = std::min(lowest, z);
    numbers.head(rings).array() -= lowest;
    return numbers;
}

}  // namespace

struct Piles::Inside {
    // One way to look at the heaps of a family.
    struct View {
        Apparatus* family;
        Scan spots;
        double noise;
        Rings rings;
        Numbers numbers;
        std::unique_ptr<PileEmulator> emulator{};
        PileEmulator::Learned learned{};
    };

    const cases::Case& given;
    const Settings& settings;
    Pourer pourer;
    std::vector<std::unique_ptr<Apparatus>> families;
    std::vector<std::unique_ptr<View>> views;
    std::vector<BulkEffect> effects;
    mutable std::vector<double> unseen;  // per round: mean square of what heaps were off
    mutable std::mutex guard{};

    Inside(const cases::Case& c, const Settings& s) : given(c), settings(s), pourer(c, s) {}

    Apparatus* family_of(const cases::Experiment& e) const {
        const rigs::PileSetup setup = rigs::pile_setup(given, e, 1);
        for (const auto& f : families)
            if (alike(f->stated, setup)) return f.get();
        return nullptr;
    }

    VectorXd coordinates(const Apparatus& f, const rigs::World& w) const {
        VectorXd x(static_cast<Index>(f.axes.size()));
        for (std::size_t k = 0; k < f.axes.size(); ++k)
            x[static_cast<Index>(k)] = coordinate(f.axes[k], w);
        return x;
    }
    VectorXd numbers_of(const View& v, const rigs::Heap& heap) const {
        return v.rings.reduced(rigs::heights_at(heap, v.spots.azimuth, v.spots.r), false);
    }
    void emulate(View& v, bool anew) const {
        const Apparatus& f = *v.family;
        const auto runs = static_cast<Index>(f.heaps.size());
        MatrixXd x(runs, static_cast<Index>(f.axes.size())),
            y(runs, static_cast<Index>(4 * v.rings.count()));
        in_parallel(f.heaps.size(), settings.threads, [&](std::size_t k) {
            x.row(static_cast<Index>(k)) = coordinates(f, f.worlds[k]);
            y.row(static_cast<Index>(k)) = numbers_of(v, f.heaps[k]);
        });
        if (anew) v.learned = {};
        v.emulator = std::make_unique<PileEmulator>(std::move(x), std::move(y), v.numbers,
                                                    std::move(v.learned), settings.threads);
        v.learned = v.emulator->learned();
    }
    // What the emulator says of this world; tilted runs lean along x, other azimuths are turned there.
    VectorXd foreseen(const View& v, const rigs::World& w) const {
        if (!v.emulator) return fresh(v, w, heaps_of_other).colwise().mean();
        rigs::World along = w;
        double azimuth = 0.0;
        if (w.physics.contains("tilt")) {
            const auto turned = w.parameters.find("tilt_azimuth");
            azimuth = turned == w.parameters.end() ? 0.0 : turned->second;
            double& angle = along.parameters["tilt_angle"];
            if (angle < 0.0) angle = -angle, azimuth += std::numbers::pi;
        }
        VectorXd m = v.emulator->mean(coordinates(*v.family, along));
        for (std::size_t k = 0; k < v.numbers.lean.size(); ++k) {
            const double lean = m[v.numbers.lean[k]];
            m[v.numbers.lean[k]] = lean * std::cos(azimuth);
            m[v.numbers.across[k]] = lean * std::sin(azimuth);
        }
        return m;
    }
    // [heaps][numbers]
    MatrixXd fresh(const View& v, const rigs::World& w, int count) const {
        MatrixXd y(count, static_cast<Index>(4 * v.rings.count()));
        Index row = 0;
        for (const rigs::Heap& heap : pourer.pour(v.family->experiment, w, fresh_seeds, count))
            y.row(row++) = numbers_of(v, heap);
        return y;
    }

    View& view_of(const cases::Experiment& e) const;
    void add_family(const cases::Experiment&);
};

namespace {

class PileModel : public rigs::ForwardModel {
  public:
    using Foreseen = std::function<VectorXd(const rigs::World&)>;
    PileModel(Foreseen f, std::vector<double> radius, std::set<std::string> effects)
        : foreseen_(std::move(f)), radius_(std::move(radius)), effects_(std::move(effects)) {}
    rigs::Curves predict(const rigs::World& w, const rigs::Ordinates&) const override {
        const VectorXd all = foreseen_(w);
        const auto n = static_cast<Index>(radius_.size());
        rigs::Curves curves;
        for (std::size_t c = 0; c < Rings::channels().size(); ++c) {
            const VectorXd part = all.segment(static_cast<Index>(c) * n, n);
            curves[Rings::channels()[c]].assign(part.begin(), part.end());
        }
        return curves;
    }
    rigs::Curves variables(const rigs::World&, const rigs::Ordinates& at) const override {
        return {{"r", at.at}};
    }
    std::set<std::string> effects() const override { return effects_; }

  private:
    Foreseen foreseen_;
    std::vector<double> radius_;
    std::set<std::string> effects_;
};

}  // namespace

Piles::Inside::View& Piles::Inside::view_of(const cases::Experiment& e) const {
    auto* self = const_cast<Inside*>(this);  // a view is a cache
    const std::lock_guard lock(guard);
    Scan spots = scan_of(*e.recording);
    const double noise = noise_of_heights(e);
    Apparatus* family = family_of(e);
    for (const auto& v : views)
        if (family != nullptr && v->family == family && v->noise == noise &&
            v->spots.azimuth == spots.azimuth && v->spots.r == spots.r)
            return *v;
    if (family == nullptr) {
        auto other = std::make_unique<Apparatus>();  // without `stated`: never recognised
        for (const auto& known : families) other->softening = known->softening;
        other->experiment = softened(e, other->softening);
        family = other.get();
        self->families.push_back(std::move(other));
    }
    Rings rings(spots, base_radius(e), e.grain.diameter.value.value(), noise);
    auto v = std::make_unique<View>(View{family, std::move(spots), noise, std::move(rings), {}});
    const VectorXd one = v->rings.reduced(v->spots.z, true);
    const auto n = static_cast<Index>(v->rings.count());
    for (const Index c : {Index{0}, Index{3}})
        for (Index k = 0; k < n; ++k)
            if (std::isfinite(one[c * n + k])) v->numbers.moved.push_back(c * n + k);
    for (Index k = 0; k < n; ++k)
        if (std::isfinite(one[n + k]))
            v->numbers.lean.push_back(n + k), v->numbers.across.push_back(2 * n + k);
    v->numbers.knee = 0.5 * e.grain.diameter.value.value();
    v->numbers.tilted = std::any_of(family->axes.begin(), family->axes.end(),
                                    [](const Axis& a) { return a.parameter == "tilt_angle"; });
    if (!family->heaps.empty()) emulate(*v, true);
    self->views.push_back(std::move(v));
    return *self->views.back();
}

void Piles::Inside::add_family(const cases::Experiment& e) {
    auto f = std::make_unique<Apparatus>(pourer.apparatus(e));
    f->axes = free_axes(given, e);
    for (const BulkEffect& effect : bulk_effects(given, e)) {
        f->axes.insert(f->axes.end(), effect.axes.begin(), effect.axes.end());
        if (std::none_of(effects.begin(), effects.end(),
                         [&](const BulkEffect& known) { return known.effect == effect.effect; }))
            effects.push_back(effect);
    }
    pourer.pour_first(*f);
    families.push_back(std::move(f));
}

Piles::Piles(const cases::Case& c, const Settings& s) : in_(std::make_unique<Inside>(c, s)) {
    for (const cases::Experiment& e : c.experiments)
        if (!e.held_out && is_profile(e) && !in_->family_of(e)) in_->add_family(e);
}

Piles::~Piles() = default;

const std::vector<BulkEffect>& Piles::effects() const { return in_->effects; }

bool Piles::knows(const cases::Experiment& e) const { return in_->family_of(e) != nullptr; }

bool Piles::same_apparatus(const cases::Experiment& a, const cases::Experiment& b) const {
    return in_->family_of(a) == in_->family_of(b);
}

Record Piles::record(const cases::Experiment& e) const {
    Inside::View& v = in_->view_of(e);
    std::set<std::string> effects;
    for (const Axis& a : v.family->axes)
        if (!a.effect.empty()) effects.insert(a.effect);
    const Inside* in = in_.get();
    Record r{.experiment = &e,
             .model = std::make_unique<PileModel>(
                 [in, &v](const rigs::World& w) { return in->foreseen(v, w); }, v.rings.radius(),
                 std::move(effects)),
             .ordinates = {v.rings.radius(), {}},
             .ordinate = "r",
             .channels = {},
             .covariance = {}};
    const VectorXd recorded = v.rings.reduced(scan_of(*e.recording).z, true);
    const auto n = static_cast<Index>(v.rings.count());
    MatrixXd about;
    if (v.emulator) {
        // The emulator's error is one for all recordings of the apparatus: each is given it as often as there are recordings.
        double recordings = 0.0;
        for (const cases::Experiment& other : in->given.experiments)
            if (!other.held_out && is_profile(other) && in->family_of(other) == v.family)
                recordings += 1.0;
        const VectorXd like = lifted(recorded, n);
        about = v.emulator->covariance(like) *
                (1.0 + (std::max(1.0, recordings) - 1.0) * v.emulator->share_of_error(like));
    } else {
        const rigs::World stated = rigs::world_of(in->given, e);
        MatrixXd y = in->fresh(v, stated, heaps_of_other);
        const VectorXd mean = y.colwise().mean();
        y.rowwise() -= mean.transpose();
        about =
            (y.cwiseAbs2().colwise().sum() / (heaps_of_other - 1.0) * (1.0 + 1.0 / heaps_of_other))
                .asDiagonal();
    }
    about += v.rings.instrument();
    std::vector<Index> told;
    for (std::size_t c = 0; c < Rings::channels().size(); ++c) {
        const VectorXd part = recorded.segment(static_cast<Index>(c) * n, n);
        double variance = 0.0, count = 0.0;
        for (Index k = 0; k < n; ++k)
            if (std::isfinite(part[k]))
                variance += about(static_cast<Index>(c) * n + k, static_cast<Index>(c) * n + k),
                    count += 1.0;
        if (count == 0.0) continue;
        for (Index k = 0; k < n; ++k) told.push_back(static_cast<Index>(c) * n + k);
        r.channels.push_back({.name = Rings::channels()[c],
                              .recorded = {part.begin(), part.end()},
                              .stated_noise = std::sqrt(variance / count)});
    }
    r.covariance.resize(static_cast<Index>(told.size()), static_cast<Index>(told.size()));
    for (std::size_t a = 0; a < told.size(); ++a)
        for (std::size_t b = 0; b < told.size(); ++b)
            r.covariance(static_cast<Index>(a), static_cast<Index>(b)) = about(told[a], told[b]);
    return r;
}

namespace {

// r' C^-1 r over the numbers that are told.
double distance(const VectorXd& r, const MatrixXd& c, const std::vector<Index>& numbers) {
    const auto n = static_cast<Index>(numbers.size());
    MatrixXd part(n, n);
    VectorXd left(n);
    for (Index a = 0; a < n; ++a) {
        left[a] = r[numbers[static_cast<std::size_t>(a)]];
        for (Index b = 0; b < n; ++b)
            part(a, b) =
                c(numbers[static_cast<std::size_t>(a)], numbers[static_cast<std::size_t>(b)]);
    }
    return left.dot(part.llt().solve(left));
}

}  // namespace

double Piles::learn(const std::vector<Asked>& all, bool last) const {
    double sum = 0.0, count = 0.0;
    for (const auto& family : in_->families) {
        std::vector<rigs::World> worlds;
        for (const Asked& a : all)
            if (in_->family_of(*a.experiment) == family.get()) worlds.push_back(a.world);
        if (worlds.empty()) continue;
        const std::size_t before = family->heaps.size();
        in_->pourer.pour_into(*family, worlds);
        for (const auto& v : in_->views) {
            if (v->family != family.get()) continue;
            for (std::size_t k = before; k < family->heaps.size(); ++k) {
                const VectorXd y = in_->numbers_of(*v, family->heaps[k]);
                sum += distance(y - in_->foreseen(*v, family->worlds[k]),
                                v->emulator->covariance(y), v->numbers.moved);
                count += static_cast<double>(v->numbers.moved.size());
            }
            in_->emulate(*v, last);
        }
    }
    const double off = count > 0.0 ? sum / count : 1.0;
    in_->unseen.push_back(off);
    return off;
}

Piles::Check Piles::confirmed(const std::vector<const Record*>& records, const rigs::World& w,
                              const std::vector<VectorXd>& added, int heaps) const {
    const double many = static_cast<double>(heaps);
    const cases::Experiment& first = *records.front()->experiment;
    const std::vector<rigs::Heap> poured =
        in_->pourer.pour(in_->view_of(first).family->experiment, w, fresh_seeds, heaps);
    Check check{heaps, 1.0, 1.0, 0.0};
    double numbers = 0.0;
    for (std::size_t k = 0; k < records.size(); ++k) {
        const Record* r = records[k];
        Inside::View& v = in_->view_of(*r->experiment);
        const VectorXd bare =
            v.rings.reduced(scan_of(*r->experiment->recording).z, true) - added[k];
        VectorXd mean = VectorXd::Zero(bare.size());
        for (const rigs::Heap& heap : poured) mean += in_->numbers_of(v, heap) / many;
        const double own = v.emulator->share_of_error(bare);
        const MatrixXd one = v.emulator->covariance(bare);
        MatrixXd seeds = one;  // less what is the emulator's error
        seeds(v.numbers.moved, v.numbers.moved) *= 1.0 - own;
        std::vector<Index> all = v.numbers.moved;
        all.insert(all.end(), v.numbers.lean.begin(), v.numbers.lean.end());
        all.insert(all.end(), v.numbers.across.begin(), v.numbers.across.end());
        check.chi_squared +=
            distance(bare - mean, seeds * (1.0 + 1.0 / many) + v.rings.instrument(), all);
        numbers += static_cast<double>(all.size());
        if (k > 0) continue;
        const double off =
            distance(mean - in_->foreseen(v, w), seeds / many + one * own, v.numbers.moved);
        check.emulator = upper_tail(off, static_cast<double>(v.numbers.moved.size()));
    }
    check.recording = upper_tail(check.chi_squared, numbers);
    return check;
}

int Piles::heaps_poured() const { return in_->pourer.poured(); }

double Piles::softening() const {
    double least = 1.0;
    for (const auto& f : in_->families) least = std::min(least, f->softening);
    return least;
}

std::vector<std::string> Piles::words() const {
    std::vector<std::string> list;
    if (in_->families.empty()) return list;
    list.push_back(
        fmt::format("{} heaps were poured to know what others would look like{}.", heaps_poured(),
                    softening() < 1.0
                        ? fmt::format(", with grains {:.2g} times as stiff as stated", softening())
                        : ""));
    for (const auto& f : in_->families)
        if (f->softening < 1.0 && f->moved > 0.0)
            list.push_back(fmt::format(
                "So soft they move the profile of {} by {:.2f} of the scatter between heaps; up to "
                "0.5 is allowed.",
                f->experiment.id, f->moved));
    double own = 0.0;
    for (const cases::Experiment& e : in_->given.experiments) {
        if (e.held_out || !is_profile(e)) continue;
        const Inside::View& v = in_->view_of(e);
        const VectorXd recorded = v.rings.reduced(scan_of(*e.recording).z, true);
        own = std::max(
            own, v.emulator->share_of_error(lifted(recorded, static_cast<Index>(v.rings.count()))));
    }
    if (!in_->unseen.empty())
        list.push_back(fmt::format(
            "Heaps that the emulator had not seen were off by {:.2f} of the scatter that it had "
            "foreseen (root mean square; 1 where it is right). Up to {:.0f} % of a recording's "
            "variance is the emulator's own error.",
            std::sqrt(in_->unseen.back()), 100.0 * own));
    return list;
}

bool has_piles(const cases::Case& c) {
    return std::any_of(c.experiments.begin(), c.experiments.end(),
                       [](const auto& e) { return e.held_out ? e.rig == "pile" : is_profile(e); });
}

}  // namespace diagnose
