// SPDX-License-Identifier: MIT
#include "scaling/schemes.hpp"

#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"
#include "scaling/quantity_table.hpp"

#include <algorithm>

namespace scaling {

Demand demand_from(const std::string& text) {
    const auto equals = text.find('=');
    const std::string& quantity = named_quantity(text.substr(0, equals)).name;
    if (equals == std::string::npos) return {quantity, {}};
    return {quantity, {rational_from(text.substr(equals + 1), "kept " + quantity), Rational(0)}};
}

const std::vector<std::string>& scheme_names() {
    static const std::vector<std::string> names = {
        "exact", "kept_gravity", "kept_gravity_kept_modulus", "paper", "coarse_grain"};
    return names;
}

Scheme named_scheme(const std::string& name) {
    const auto scheme = [&](const std::vector<std::string>& kept, bool distorted) {
        Scheme made = own_scheme(kept, distorted);
        made.name = name;
        return made;
    };
    if (name == "exact") return scheme({"density", "youngs_modulus"}, false);
    if (name == "kept_gravity") return scheme({"density", "gravity"}, false);
    if (name == "kept_gravity_kept_modulus") return scheme({"gravity", "youngs_modulus"}, false);
    if (name == "paper" || name == "coarse_grain") {
        return scheme({"density", "gravity", "youngs_modulus", "apparatus_length"}, true);
    }
    throw InvalidParameter(mistake("scheme", '"' + name + '"',
                                   "must be one of " + joined(scheme_names()),
                                   "did you mean " + nearest_name(name, scheme_names()) +
                                       "? or name the kept quantities yourself"));
}

Scheme with_scaled_apparatus(Scheme scheme) {
    std::erase_if(scheme.demands, [](const Demand& d) { return d.quantity == "apparatus_length"; });
    return scheme;
}

Scheme own_scheme(const std::vector<std::string>& kept, bool distorted) {
    Scheme scheme{"own", {}, distorted};
    for (const std::string& text : kept) scheme.demands.push_back(demand_from(text));
    return scheme;
}

}  // namespace scaling
