// SPDX-License-Identifier: MIT
#include "app/peer_run.hpp"

#include "app/forward_curves.hpp"
#include "app/progress.hpp"
#include "cases/csv.hpp"
#include "engines/flow_run.hpp"
#include "engines/lammps_vessels.hpp"
#include "engines/nearest.hpp"
#include "engines/one_throw.hpp"
#include "engines/pile_run.hpp"
#include "engines/process.hpp"
#include "reports/numbers.hpp"
#include "rigs/forward.hpp"
#include "rigs/height_map.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace app {

namespace {

using cases::Case;
using cases::Experiment;
using engines::Peer;
using scaling::InvalidInput;
using scaling::mistake;

std::filesystem::path deck_folder(const std::filesystem::path& folder, const std::string& id,
                                  const Peer& peer) {
    return folder / (id + "-" + peer.name);
}

reports::Json engine_json(const Peer& peer, const std::string& release, int ranks,
                          const std::vector<std::string>& command,
                          const std::filesystem::path& deck, const std::string& name) {
    return {{"name", peer.title},
            {"version", release},
            {"ranks", ranks},
            {"command", engines::command_line(command)},
            {"deck", (deck.filename() / name).string()},
            {"log", (deck.filename() / peer.log).string()}};
}

std::string words_of(const Peer& peer, const std::string& release) {
    return peer.words_of_release ? peer.words_of_release(release) : "";
}

// What only our own core can do.
void refuse_for_peer(const CommonOptions& o, const RunPlace& place) {
    const Peer& peer = *place.engine.peer;
    const auto refuse = [&](const std::string& option, const std::string& remedy) {
        throw InvalidInput(mistake(option, "with --engine " + peer.name,
                                   fmt::format("must be left out: the run is {}' own", peer.title),
                                   remedy));
    };
    if (!place.dump.formats.empty())
        refuse("--dump",
               fmt::format("add a dump to the deck in ID-{}/ and run it by hand", peer.name));
    if (o.resume) refuse("--resume", "start anew");
    if (place.sleep) refuse("--sleep", "dem_min has it");
}

// The progress of a deck of many grains.
class Told {
  public:
    Told(const RunPlan& plan, const Peer& peer, std::int64_t expected, double time_step)
        : progress_(plan.progress),
          who_(fmt::format("{} in {}", plan.id, peer.title)),
          expected_(static_cast<double>(expected)),
          time_step_(time_step) {
        progress_.start(0.0);
    }
    void show(const engines::DeckProgress& p) {
        reached = p.step;
        const double step = static_cast<double>(p.step);
        if (progress_.due())
            progress_.show(
                step, expected_,
                fmt::format("{}: step {}, {}, {} grains, kinetic {}", who_, reports::count(step),
                            reports::quantity(step * time_step_, "s"), p.grains,
                            reports::quantity(p.kinetic, "J")));
    }
    std::int64_t reached = 0;  // step

