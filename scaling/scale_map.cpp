// SPDX-License-Identifier: MIT
#include "scaling/scale_map.hpp"

#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scaling {

namespace {

// The unknowns: logarithms of the factors of grain length, apparatus length, density, time, contact
// time.
enum Unknown : std::size_t {
    grain_length,
    apparatus_length,
    density,
    flow_time,
    contact_time,
    unknowns
};

Row unit_row(Unknown u) {
    Row row(unknowns, Rational(0));
    row[u] = Rational(1);
    return row;
}

Row difference_row(Unknown a, Unknown b) { return unit_row(a) + Rational(-1) * unit_row(b); }

// The factor's logarithm as a sum over the unknowns: M^m L^l T^t = rho^m L^(l + 3m) T^t.
Row row_of(const NamedQuantity& quantity) {
    Row row(unknowns, Rational(0));
    if (quantity.side == Side::both) {
        for (const Power& p : quantity.product)
            row = row + p.exponent * row_of(named_quantity(p.name));
        return row;
    }
    const bool grain = quantity.side == Side::grain;
    row[grain ? grain_length : apparatus_length] =
        quantity.dimension.length + Rational(3) * quantity.dimension.mass;
    row[density] = quantity.dimension.mass;
    row[grain ? contact_time : flow_time] = quantity.dimension.time;
    return row;
}

Row row_of(const std::string& name) { return row_of(named_quantity(name)); }

const Exponents h_itself{Rational(1), Rational(0)};

RationalSystem one_ruler_one_clock() {
    RationalSystem system;
    system.add(unit_row(grain_length), h_itself);
    system.add(difference_row(apparatus_length, grain_length), {});
    system.add(difference_row(contact_time, flow_time), {});
    return system;
}

bool is_modulus(const std::string& name) {
    return name == "youngs_modulus" || name == "shear_modulus";
}
bool is_adhesion(const std::string& name) {
    return name == "surface_energy" || name == "work_of_adhesion";
}

std::string text_of(const std::vector<Demand>& demands) {
    std::vector<std::string> parts;
    for (const Demand& d : demands) parts.push_back(d.quantity + " " + to_string(d.exponents));
    return parts.empty() ? "nothing kept" : joined(parts);
}

RationalSystem::Outcome add_all(RationalSystem& system, const std::vector<Demand>& demands) {
    for (const Demand& d : demands) {
        if (system.add(row_of(d.quantity), d.exponents) == RationalSystem::Outcome::conflicting) {
            return RationalSystem::Outcome::conflicting;
        }
    }
    return RationalSystem::Outcome::added;
}

// The smallest conflicting subset, the first of equals. Density and time are all that is free, so
// three suffice.
std::vector<Demand> fewest_conflicting(const std::vector<Demand>& demands) {
    for (std::size_t size = 1; size <= 3; ++size) {
        std::vector<bool> chosen(demands.size(), false);
        std::fill_n(chosen.begin(), std::min(size, demands.size()), true);
        do {
            std::vector<Demand> subset;
            for (std::size_t i = 0; i < demands.size(); ++i) {
                if (chosen[i]) subset.push_back(demands[i]);
            }
            RationalSystem system = one_ruler_one_clock();
            if (add_all(system, subset) == RationalSystem::Outcome::conflicting) return subset;
        } while (std::prev_permutation(chosen.begin(), chosen.end()));
    }
    return demands;
}

[[noreturn]] void refuse_conflict(const std::vector<Demand>& demands) {
    std::vector<Demand> conflict = fewest_conflicting(demands);
    const Demand last = conflict.back();
    conflict.pop_back();
    RationalSystem system = one_ruler_one_clock();
    add_all(system, conflict);
    const std::string forced = to_string(*system.value_of(row_of(last.quantity)));
    const std::string cause = "length h" + (conflict.empty() ? "" : ", " + text_of(conflict));
    throw InvalidParameter(
        mistake("kept", cause + " and " + last.quantity + " " + to_string(last.exponents),
                "the former force " + last.quantity + " " + forced,
                "leave one of them out, or ask for a distorted map (--distorted), which says "
                "which groups break and by how much"));
}

[[noreturn]] void refuse_undetermined(const RationalSystem& system,
                                      const std::vector<Demand>& demands) {
    std::vector<std::string> free, remedies;
    for (const char* base : {"density", "apparatus_length", "time", "contact_time"}) {
        if (!system.value_of(row_of(base))) free.emplace_back(base);
    }
    for (const NamedQuantity& q : quantity_table()) {
        if (!system.value_of(row_of(q))) remedies.push_back(q.name);
    }
    const std::string missing = std::to_string(unknowns - system.rank());
    throw InvalidParameter(mistake(
        "kept", text_of(demands), "must settle every factor, but still free: " + joined(free),
        "keep " + missing + " more, independent, of: " + joined(remedies)));
}

void check_positive(const char* what, double value) {
    if (value > 0.0 && std::isfinite(value)) return;
    throw InvalidParameter(mistake(what, std::to_string(value), "must be > 0 and finite",
                                   "model over original, for example 200"));
}

}  // namespace

