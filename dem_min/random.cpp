// SPDX-License-Identifier: MIT
#include "dem_min/random.hpp"

#include <Random123/philox.h>

namespace dem_min {

double RandomStream::uniform(std::uint64_t index) const {
    using Generator = r123::Philox4x32;
    const auto low = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
    const auto high = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); };
    const Generator::ctr_type counter{{low(index), high(index), low(stream), high(stream)}};
    const Generator::key_type key{{low(seed), high(seed)}};
    const Generator::ctr_type out = Generator{}(counter, key);
    const std::uint64_t bits = (static_cast<std::uint64_t>(out[0]) << 32) | out[1];
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace dem_min