  private:
    Progress progress_;
    std::string who_;
    double expected_, time_step_;
};

ExperimentRun peer_run(const std::string& id, const std::string& rig, const engines::DeckRun& deck,
                       const Told& told) {
    return {id, rig, deck.seconds, std::nullopt, {{"interrupted_at_step", told.reached}}};
}

ExperimentRun pile_in_peer(const PileTask& task, const EngineChoice& choice) {
    const Peer& peer = *choice.peer;
    const std::filesystem::path folder = deck_folder(task.plan.folder, task.plan.id, peer);
    const engines::Deck deck = peer.pile(task.setup, {.nearest = choice.nearest});
    engines::write_deck(deck, folder);
    std::vector<std::string> off;
    if (choice.nearest)
        off = engines::how_far_off(peer, engines::program_of(peer), task.setup, folder / "nearest");
    Told told(task.plan, peer, rigs::expected_steps(task.setup), task.setup.time_step);
    engines::PeerPileRun result =
        engines::run_pile(peer, engines::program_of(peer), task.setup, folder, choice.ranks,
                          [&](const engines::DeckProgress& p) { told.show(p); });
    ExperimentRun run = peer_run(task.plan.id, "pile", result.deck, told);
    if (result.end) {
        rigs::PileRecord& record = result.end->record;
        for (std::string& said : off) record.notes.push_back(std::move(said));
        if (std::string said = words_of(peer, result.deck.release); !said.empty())
            record.notes.push_back(std::move(said));
        run.tables = write_pile(task.plan.folder, task.plan.id, record);
        run.section = reports::pile_section(task.plan.id, record);
        run.result = reports::to_json(record);
    }
    run.result["engine"] = engine_json(peer, result.deck.release, choice.ranks, result.deck.command,
                                       folder, deck.name);
    return run;
}

ExperimentRun flow_in_peer(const FlowTask& task, const Experiment& e, const EngineChoice& choice) {
    const Peer& peer = *choice.peer;
    const std::filesystem::path folder = deck_folder(task.plan.folder, task.plan.id, peer);
    const engines::Deck deck = peer.flow(task.setup, {});
    engines::write_deck(deck, folder);
    Told told(task.plan, peer, rigs::expected_steps(task.setup), task.setup.time_step);
    const engines::PeerFlowRun result =
        engines::run_flow(peer, engines::program_of(peer), task.setup, folder, choice.ranks,
                          [&](const engines::DeckProgress& p) { told.show(p); });
    ExperimentRun run = peer_run(task.plan.id, e.rig, result.deck, told);
    if (result.end) {
        const rigs::FlowRecord record = rigs::record(*result.end, task.setup);
        run.tables = write_flow(task.plan.folder, task.plan.id, record);
        run.section =
            reports::flow_section(task.plan.id, record, e.recording ? &*e.recording : nullptr);
        run.result = reports::to_json(record);
        const std::string note = engines::vessel_note(task.setup);
        for (const std::string& said : {note, words_of(peer, result.deck.release)})
            if (!said.empty()) run.section->notes.push_back(said);
        if (!note.empty()) run.result["note"] = note;
    }
    run.result["engine"] = engine_json(peer, result.deck.release, choice.ranks, result.deck.command,
                                       folder, deck.name);
    return run;
}

ExperimentRun curves_in_peer(const Case& c, const Experiment& e, const std::filesystem::path& where,
                             const Peer& peer) {
    const std::filesystem::path folder = deck_folder(where, e.id, peer);
    const rigs::Ordinates at = rigs::ordinates_of(e);
    const engines::PeerCurvesRun result =
        engines::run_one_grain(peer, engines::program_of(peer), c, e, at, folder);
    ExperimentRun run{e.id, e.rig, result.seconds, std::nullopt, {{"rows", at.at.size()}}};
    if (!result.interrupted) {
        const std::vector<cases::Column> columns = curve_columns(e, result.curves, at);
        cases::write_csv((where / (e.id + ".csv")).string(), columns);
        run.tables = {{e.id, columns}};
        run.section = reports::curves_section(e.id, columns, e.recording ? &*e.recording : nullptr);
        if (!result.note.empty()) {
            run.section->notes.push_back(result.note);
            run.result["note"] = result.note;
        }
        if (const std::string said = words_of(peer, result.release); !said.empty())
            run.section->notes.push_back(said);
    }
    run.result["engine"] =
        engine_json(peer, result.release, 1, result.command, folder, result.deck);
    return run;
}

// Centres and radii, and of clumps which grain a sphere belongs to.
reports::ChannelTable grains_table(const std::string& id, const rigs::Heap& heap) {
    cases::Column x{"x", "m"}, y{"y", "m"}, z{"z", "m"}, radius{"radius", "m"};
    for (const contact::Vec3& p : heap.centre) {
        x.values.push_back(p.x);
        y.values.push_back(p.y);
        z.values.push_back(p.z);
    }
    radius.values = heap.radius;
    reports::ChannelTable table{id + "-grains", {x, y, z, radius}};
    if (heap.spheres > 1) {
        cases::Column grain{"grain", "1"};
        const auto spheres = static_cast<std::size_t>(heap.spheres);
        for (std::size_t k = 0; k < radius.values.size(); ++k)
            grain.values.push_back(static_cast<double>(k / spheres));
        table.columns.push_back(grain);
    }
    return table;
}

void write(const std::filesystem::path& folder, const std::vector<reports::ChannelTable>& tables) {
    for (const reports::ChannelTable& table : tables)
        if (!table.columns.empty())
            cases::write_csv((folder / (table.name + ".csv")).string(), table.columns);
}

}  // namespace

