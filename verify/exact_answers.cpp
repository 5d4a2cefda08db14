// SPDX-License-Identifier: MIT
#include "verify/exact_answers.hpp"

#include <iterator>

namespace verify {

std::vector<Check> exact_answers() {
    std::vector<Check> all;
    for (std::vector<Check>& part :
         std::vector<std::vector<Check>>{impact_answers(), adhesion_answers(), friction_answers(),
                                         flight_and_rolling_answers(), surroundings_answers()})
        all.insert(all.end(), std::make_move_iterator(part.begin()),
                   std::make_move_iterator(part.end()));
    return all;
}

}  // namespace verify
