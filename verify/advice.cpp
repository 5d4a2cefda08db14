// SPDX-License-Identifier: MIT
#include "verify/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

constexpr double alike = 1.001;  // ratio of two numbers of the plan that are the same

bool is_angle(const MapQuantity& q) { return q.name.rfind("angle_", 0) == 0; }

AngleSays says_of(double low, double high, double tolerance) {
    if (low >= -tolerance && high <= tolerance) return AngleSays::within;
    return low > tolerance || high < -tolerance ? AngleSays::beyond : AngleSays::not_decided;
}

AngleSays worse(AngleSays a, AngleSays b) {
    for (const AngleSays s : {AngleSays::beyond, AngleSays::not_decided})
        if (a == s || b == s) return s;
    return AngleSays::within;
}

void add_cell(MapReading& r, const MapCell& c, double tolerance, bool first) {
    r.cells.push_back(
        fmt::format("{}, {}, Bond {:g}, factor {:g}", c.study, c.rule, c.bond, c.factor));
    bool any = false;
    AngleSays says = AngleSays::within;
    for (const MapQuantity& q : c.quantities) {
        if (q.verdict == MapVerdict::breaks &&
            std::find(r.lost.begin(), r.lost.end(), q.name) == r.lost.end())
            r.lost.push_back(q.name);
        if (!is_angle(q) || !std::isfinite(q.interval.low + q.interval.high)) continue;
        any = true;
        says = worse(says, says_of(q.interval.low, q.interval.high, tolerance));
        r.low = r.spread ? std::min(r.low, q.interval.low) : q.interval.low;
        r.high = r.spread ? std::max(r.high, q.interval.high) : q.interval.high;
        const double sd = std::max(q.reference.standard_deviation, q.scaled.standard_deviation);
        r.spread = std::max(r.spread.value_or(0.0), sd);
    }
    if (!any) says = AngleSays::not_decided;
    // Heaps on one side alone: no angle says more.
    if (c.verdict == MapVerdict::breaks && c.reference.formed != c.reference.heaps &&
        c.reference.formed == 0)
        says = AngleSays::not_decided;
    if (c.verdict == MapVerdict::breaks && c.reference.formed > 0 && c.scaled.formed == 0)
        says = AngleSays::beyond;
    r.says = first ? says : worse(r.says, says);
}

std::vector<const MapCell*> cells_of(const ScalingMap& map, const char* study,
                                     const std::string& rule) {
    std::vector<const MapCell*> list;
    for (const MapCell& c : map.cells)
        if (c.study == study && c.rule == rule && c.verdict != MapVerdict::not_poured)
            list.push_back(&c);
    return list;
}

// The numbers of `held` next to `wanted`, below and above; one where it is met.
std::vector<double> beside(std::vector<double> held, double wanted) {
    std::sort(held.begin(), held.end());
    held.erase(std::unique(held.begin(), held.end()), held.end());
    std::vector<double> two;
    for (const double v : held) {
        if (v <= wanted * alike) two.assign(1, v);
        if (v > wanted * alike) {
            two.push_back(v);
            break;
        }
    }
    if (!two.empty() && two.front() * alike >= wanted && two.front() <= wanted * alike)
        two.resize(1);
    return two;
}

}  // namespace

const char* to_string(AngleSays s) {
    return s == AngleSays::within ? "within" : s == AngleSays::beyond ? "beyond" : "not decided";
}

const std::vector<CoarseRule>& coarse_rules() {
    static const std::vector<CoarseRule> all{
        {"stress_bond", 1.0}, {"cohesion_number", 1.6}, {"weight_bond", 2.0}, {"none", 0.0}};
    return all;
}

std::optional<double> finest_size_ratio(const ScalingMap& map) {
    std::optional<double> finest;
    for (const MapCell& c : map.cells)
        if (c.study == "coarse_graining" && c.verdict != MapVerdict::not_poured)
            finest = std::max(finest.value_or(0.0), c.reference.size_ratio);
    return finest;
}

