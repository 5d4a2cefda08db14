// SPDX-License-Identifier: MIT
#include "scaling/errors.hpp"

namespace scaling {

std::string mistake(const std::string& where, const std::string& value, const std::string& rule,
                    const std::string& remedy) {
    return where + ": got " + value + ", " + rule + " (" + remedy + ")";
}

}  // namespace scaling