std::vector<reports::ChannelTable> write_pile(const std::filesystem::path& folder,
                                              const std::string& id,
                                              const rigs::PileRecord& record) {
    const rigs::HeightMap map = rigs::scan(record.heap);
    cases::Column azimuth{"azimuth", "rad"}, r{"r", "m"}, z{"z", "m"};
    for (std::size_t k = 0; k < map.azimuths; ++k) {
        for (std::size_t i = 0; i < map.rings; ++i) {
            azimuth.values.push_back(map.azimuth(k));
            r.values.push_back(map.radius(i));
            z.values.push_back(map.z[k * map.rings + i]);
        }
    }
    std::vector<reports::ChannelTable> tables{{id, {azimuth, r, z}}};
    tables.push_back(grains_table(id, record.heap));
    write(folder, tables);
    return tables;
}

std::function<ExperimentRun()> prepared_pile_in_peer(const PileTask& task, const CommonOptions& o,
                                                     const RunPlace& place) {
    const EngineChoice choice = place.engine;
    refuse_for_peer(o, place);
    engines::program_of(*choice.peer);
    engines::refuse_ranks_without_mpirun(choice.ranks);
    choice.peer->pile(task.setup, {.nearest = choice.nearest});
    return [task, choice] { return pile_in_peer(task, choice); };
}

std::vector<reports::ChannelTable> write_flow(const std::filesystem::path& folder,
                                              const std::string& id,
                                              const rigs::FlowRecord& record) {
    std::vector<reports::ChannelTable> tables{{id, record.channels},
                                              grains_table(id, record.grains)};
    if (!record.profile.empty()) tables.push_back({id + "-velocity", record.profile});
    write(folder, tables);
    return tables;
}

std::function<ExperimentRun()> prepared_flow_in_peer(const FlowTask& task, const Experiment& e,
                                                     const CommonOptions& o,
                                                     const RunPlace& place) {
    const EngineChoice choice = place.engine;
    refuse_for_peer(o, place);
    if (choice.peer->flow == nullptr)
        throw InvalidInput(mistake("--engine", choice.peer->name,
                                   fmt::format("has no deck for the rig {}", e.rig),
                                   "take lammps, which has one, or dem_min"));
    engines::program_of(*choice.peer);
    engines::refuse_ranks_without_mpirun(choice.ranks);
    choice.peer->flow(task.setup, {.nearest = choice.nearest});
    return [task, &e, choice] { return flow_in_peer(task, e, choice); };
}

std::function<ExperimentRun()> prepared_in_peer(const Case& c, const Experiment& e,
                                                const CommonOptions& o, const RunPlace& place) {
    const Peer& peer = *place.engine.peer;
    refuse_for_peer(o, place);
    if (place.engine.ranks > 1)
        throw InvalidInput(mistake("--ranks", std::to_string(place.engine.ranks),
                                   "must be 1 for a single grain", "leave --ranks out"));
    engines::program_of(peer);
    peer.one_grain(c, e, rigs::ordinates_of(e), {});
    return [&c, &e, folder = place.folder, &peer] { return curves_in_peer(c, e, folder, peer); };
}

}  // namespace app
