// SPDX-License-Identifier: MIT
#include "diagnose/verdict.hpp"

namespace diagnose {

const char* to_string(Answer answer) {
    switch (answer) {
        case Answer::consistent:
            return "consistent";
        case Answer::explained:
            return "explained";
        case Answer::ambiguous:
            return "ambiguous";
        case Answer::unexplained:
            return "unexplained";
        case Answer::undecided:
            return "undecided";
    }
    return "";
}

const char* to_string(GateResult result) {
    switch (result) {
        case GateResult::passed:
            return "passed";
        case GateResult::failed:
            return "failed";
        case GateResult::untestable:
            return "untestable";
    }
    return "";
}

}  // namespace diagnose
