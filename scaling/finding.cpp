// SPDX-License-Identifier: MIT
#include "scaling/finding.hpp"

namespace scaling {

const char* to_string(Judgement judgement) {
    switch (judgement) {
        case Judgement::fine:
            return "fine";
        case Judgement::caution:
            return "caution";
        case Judgement::unusable:
            return "unusable";
    }
    return "";
}

}  // namespace scaling
