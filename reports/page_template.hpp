// SPDX-License-Identifier: MIT
#pragma once

namespace reports {

// reports/page.mustache, as it was when the program was built.
const char* page_template();

}  // namespace reports
