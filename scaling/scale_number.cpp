// SPDX-License-Identifier: MIT
#include "scaling/scale_number.hpp"

#include "scaling/errors.hpp"

namespace scaling {

namespace {

ScaleNumber classified(double value) {
    if (value < 1e2) return {value, SizeClass::micro};
    return {value, value > 1e3 ? SizeClass::macro : SizeClass::meso};
}

}  // namespace

const char* to_string(SizeClass size_class) {
    switch (size_class) {
        case SizeClass::micro:
            return "micro";
        case SizeClass::meso:
            return "meso";
        case SizeClass::macro:
            return "macro";
    }
    return "";
}

ScaleNumber scale_number(Length apparatus, Length grain_diameter) {
    const bool positive = apparatus.value() > 0.0 && grain_diameter.value() > 0.0;
    if (!positive) {
        throw InvalidParameter(mistake("scale_number",
                                       std::to_string(apparatus.value()) + " m over " +
                                           std::to_string(grain_diameter.value()) + " m",
                                       "both lengths must be > 0",
                                       "D is the outlet, or else the base"));
    }
    return classified(Dimensionless(2.0 * apparatus / grain_diameter).value());
}

ScaleNumber scaled_scale_number(Length apparatus, Length grain_diameter, const ScaleMap& map) {
    // From exact exponents, so that a similar apparatus keeps its number to the last bit.
    const double ratio = map.value(map.exponents("apparatus_length") - map.exponents("length"));
    return classified(scale_number(apparatus, grain_diameter).value * ratio);
}

}  // namespace scaling