MapReading read_coarse(const ScalingMap& map, const PowderGroups& powder, const std::string& rule,
                       double h, double tolerance) {
    MapReading r;
    const std::optional<double> finest = finest_size_ratio(map);
    const auto known = std::find_if(coarse_rules().begin(), coarse_rules().end(),
                                    [&](const CoarseRule& c) { return rule == c.name; });
    const double factor = finest ? h * *finest / powder.size_ratio : 0.0;
    const double to_reference = finest ? powder.size_ratio / *finest : 1.0;
    const double bond = powder.bond * std::pow(to_reference, known->exponent - 2.0);
    const std::string of_powder = powder.bond > 0.0 ? rule : "none";
    std::vector<const MapCell*> cells = cells_of(map, "coarse_graining", of_powder);
    if (powder.bond == 0.0 && cells.empty())
        cells = cells_of(map, "coarse_graining", "stress_bond");
    if (cells.empty()) {
        r.outside.push_back("the map holds no coarse-graining by " + of_powder);
        return r;
    }
    if (to_reference > alike)
        r.outside.push_back(
            fmt::format("the map begins at a base {:g} grains wide; from the powder's {:.3g} to "
                        "there ({:.3g} times "
                        "larger grains) it says nothing",
                        *finest, powder.size_ratio, to_reference));
    std::vector<double> bonds, factors;
    for (const MapCell* c : cells) bonds.push_back(c->bond), factors.push_back(c->factor);
    const std::vector<double> near = beside(bonds, bond);
    const double strongest = *std::max_element(bonds.begin(), bonds.end());
    if (bond > strongest * alike)
        r.outside.push_back(
            fmt::format("a Bond number of {:.3g} at the map's reference grain, above "
                        "its largest, {:g}",
                        bond, strongest));
    if (factor <= 1.0 * alike) {
        // As fine as the reference or finer: within the map nothing is lost.
        r.says = AngleSays::within;
        if (factor < 1.0 / alike)
            r.outside.push_back(fmt::format(
                "a base {:.3g} grains wide is finer than all of the map", powder.size_ratio / h));
        return r;
    }
    const double coarsest = *std::max_element(factors.begin(), factors.end());
    if (factor > coarsest * alike) {
        r.outside.push_back(
            fmt::format("a base {:.3g} grains wide is coarser than all of the map ({:.3g})",
                        powder.size_ratio / h, *finest / coarsest));
        return r;
    }
    bool first = true;
    for (const double b : near) {
        const MapCell* next = nullptr;
        for (const MapCell* c : cells)
            if (c->bond == b && c->factor * alike >= factor && (!next || c->factor < next->factor))
                next = c;
        if (next) add_cell(r, *next, tolerance, first), first = false;
    }
    return r;
}

std::optional<double> modulus_of_map(const ScalingMap& map) {
    const std::optional<double> finest = finest_size_ratio(map);
    for (const MapCell& c : map.cells)
        if (c.study == "coarse_graining" && c.reference.size_ratio == *finest)
            return c.reference.elasticity;
    return std::nullopt;
}

MapReading read_softening(const ScalingMap& map, double from, double to, double bond,
                          double tolerance) {
    MapReading r;
    const MapCell* next = nullptr;  // as soft as that, from the stiffest
    for (const MapCell* c : cells_of(map, "softening", "pull_off"))
        if (c->scaled.elasticity <= to * alike &&
            (!next || c->scaled.elasticity > next->scaled.elasticity))
            next = c;
    if (!next) {
        r.says = AngleSays::within;
        r.outside.push_back(
            fmt::format("the map holds no modulus as soft as E/(rho g d) = {:.3g}", to));
        return r;
    }
    add_cell(r, *next, tolerance, true);
    constexpr double near = 3.2;  // half a decade
    if (from > near * next->reference.elasticity)
        r.outside.push_back(
            fmt::format("its softening begins at E/(rho g d) = {:.3g}, this grain's is {:.3g}",
                        next->reference.elasticity, from));
    if (bond > near * next->bond || bond * near < next->bond)
        r.outside.push_back(
            fmt::format("soft moduli were tried at F_po/(m g) = {:g}, this grain has {:.3g}",
                        next->bond, bond));
    return r;
}

AngleSays AdvisedGrain::says() const {
    return soft.cells.empty() ? coarse.says : worse(coarse.says, soft.says);
}

std::optional<std::size_t> choose(const std::vector<AdvisedGrain>& list) {
    const auto widest = [](const AdvisedGrain& g) {
        return std::max(-g.coarse.low, g.coarse.high);
    };
    for (const AngleSays says : {AngleSays::within, AngleSays::not_decided}) {
        std::optional<std::size_t> best;
        for (std::size_t k = 0; k < list.size(); ++k) {
            const AdvisedGrain& g = list[k];
            if (!g.affordable || !g.unusable.empty() || g.says() != says) continue;
            if (!best || g.h < list[*best].h / alike ||
                (g.h <= list[*best].h * alike && widest(g) < widest(list[*best])))
                best = k;
        }
        if (best) return best;
    }
    return std::nullopt;
}

}  // namespace verify
