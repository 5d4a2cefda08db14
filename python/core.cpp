// SPDX-License-Identifier: MIT
// What python/similitude/__init__.py calls: one case in, one answer out, as each verb of the command line.
#include "app/calibration_runs.hpp"
#include "app/forward_curves.hpp"
#include "app/machine_speed.hpp"
#include "app/scale_input.hpp"
#include "app/version.hpp"
#include "cases/domain.hpp"
#include "cases/effects.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "diagnose/diagnose.hpp"
#include "python/answer.hpp"
#include "python/pile.hpp"
#include "reports/diagnosis.hpp"
#include "reports/diagnosis_json.hpp"
#include "reports/road.hpp"
#include "reports/runs.hpp"
#include "reports/text.hpp"
#include "rigs/single_grain.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <pybind11/stl.h>
#include <variant>

namespace py = pybind11;

namespace python {

namespace {

using cases::Case;
using cases::Experiment;
using scaling::InvalidInput;
using scaling::mistake;

// Once a process: it takes a third of a second.
double speed_of(int threads) {
    static std::map<int, double> measured;
    const auto [place, fresh] = measured.try_emplace(threads, 0.0);
    if (fresh) place->second = app::measured_speed(threads);
    return place->second;
}

Answer scale(const std::string& path, const app::ScaleOverrides& overrides, int threads,
             const std::string& command) {
    if (!overrides.of.empty() && overrides.of != "original" && overrides.of != "scaled")
        throw InvalidInput(mistake("of", cases::in_quotes(overrides.of),
                                   "must be original or scaled",
                                   "original is the real grain, scaled the simulated one"));
    const auto c = std::make_shared<const Case>(cases::read_case(path));
    const double speed = speed_of(threads_of(threads));
    const scaling::ScaleStudy study = app::study_of(*c, overrides, speed);
    const reports::Provenance who = provenance(command, c->path);
    return {reports::to_json(*c, study, speed, who),
            (c->title.empty() ? "" : c->title + "\n") + reports::text_of(study),
            [c, study, who] { return reports::page_of(*c, study, who); }};
}

// As it would stand in case.json: a number, or a text with its unit.
using Stated = std::variant<double, std::string>;

cases::Value value_of(const Stated& stated, const std::string& where) {
    if (const double* number = std::get_if<double>(&stated))
        return {.where = where, .kind = cases::Value::Kind::number, .written_number = *number};
    return {.where = where,
            .kind = cases::Value::Kind::text,
            .written_text = std::get<std::string>(stated)};
}

void set_parameter(Case& c, const std::string& name, const Stated& stated) {
    const auto found = c.model.parameters.find(name);
    if (found != c.model.parameters.end()) {
        cases::Parameter& parameter = found->second;
        for (const cases::ParameterRule& rule : cases::parameter_rules())
            if (rule.name == name)
                parameter.value = cases::checked(value_of(stated, "parameters." + name),
                                                 parameter.unit, rule.domain);
        return;
    }
    std::vector<std::string> names;
    for (const auto& [known, parameter] : c.model.parameters) names.push_back(known);
    throw InvalidInput(
        mistake("parameters", cases::in_quotes(name), "must be one of the case's model",
                names.empty() ? "its model has none" : cases::suggestion(name, names)));
}

const Experiment& single_grain(const Case& c, const std::string& id) {
    if (!id.empty()) return *app::experiment_of(c, id);
    for (const Experiment& e : c.experiments)
        if (e.rig != "pile") return e;
    throw InvalidInput(mistake(c.path + ": experiments", "none of a single grain", "must hold one",
                               "similitude.simulate pours piles"));
}

struct Prediction {
    std::string experiment;
    std::vector<cases::Column> columns;
    Answer answer;
};

Prediction predict(const std::string& path, const std::string& id,
                   const std::map<std::string, Stated>& parameters,
                   const std::optional<std::vector<double>>& at, const std::string& command) {
    const auto c = std::make_shared<Case>(cases::read_case(path));
    for (const auto& [name, value] : parameters) set_parameter(*c, name, value);
    const Experiment& e = single_grain(*c, id);
    rigs::refuse_physics_of_many(*c, e.rig);
    rigs::forward_model(e);  // refuses the rigs of many grains
    rigs::Ordinates ordinates = rigs::ordinates_of(e);
    if (at) ordinates = {*at, std::vector<bool>(ordinates.retract.empty() ? 0 : at->size(), false)};
    const std::vector<cases::Column> columns =
        app::forward_curves(e, rigs::world_of(*c, e), ordinates);
    const reports::Provenance who = provenance(command, c->path);
    const reports::RunSection section =
        reports::curves_section(e.id, columns, e.recording ? &*e.recording : nullptr);
    return {e.id,
            columns,
            {reports::Json::object(), e.id + ": " + section.verdict.headline + "\n",
             [c, section, who] { return reports::page_of(*c, std::vector{section}, who); }}};
}

// `work` on another thread, while this one looks for signals; it ends soon after `stop` is set.
template <class Work>
auto interruptible(std::atomic<bool>& stop, const Work& work) {
    auto result = std::async(std::launch::async, work);
    for (bool ready = false; !ready;) {
        {
            const py::gil_scoped_release others_may;
            ready = result.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
        }
        if (PyErr_CheckSignals() == 0) continue;
        py::error_already_set raised;
        stop = true;
        const py::gil_scoped_release others_may;
        result.wait();
        throw raised;
    }
    return result.get();
}

diagnose::Verdict judged(const Case& c, diagnose::Settings settings) {
    std::atomic<bool> stop{false};
    settings.progress = [&stop](double, const std::string&) { return !stop; };
    return interruptible(stop,
                         [&] { return diagnose::diagnose(c, settings, cases::open_held_out); });
}

Answer calibrated(const std::string& path, app::RoadOptions road, const std::string& command) {
    const auto c = std::make_shared<const Case>(cases::read_case(path));
    road.threads = threads_of(road.threads);
    std::atomic<bool> stop{false};
    const app::CalibrationWatch watch{[](double, double, const std::string&) {}, &stop};
    const auto done = std::make_shared<const calibrate::Calibration>(
        interruptible(stop, [&] { return app::calibration(*c, road, watch); }));
    reports::Provenance who = provenance(command, c->path);
    who.seeds = {road.seed};
    who.threads = road.threads;
    return {reports::to_json(*done, who), reports::text_of(*done),
            [c, done, who] { return reports::page_of(*c, *done, who); }};
}

Answer diagnosis(const std::string& path, std::uint64_t seed, int threads, double alpha,
                 const std::string& command) {
    if (!(alpha >= 1e-4 && alpha <= 0.5))
        throw InvalidInput(mistake("alpha", fmt::format("{}", alpha), "must be in [1e-4, 0.5]",
                                   "the usual one is 0.05"));
    const auto c = std::make_shared<const Case>(cases::read_case(path, cases::HeldOut::sealed));
    const diagnose::Verdict v =
        judged(*c, {.seed = seed, .threads = threads_of(threads), .alpha = alpha});
    reports::Provenance who = provenance(command, c->path);
    who.seeds = {seed};
    who.threads = threads_of(threads);
    return {reports::to_json(v, who),
            (c->title.empty() ? "" : c->title + "\n") + reports::text_of(v),
            [c, v, who] { return reports::page_of(*c, v, who); }};
}

py::object column(const cases::Column& c) {
    if (!c.words.empty()) return py::cast(c.words);
    return py::array_t<double>(static_cast<py::ssize_t>(c.values.size()), c.values.data());
}

}  // namespace

}  // namespace python

