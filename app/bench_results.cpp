// SPDX-License-Identifier: MIT
#include "app/bench_results.hpp"

#include <nlohmann/json.hpp>

namespace app {

using reports::Json;

namespace {

Json to_json(const bench::Spread& s) {
    return {{"median", s.median}, {"low", s.low}, {"high", s.high}};
}

Json to_json(const bench::Machine& m) {
    return {{"processor", m.processor},
            {"cores", m.cores},
            {"memory", m.memory},
            {"load_before", m.load_before},
            {"busy", bench::busy(m)}};
}

Json to_json(const engines::Bed& b, int threads) {
    return {{"grains", b.grains()},
            {"nx", b.nx},
            {"ny", b.ny},
            {"nz", b.nz},
            {"radius", b.radius},
            {"density", b.density},
            {"lattice", b.lattice()},
            {"jitter", b.jitter},
            {"jitter_seed", b.seed},
            {"acceleration", {b.acceleration().x, b.acceleration().y, b.acceleration().z}},
            {"youngs_modulus", b.youngs_modulus},
            {"poisson_ratio", b.poisson_ratio},
            {"surface_energy", b.surface_energy},
            {"work_of_adhesion", 2.0 * b.surface_energy},
            {"restitution", b.restitution},
            {"sliding_friction", b.sliding_friction},
            {"rolling_stiffness", b.rolling_stiffness},
            {"rolling_damping", b.rolling_damping},
            {"rolling_friction", b.rolling_friction},
            {"wall_restitution", b.wall_restitution},
            {"wall_friction", b.wall_friction},
            {"time_step", b.time_step},
            {"margin", b.margin},
            {"warm_up", b.warm_up},
            {"steps", b.steps},
            {"threads", threads}};
}

Json engine_json(const bench::Timed& e) {
    Json json = {{"name", e.name}, {"laws", e.laws}};
    if (!e.version.empty()) json["version"] = e.version;
    if (!e.package.empty()) json["package"] = e.package;
    if (!e.differs.empty()) json["differs"] = e.differs;
    if (!e.command.empty()) json["command"] = e.command;
    if (!e.folder.empty()) json["folder"] = e.folder;
    return json;
}

Json run_json(const bench::Timed& e, std::size_t repeat, const engines::Bed& bed) {
    const engines::BedFigures& f = e.runs[repeat];
    return {{"engine", e.name},
            {"repeat", repeat + 1},
            {"seconds", f.seconds},
            {"grain_steps_per_second", f.grain_steps_per_second(bed)},
            {"grains", f.grains},
            {"neighbours", f.neighbours},
            {"kinetic_energy", f.kinetic_energy}};
}

void add_comparison(Json& json, const bench::Comparison& c) {
    json["bed"] = to_json(c.bed, c.threads);
    json["engines"] = Json::array({engine_json(c.ours)});
    json["runs"] = Json::array();
    json["ratios"] = Json::object();
    for (std::size_t k = 0; k < c.ours.runs.size(); ++k) {  // in the order in which they ran
        json["runs"].push_back(run_json(c.ours, k, c.bed));
        for (const bench::Timed& peer : c.peers) json["runs"].push_back(run_json(peer, k, c.bed));
    }
    for (const bench::Timed& peer : c.peers) {
        json["engines"].push_back(engine_json(peer));
        json["ratios"][peer.name] = to_json(bench::spread_of(bench::ratios(c.ours, peer)));
    }
    if (c.peers.size() == 1) json["ratio"] = json["ratios"].front()["median"];
}

Json point_json(const bench::ScalingPoint& p) {
    Json json = {{"grains", p.grains},
                 {"threads", p.threads},
                 {"seconds_per_grain_step", to_json(p.grain_step)},
                 {"contacts_per_grain", p.contacts}};
    json["bytes"] = {{"grains", p.memory.bytes_grains},
                     {"contacts", p.memory.bytes_contacts},
                     {"lists", p.memory.bytes_lists}};
    json["bytes_per_grain"] = p.bytes_per_grain();
    json["bytes_per_contact"] = p.contacts > 0.0 ? Json(p.bytes_per_contact()) : Json(nullptr);
    json["moved_per_grain_step"] = p.moved();
    json["moved_per_second"] = p.moved() / p.grain_step.median;
    json["triad_of_that_size"] = p.triad;
    return json;
}

Json side_json(const bench::PolydisperseSide& s) {
    return {{"grains", s.grains},
            {"contacts_per_grain", s.contacts},
            {"seconds_per_contact_step", to_json(s.contact_step)},
            {"seconds_per_grain_step", to_json(s.grain_step)}};
}

}  // namespace

Json to_json(const BenchResults& r) {
    Json json = {{"machine", to_json(r.machine)}};
    if (r.comparison) add_comparison(json, *r.comparison);
    if (r.scaling) {
        json["scaling"] = Json::array();
        for (const bench::ScalingPoint& p : r.scaling->points)
            json["scaling"].push_back(point_json(p));
    }
    if (r.polydisperse)
        json["polydisperse"] = {{"size_ratio", r.polydisperse->size_ratio},
                                {"threads", r.polydisperse->threads},
                                {"equal", side_json(r.polydisperse->equal)},
                                {"mixed", side_json(r.polydisperse->mixed)},
                                {"ratio", r.polydisperse->ratio()}};
    json["stream"] = Json::array();
    for (const bench::Triad& t : r.triads)
        json["stream"].push_back(
            {{"bytes", t.bytes}, {"threads", t.threads}, {"bandwidth", t.bandwidth}});
    return json;
}

}  // namespace app
