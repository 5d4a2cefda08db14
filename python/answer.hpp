// SPDX-License-Identifier: MIT
// One answer as Python gets it: the JSON of the command line as a dict, its text, its page.
#pragma once

#include "reports/json.hpp"
#include "reports/page.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <pybind11/pybind11.h>
#include <string>

namespace python {

struct Answer {
    reports::Json json;
    std::string text;                     // as the command line prints it
    std::function<reports::Page()> page;  // made when it is asked for

    std::string html() const;  // the page with the JSON in it
};

// None, bool, int, float, str, list, dict: null is None, keys keep their order.
pybind11::object to_python(const reports::Json&);

// `command`: how this answer was asked for, in Python.
reports::Provenance provenance(const std::string& command, const std::string& case_path);

// 0: as many as there are cores. Throws scaling::InvalidInput outside [0, 1024].
int threads_of(int asked);

}  // namespace python
