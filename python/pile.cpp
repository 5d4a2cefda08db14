// SPDX-License-Identifier: MIT
#include "python/pile.hpp"

#include "app/pile_cost.hpp"
#include "app/scale_input.hpp"
#include "cases/messages.hpp"
#include "cases/read_case.hpp"
#include "reports/numbers.hpp"
#include "reports/runs.hpp"
#include "reports/text.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <pybind11/stl.h>
#include <stdexcept>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace python {

namespace {

using cases::Case;
using cases::Experiment;
using dem_min::Particles;
using scaling::InvalidInput;
using scaling::mistake;

const Experiment& pile_of(const Case& c, const std::string& id) {
    if (!id.empty()) {
        const Experiment& e = *app::experiment_of(c, id);
        if (e.rig == "pile") return e;
        throw InvalidInput(mistake("experiment " + cases::in_quotes(id),
                                   "rig " + cases::in_quotes(e.rig), "must be of the rig pile",
                                   "similitude.predict answers for single grains"));
    }
    for (const Experiment& e : c.experiments)
        if (e.rig == "pile") return e;
    throw InvalidInput(mistake(c.path + ": experiments", "no pile", "must hold one",
                               "similitude.predict answers for single grains"));
}

// Parts so short that Ctrl-C seems to work at once and so long that looking for it costs nothing.
constexpr double shortest_part = 0.02, longest_part = 0.1;  // s

py::array_t<bool> fixed_grains(const Pile& pile) {
    const Particles& g = pile.run().simulation.grains;
    py::array_t<bool> fixed(static_cast<py::ssize_t>(g.count()));
    for (std::size_t k = 0; k < g.count(); ++k)
        fixed.mutable_at(static_cast<py::ssize_t>(k)) = g.fixed(k);
    return fixed;
}

py::array_t<double> copied(const std::vector<double>& values) {
    return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

}  // namespace

Pile::Pile(const std::string& case_path, const PileOptions& options)
    : case_(cases::read_case(case_path)), options_(options) {
    const Experiment& e = pile_of(case_, options.experiment);
    id_ = e.id;
    options_.threads = threads_of(options.threads);
    setup_ = app::counted_setup(case_, e, options.seed, options.yes);
    if (options.sleep) setup_.sleep_speed = rigs::speed_of_rest(setup_);
    if (!options.yes) app::refuse_unaffordable(e, setup_, options_.threads);
    run_ = rigs::begin_pile(setup_, options_.threads);
}

const rigs::PileRun& Pile::run() const {
    if (busy_) throw std::runtime_error("this pile is being stepped by another thread");
    return run_;
}

void Pile::hand_over_loans() {
    for (auto& [array, loan] : loans_)
        if (const std::shared_ptr<void> holder = loan.holder.lock()) loan.hand_over(holder.get());
    loans_.clear();
}

void Pile::advance(std::int64_t steps) {
    if (steps < 0)
        throw scaling::InvalidParameter(
            mistake("steps", std::to_string(steps), "must be >= 0", "count from here"));
    run();
    hand_over_loans();
    busy_ = true;
    const struct Done {
        bool& busy;
        ~Done() { busy = false; }
    } done{busy_};
    using Clock = std::chrono::steady_clock;
    std::int64_t part = 100;
    while (steps > 0 && !run_.finished) {
        const std::int64_t now = std::min(part, steps);
        double seconds = 0.0;
        {
            const py::gil_scoped_release others_may;
            const auto start = Clock::now();
            rigs::advance(run_, setup_, now);
            seconds = std::chrono::duration<double>(Clock::now() - start).count();
        }
        steps -= now;
        if (seconds > longest_part) part = std::max<std::int64_t>(1, part / 2);
        if (seconds < shortest_part) part *= 2;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

template <class Array>
py::array Pile::view(Array Particles::*member) {
    run();
    Array& array = run_.simulation.grains.*member;
    Loan& loan = loans_[&array];
    std::shared_ptr<void> holder = loan.holder.lock();
    if (!holder) {
        holder = std::make_shared<Array>();
        loan.holder = holder;
        loan.hand_over = [&array](void* to) {
            Array copy = array;
            *static_cast<Array*>(to) = std::move(array);
            array = std::move(copy);
        };
    }
    using Base = std::pair<std::shared_ptr<Pile>, std::shared_ptr<void>>;
    const py::capsule base(new Base(shared_from_this(), holder),
                           [](void* p) { delete static_cast<Base*>(p); });
    py::array made(py::dtype::of<typename Array::value_type>(),
                   {static_cast<py::ssize_t>(array.size())}, {}, array.data(), base);
    made.attr("flags").attr("writeable") =
        false;  // a grain moved by hand would leave the neighbour lists behind
    return made;
}

const rigs::PileRecord& Pile::record() {
    if (!run().finished)
        throw std::runtime_error(id_ + ": the pile has not come to its end; call run()");
    if (!record_) record_ = rigs::record(run_, setup_);
    return *record_;
}

Answer Pile::answer() {
    const reports::RunSection section = reports::pile_section(id_, record());
    std::string text = fmt::format("{}: {}\n  {}\n", id_, section.verdict.headline,
                                   reports::wrapped(section.verdict.why, 98, 2));
    std::vector<bool> right(section.quantities.front().size(), true);
    right.front() = false;
    text += reports::columns(section.quantities, right);
    reports::Provenance who = provenance(options_.command, case_.path);
    who.seeds = {options_.seed};
    who.threads = options_.threads;
    return {reports::to_json(record()), text, [self = shared_from_this(), section, who] {
                return reports::page_of(self->case_, std::vector{section}, who);
            }};
}

std::string Pile::status() const {
    if (busy_) return id_ + ": being stepped by another thread";
    const dem_min::Simulation& s = run_.simulation;
    return fmt::format("{}: step {} of about {}, {}, {}/{} fed, {} lost{}", id_, s.steps,
                       rigs::expected_steps(setup_), reports::quantity(s.time(), "s"), run_.fed,
                       setup_.feed_time.size(), s.past.grains_lost,
                       !run_.finished ? ""
                       : run_.at_rest ? ", at rest"
                                      : ", given up: not at rest");
}

void bind_pile(py::module_& m) {
    using Shared = std::shared_ptr<Pile>;
    py::class_<Pile, Shared> pile(m, "Pile");
    pile.def(py::init([](const std::string& path, const std::string& experiment, std::uint64_t seed,
                         int threads, bool sleep, bool yes, const std::string& command) {
                 return std::make_shared<Pile>(
                     path, PileOptions{experiment, seed, threads, sleep, yes, command});
             }),
             py::arg("case"), py::kw_only(), py::arg("experiment"), py::arg("seed"),
             py::arg("threads"), py::arg("sleep"), py::arg("yes"), py::arg("command"));
    pile.def("advance", &Pile::advance, py::arg("steps"), "At most so many steps more.");
    pile.def(
        "run", [](Pile& p) { p.advance(std::numeric_limits<std::int64_t>::max()); }, "To the end.");
    pile.def_property_readonly("experiment", &Pile::id);
    pile.def_property_readonly("status", &Pile::status);
    pile.def_property_readonly("steps", [](const Pile& p) { return p.run().simulation.steps; });
    pile.def_property_readonly("expected_steps",
                               [](const Pile& p) { return rigs::expected_steps(p.setup()); });
    pile.def_property_readonly("time", [](const Pile& p) { return p.run().simulation.time(); });
    pile.def_property_readonly("time_step", [](const Pile& p) { return p.setup().time_step; });
    pile.def_property_readonly("diameter", [](const Pile& p) { return p.setup().d; });
    pile.def_property_readonly("fed", [](const Pile& p) { return p.run().fed; });
    pile.def_property_readonly("lost",
                               [](const Pile& p) { return p.run().simulation.past.grains_lost; });
    pile.def_property_readonly("finished", [](const Pile& p) { return p.run().finished; });
    pile.def_property_readonly("at_rest", [](const Pile& p) { return p.run().at_rest; });
    pile.def_property_readonly("fixed", &fixed_grains);
    const auto view = [&pile](const char* name, auto member) {
        pile.def_property_readonly(name, [member](Pile& p) { return p.view(member); });
    };
    view("x", &Particles::x), view("y", &Particles::y), view("z", &Particles::z);
    view("vx", &Particles::vx), view("vy", &Particles::vy), view("vz", &Particles::vz);
    view("wx", &Particles::wx), view("wy", &Particles::wy), view("wz", &Particles::wz);
    view("radius", &Particles::radius), view("mass", &Particles::mass);
    view("id", &Particles::id), view("material", &Particles::material);
    pile.def("profile", [](Pile& p) {
        const rigs::RadialProfile& profile = p.record().profile;
        return py::make_tuple(copied(profile.r), copied(profile.z));
    });
    pile.def("answer", &Pile::answer);
}

}  // namespace python