PYBIND11_MODULE(_core, m) {
    using namespace python;
    m.attr("__version__") = app::version;
    py::register_exception<scaling::InvalidInput>(m, "InvalidInput", PyExc_ValueError);

    py::class_<Answer>(m, "Answer")
        .def_readonly("text", &Answer::text)
        .def("data", [](const Answer& a) { return to_python(a.json); })
        .def("html", &Answer::html);
    bind_pile(m);

    m.def(
        "scale",
        [](const std::string& path, std::optional<double> h, const std::string& scheme,
           const std::vector<std::string>& keep, bool distorted, std::optional<double> softening,
           const std::string& invariant, const std::string& work_of_adhesion,
           const std::string& surface_energy, const std::string& of, const std::string& experiment,
           const std::string& apparatus, int threads, const std::string& command) {
            return scale(path,
                         {.h = h,
                          .softening = softening,
                          .scheme = scheme,
                          .invariant = invariant,
                          .keep = keep,
                          .distorted = distorted,
                          .work_of_adhesion = work_of_adhesion,
                          .surface_energy = surface_energy,
                          .of = of,
                          .experiment = experiment,
                          .apparatus = apparatus},
                         threads, command);
        },
        py::arg("case"), py::kw_only(), py::arg("h"), py::arg("scheme"), py::arg("keep"),
        py::arg("distorted"), py::arg("softening"), py::arg("invariant"),
        py::arg("work_of_adhesion"), py::arg("surface_energy"), py::arg("of"),
        py::arg("experiment"), py::arg("apparatus"), py::arg("threads"), py::arg("command"));
    m.def(
        "predict",
        [](const std::string& path, const std::string& experiment,
           const std::map<std::string, Stated>& parameters,
           const std::optional<std::vector<double>>& at, const std::string& command) {
            const Prediction p = predict(path, experiment, parameters, at, command);
            py::list columns;
            for (const cases::Column& c : p.columns)
                columns.append(py::make_tuple(c.name, c.unit, column(c)));
            return py::make_tuple(columns, p.answer);
        },
        py::arg("case"), py::kw_only(), py::arg("experiment"), py::arg("parameters"), py::arg("at"),
        py::arg("command"));
    m.def(
        "calibrate",
        [](const std::string& path, const std::string& experiment, const std::string& road,
           int budget, int confirm, const std::string& estimator, bool bulk_density,
           std::uint64_t seed, int threads, const std::string& out, bool resume, bool yes,
           const std::string& command) {
            app::RoadOptions o;
            o.experiment = experiment, o.road = road, o.estimator = estimator;
            o.bulk_density = bulk_density;
            o.budget = budget, o.confirm = confirm;
            o.seed = seed, o.threads = threads;
            o.out = out, o.resume = resume, o.yes = yes;
            return calibrated(path, o, command);
        },
        py::arg("case"), py::kw_only(), py::arg("experiment"), py::arg("road"), py::arg("budget"),
        py::arg("confirm"), py::arg("estimator"), py::arg("bulk_density"), py::arg("seed"),
        py::arg("threads"), py::arg("out"), py::arg("resume"), py::arg("yes"), py::arg("command"));
    m.def("diagnose", &diagnosis, py::arg("case"), py::kw_only(), py::arg("seed"),
          py::arg("threads"), py::arg("alpha"), py::arg("command"));
}
