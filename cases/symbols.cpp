// SPDX-License-Identifier: MIT
#include "cases/symbols.hpp"

#include <udunits2.h>

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace cases {
namespace {

struct Prefix {
    std::string_view symbol, name;
    double factor;
};
constexpr std::array<Prefix, 16> prefixes{{{"da", "deca", 1e1},
                                           {"h", "hecto", 1e2},
                                           {"k", "kilo", 1e3},
                                           {"M", "mega", 1e6},
                                           {"G", "giga", 1e9},
                                           {"T", "tera", 1e12},
                                           {"P", "peta", 1e15},
                                           {"E", "exa", 1e18},
                                           {"d", "deci", 1e-1},
                                           {"c", "centi", 1e-2},
                                           {"m", "milli", 1e-3},
                                           {"u", "micro", 1e-6},
                                           {"n", "nano", 1e-9},
                                           {"p", "pico", 1e-12},
                                           {"f", "femto", 1e-15},
                                           {"a", "atto", 1e-18}}};

// Symbols in daily use that udunits2 knows by another name only.
constexpr std::array<std::pair<std::string_view, const char*>, 5> aliases{
    {{"deg", "degree"}, {"P", "poise"}, {"dyn", "dyne"}, {"bar", "bar"}, {"rev", "revolution"}}};

struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
using UnitPointer = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeSystem {
    void operator()(ut_system* system) const { ut_free_system(system); }
};
using SystemPointer = std::unique_ptr<ut_system, FreeSystem>;

// What the visitor has gathered from one unit.
struct Gathered {
    Unit unit{};
    scaling::Rational mass{0}, length{0}, time{0};
    bool mechanical = true;
};

void gather_base(const ut_unit* base, int power, Gathered& g) {
    const char* symbol = ut_get_symbol(base, UT_ASCII);
    const std::string_view s = symbol == nullptr ? "" : symbol;
    if (s == "kg") {
        g.mass += power;
    } else if (s == "m") {
        g.length += power;
    } else if (s == "s") {
        g.time += power;
    } else if (s == "A") {
        g.unit.current += power;
    } else if (s == "rad") {
        g.unit.angle += power;
    } else {
        g.mechanical = false;
    }
}

ut_status visit_basic(const ut_unit* unit, void* gathered) {
    gather_base(unit, 1, *static_cast<Gathered*>(gathered));
    return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* bases, const int* powers,
                        void* gathered) {
    for (int i = 0; i < count; ++i)
        gather_base(bases[i], powers[i], *static_cast<Gathered*>(gathered));
    return UT_SUCCESS;
}

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset,
                         void* gathered);

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* gathered) {
    static_cast<Gathered*>(gathered)->mechanical = false;
    return UT_SUCCESS;
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* gathered) {
    static_cast<Gathered*>(gathered)->mechanical = false;
    return UT_SUCCESS;
}

constexpr ut_visitor visitor{visit_basic, visit_product, visit_galilean, visit_timestamp,
                             visit_logarithmic};

ut_status visit_galilean(const ut_unit*, double scale, const ut_unit* underlying, double offset,
                         void* gathered) {
    Gathered& g = *static_cast<Gathered*>(gathered);
    g.unit.factor *= scale;
    if (offset != 0.0) g.mechanical = false;
    return ut_accept_visitor(underlying, &visitor, gathered);
}

// udunits2 keeps its status and its handler in globals of its own, so one lock guards every call.
class Dictionary {
  public:
    Dictionary() {
        ut_set_error_message_handler(ut_ignore);
        system_.reset(ut_read_xml(nullptr));
        if (!system_)
            throw std::runtime_error(
                "the database of udunits2 cannot be read (Debian: libudunits2-data)");
    }

    std::optional<Unit> find(const std::string& symbol) {
        const std::lock_guard lock(mutex_);
        if (symbol == "grain" || symbol == "grains" || symbol == "particle" ||
            symbol == "particles")
            return Unit{};
        if (const UnitPointer unit = by_symbol(symbol)) return gathered(*unit, 1.0);
        if (const UnitPointer unit = by_name(symbol)) return gathered(*unit, 1.0);
        for (const Prefix& prefix : prefixes) {
            if (symbol.starts_with(prefix.symbol)) {
                const UnitPointer unit = by_symbol(symbol.substr(prefix.symbol.size()));
                if (unit) return gathered(*unit, prefix.factor);
            }
            if (symbol.starts_with(prefix.name)) {
                const UnitPointer unit = by_name(symbol.substr(prefix.name.size()));
                if (unit) return gathered(*unit, prefix.factor);
            }
        }
        return std::nullopt;
    }

  private:
    UnitPointer by_symbol(const std::string& symbol) const {
        for (const auto& [alias, name] : aliases) {
            if (symbol == alias) return by_name(name);
        }
        return UnitPointer(ut_get_unit_by_symbol(system_.get(), symbol.c_str()));
    }
    UnitPointer by_name(const std::string& name) const {
        return UnitPointer(ut_get_unit_by_name(system_.get(), name.c_str()));
    }

    static std::optional<Unit> gathered(const ut_unit& unit, double factor) {
        Gathered g;
        if (ut_accept_visitor(&unit, &visitor, &g) != UT_SUCCESS || !g.mechanical)
            return std::nullopt;
        g.unit.factor *= factor;
        g.unit.dimension = scaling::Dimension{g.mass, g.length, g.time};
        return g.unit;
    }

    std::mutex mutex_;
    SystemPointer system_;
};

}  // namespace

std::optional<Unit> find_symbol(const std::string& symbol) {
    static Dictionary dictionary;
    std::optional<Unit> unit = dictionary.find(symbol);
    if (unit) {
        unit->text = symbol;
        unit->counts_cycles = symbol.ends_with("Hz") || symbol.ends_with("hertz");
    }
    return unit;
}

}  // namespace cases