double power_of(double base, const Rational& exponent) {
    int binary_exponent = 0;
    if (std::frexp(base, &binary_exponent) == 0.5) {
        const Rational power = Rational(binary_exponent - 1) * exponent;
        if (power.denominator() == 1) return std::ldexp(1.0, power.numerator());
    }
    return std::pow(base, boost::rational_cast<double>(exponent));
}

std::string to_string(const Exponents& e) {
    std::vector<std::string> parts;
    const auto append = [&](const char* base, const Rational& exponent) {
        if (is_zero(exponent)) return;
        parts.push_back(exponent == Rational(1) ? base
                                                : fmt::format("{}^{}", base, to_string(exponent)));
    };
    append("h", e.h);
    append("(E'/E)", e.softening);
    return parts.empty() ? "1" : fmt::format("{}", fmt::join(parts, " "));
}

ScaleMap ScaleMap::solve(const Scheme& scheme, double h, double softening) {
    check_positive("h", h);
    check_positive("softening", softening);
    Scheme asked = scheme;
    bool modulus_demanded = false;
    for (Demand& d : asked.demands) {
        if (d.quantity == "length" && !(d.exponents == h_itself)) {
            throw InvalidParameter(mistake("kept", "length " + to_string(d.exponents),
                                           "length is the grain's and scales with h by definition",
                                           "to keep the apparatus, keep apparatus_length"));
        }
        if (!is_modulus(d.quantity)) continue;
        if (softening != 1.0) d.exponents.softening = Rational(1);
        modulus_demanded = true;
    }
    ScaleMap map(h, softening);
    map.settle(asked);
    if (softening != 1.0 && !modulus_demanded) {
        const Exponents modulus = map.exponents("youngs_modulus");
        if (!asked.distorted) {
            throw InvalidParameter(mistake(
                "softening", std::to_string(softening),
                "must be 1 where the kept quantities force youngs_modulus " + to_string(modulus),
                "keep youngs_modulus instead of one of them, or ask for a distorted map "
                "(--distorted)"));
        }
        asked.demands.push_back({"youngs_modulus", modulus + Exponents{Rational(0), Rational(1)}});
        map = ScaleMap(h, softening);
        map.settle(asked);
    }
    return map;
}

void ScaleMap::settle(const Scheme& scheme) {
    RationalSystem system;
    if (scheme.distorted) {
        system.add(unit_row(grain_length), h_itself);
        for (const Demand& d : scheme.demands) {
            const auto outcome = system.add(row_of(d.quantity), d.exponents);
            if (outcome == RationalSystem::Outcome::conflicting) impose(d.quantity, d.exponents);
        }
        // Ties that hold unless a demand broke them; two rulers with one clock would be no physics.
        system.add(difference_row(apparatus_length, grain_length), {});
        if (system.value_of(difference_row(apparatus_length, grain_length)) == Exponents{}) {
            system.add(difference_row(contact_time, flow_time), {});
        }
    } else {
        system = one_ruler_one_clock();
        if (add_all(system, scheme.demands) == RationalSystem::Outcome::conflicting) {
            refuse_conflict(scheme.demands);
        }
    }
    if (system.rank() < unknowns) refuse_undetermined(system, scheme.demands);
    const auto solved = [&](Unknown u) { return *system.value_of(unit_row(u)); };
    bases_ = {solved(grain_length), solved(apparatus_length), solved(density), solved(flow_time),
              solved(contact_time)};
    adhesion_demanded_ = std::any_of(scheme.demands.begin(), scheme.demands.end(),
                                     [](const Demand& d) { return is_adhesion(d.quantity); });
}

Exponents ScaleMap::exponents(const std::string& quantity) const {
    if (const auto own = imposed_.find(quantity); own != imposed_.end()) return own->second;
    const Row row = row_of(quantity);
    return row[grain_length] * bases_.grain_length +
           row[apparatus_length] * bases_.apparatus_length + row[density] * bases_.density +
           row[flow_time] * bases_.time + row[contact_time] * bases_.contact_time;
}

double ScaleMap::value(const Exponents& e) const {
    return power_of(h_, e.h) * power_of(softening_, e.softening);
}

bool ScaleMap::distorted() const {
    return !imposed_.empty() || !(bases_.grain_length == bases_.apparatus_length) ||
           !(bases_.time == bases_.contact_time);
}

bool ScaleMap::exact_in_binary() const {
    const auto is_power_of_two = [](double base, const Rational& exponent) {
        int binary_exponent = 0;
        if (is_zero(exponent)) return true;
        return std::frexp(base, &binary_exponent) == 0.5 &&
               (Rational(binary_exponent - 1) * exponent).denominator() == 1;
    };
    return std::all_of(
        quantity_table().begin(), quantity_table().end(), [&](const NamedQuantity& q) {
            const Exponents e = exponents(q.name);
            return is_power_of_two(h_, e.h) && is_power_of_two(softening_, e.softening);
        });
}

ScaleMap ScaleMap::with_imposed(const std::string& quantity, const Exponents& e) const {
    ScaleMap map = *this;
    map.impose(quantity, e);
    return map;
}

void ScaleMap::impose(const std::string& quantity, const Exponents& e) {
    imposed_[named_quantity(quantity).name] = e;
    if (is_adhesion(quantity)) imposed_["surface_energy"] = imposed_["work_of_adhesion"] = e;
}

}  // namespace scaling
