// SPDX-License-Identifier: MIT
#include "scaling/pi_groups.hpp"

#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <algorithm>
#include <cmath>

namespace scaling {

namespace {

const Variable* find(const std::string& name, const std::vector<Variable>& variables) {
    const auto found = std::find_if(variables.begin(), variables.end(),
                                    [&](const Variable& v) { return v.name == name; });
    return found == variables.end() ? nullptr : &*found;
}

const Variable& required(const std::string& name, const std::vector<Variable>& variables) {
    if (const Variable* found = find(name, variables)) return *found;
    std::vector<std::string> names;
    for (const Variable& v : variables) names.push_back(v.name);
    throw InvalidParameter(mistake("group", '"' + name + '"',
                                   "must be one of the variables " + joined(names),
                                   "give its value, or leave the group out"));
}

Row dimension_column(const Variable& v) {
    const Dimension d = named_quantity(v.quantity).dimension;
    return {d.mass, d.length, d.time};
}

// Exponents of the variables, zero where the group has none; shape [variables]. Its variables must
// all be there.
Row exponents_of(const PiGroup& group, const std::vector<Variable>& variables) {
    Row row(variables.size(), Rational(0));
    for (const Power& p : group.powers) {
        row[static_cast<std::size_t>(&required(p.name, variables) - variables.data())] +=
            p.exponent;
    }
    return row;
}

bool has_all(const PiGroup& group, const std::vector<Variable>& variables) {
    return std::all_of(group.powers.begin(), group.powers.end(),
                       [&](const Power& p) { return find(p.name, variables) != nullptr; });
}

// Keeps the rows that are independent of all before them.
bool independent(RationalSystem& seen, const Row& row) {
    return seen.add(row, {}) == RationalSystem::Outcome::added;
}

std::string product(const std::vector<Power>& powers, int sign) {
    std::string text;
    for (const Power& p : powers) {
        const Rational exponent = Rational(sign) * p.exponent;
        if (exponent.numerator() <= 0) continue;
        text += (text.empty() ? "" : " ") + p.name;
        if (exponent != Rational(1)) text += '^' + to_string(exponent);
    }
    return text;
}

PiGroup unnamed(const Row& exponents, const std::vector<Variable>& variables) {
    PiGroup group;
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        if (!is_zero(exponents[k])) group.powers.push_back({variables[k].name, exponents[k]});
    }
    const std::string above = product(group.powers, 1), below = product(group.powers, -1);
    group.formula = above.empty() ? "1" : above;
    if (!below.empty())
        group.formula += " / " + (below.find(' ') == std::string::npos ? below : '(' + below + ')');
    group.name = group.formula;
    return group;
}

}  // namespace

std::vector<PiGroup> pi_basis(const std::vector<Variable>& variables,
                              const std::vector<PiGroup>& named) {
    std::vector<Row> columns;
    for (const Variable& v : variables) columns.push_back(dimension_column(v));
    std::vector<PiGroup> basis;
    for (const Row& exponents : nullspace(columns)) {
        const auto same = std::find_if(named.begin(), named.end(), [&](const PiGroup& g) {
            if (!has_all(g, variables)) return false;
            RationalSystem line;
            line.add(exponents, {});
            return !independent(line, exponents_of(g, variables));
        });
        basis.push_back(same != named.end() ? *same : unnamed(exponents, variables));
    }
    return basis;
}

std::vector<PiGroup> groups_of(const std::vector<Variable>& variables,
                               const std::vector<PiGroup>& named) {
    std::vector<PiGroup> groups;
    RationalSystem seen;
    for (const PiGroup& g : named) {
        if (!has_all(g, variables)) continue;
        independent(seen, exponents_of(g, variables));
        groups.push_back(g);
    }
    for (const PiGroup& g : pi_basis(variables, named)) {
        if (independent(seen, exponents_of(g, variables))) groups.push_back(g);
    }
    return groups;
}

double value_of(const PiGroup& group, const std::vector<Variable>& variables) {
    double value = group.prefactor;
    for (const Power& p : group.powers)
        value *= power_of(required(p.name, variables).value, p.exponent);
    return value;
}

Dimension dimension_of(const PiGroup& group, const std::vector<Variable>& variables) {
    Dimension sum;
    for (const Power& p : group.powers) {
        sum =
            sum * power(named_quantity(required(p.name, variables).quantity).dimension, p.exponent);
    }
    return sum;
}

Exponents change_of(const PiGroup& group, const std::vector<Variable>& variables,
                    const ScaleMap& map) {
    Exponents sum;
    for (const Power& p : group.powers) {
        sum = sum + p.exponent * map.exponents(required(p.name, variables).quantity);
    }
    return sum;
}

std::string dimension_proof(const PiGroup& group, const std::vector<Variable>& variables) {
    std::string text;
    for (const Power& p : group.powers) {
        const Dimension d = named_quantity(required(p.name, variables).quantity).dimension;
        text += '[' + to_string(d) + ']' +
                (p.exponent == Rational(1) ? "" : '^' + to_string(p.exponent)) + ' ';
    }
    return text + "= " + to_string(dimension_of(group, variables));
}

std::vector<GroupChange> compare_groups(const std::vector<PiGroup>& groups,
                                        const std::vector<Variable>& variables,
                                        const ScaleMap& map) {
    std::vector<GroupChange> changes;
    for (const PiGroup& g : groups) {
        const Exponents change = change_of(g, variables, map);
        const double original = value_of(g, variables), ratio = map.value(change);
        changes.push_back({g, original, original * ratio, ratio, change, ratio == 1.0});
    }
    return changes;
}

}  // namespace scaling
