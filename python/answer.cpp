// SPDX-License-Identifier: MIT
#include "python/answer.hpp"

#include "app/version.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <thread>

namespace py = pybind11;

namespace python {

std::string Answer::html() const {
    reports::Page made = page();
    made.data = reports::text_of(json);
    return reports::html(made);
}

py::object to_python(const reports::Json& json) {
    switch (json.type()) {
        case reports::Json::value_t::null:
        case reports::Json::value_t::discarded:
        case reports::Json::value_t::binary:
            return py::none();
        case reports::Json::value_t::boolean:
            return py::bool_(json.get<bool>());
        case reports::Json::value_t::number_integer:
            return py::int_(json.get<std::int64_t>());
        case reports::Json::value_t::number_unsigned:
            return py::int_(json.get<std::uint64_t>());
        case reports::Json::value_t::number_float:
            return py::float_(json.get<double>());
        case reports::Json::value_t::string:
            return py::str(json.get_ref<const std::string&>());
        case reports::Json::value_t::array: {
            py::list list;
            for (const reports::Json& item : json) list.append(to_python(item));
            return list;
        }
        case reports::Json::value_t::object: {
            py::dict dict;
            for (const auto& [key, item] : json.items()) dict[py::str(key)] = to_python(item);
            return dict;
        }
    }
    return py::none();
}

reports::Provenance provenance(const std::string& command, const std::string& case_path) {
    return {.version = app::version,
            .git = app::git,
            .compiler = app::compiler,
            .command = command,
            .case_path = case_path,
            .seeds = {},
            .threads = std::nullopt};
}

int threads_of(int asked) {
    if (asked < 0 || asked > 1024)
        throw scaling::InvalidInput(scaling::mistake("threads", std::to_string(asked),
                                                     "must be in [0, 1024]",
                                                     "0 takes as many as there are cores"));
    if (asked > 0) return asked;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace python
