// SPDX-License-Identifier: MIT
#include "diagnose/gates.hpp"
#include "diagnose/hypotheses.hpp"
#include "diagnose/intervals.hpp"
#include "diagnose/left_out.hpp"
#include "diagnose/next_experiment.hpp"
#include "diagnose/scores.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace diagnose {
namespace {

constexpr double name_level = 0.01;  // p of the mismatch below which a name is given
constexpr double far_apart = 3.0;    // sigma between two hypotheses that recordings can tell apart
constexpr double sure = 0.75;        // probability at which rivals that far apart are out
constexpr double sure_of_two = 0.9;  // the same of two effects: their look-alikes are many
constexpr double close_odds = 3.0;   // log odds of a rival that stands while the winner is not sure
// Log odds at which a rival is out though recordings like these need not tell it apart: of single grains, and of heaps, whose
// covariances have the error of the emulator in them.
constexpr double negligible_odds = 14.0, negligible_of_heaps = 5.0;
constexpr std::size_t most_alike = 3;  // hypotheses that a next experiment is to tell apart

using Names = std::vector<std::string>;

bool is_unknown(const Group& g) { return g.effects == Names{"unknown"}; }

// The same effects and more.
bool contains(const Names& wide, const Names& narrow) {
    return std::all_of(narrow.begin(), narrow.end(), [&](const std::string& n) {
        return std::find(wide.begin(), wide.end(), n) != wide.end();
    });
}

class Decision {
  public:
    explicit Decision(Judge& j) : j_(j), v_(j.verdict), groups_(groups_of(j)) {}

    const Candidate& make() {
        if (v_.p_value > j_.settings.alpha) {
            v_.answer = Answer::consistent;
            publish();
            return j_.base;
        }
        find_winner();
        if (!winner_) return none_of_these();
        j_.report(0.85, "rivals");
        find_rivals();
        weigh_winner();
        publish();
        return *winner_->best;
    }

  private:
    Judge& j_;
    Verdict& v_;
    std::vector<Group> groups_;  // stays in its order: what follows points into it
    const Group* winner_ = nullptr;
    Group* unknown_ = nullptr;
    std::map<const Group*, double> own_p_;
    std::vector<const Group*> rivals_;  // nearest first

    // It leaves no mismatch, and one value of each of its parameters serves all recordings.
    bool explains(const Group& g) {
        if (!own_p_.contains(&g)) own_p_[&g] = j_.own_p(*g.best);
        return own_p_[&g] >= own_level &&
               serves_all({j_.problem, *j_.whiten, j_.base, *g.best, own_p_[&g], std::nan("")});
    }

    // Of most weight, if it passes its own test of mismatch: where it does not, what stands behind it is no explanation but
    // the next best.
    void find_winner() {
        for (Group& g : groups_) {
            if (is_unknown(g)) unknown_ = &g;
            if (!winner_ && !g.effects.empty() && !is_unknown(g)) winner_ = &g;
        }
        const bool beaten = unknown_ && winner_ && unknown_->log_weight > winner_->log_weight;
        if (winner_ && (beaten || !explains(*winner_))) winner_ = nullptr;
    }

    // Hypotheses that explain, too, and that these recordings and those held out cannot tell from the winner.
    void find_rivals() {
        const std::unique_ptr<Planned> planned = with_held_out(j_.problem, j_.noise);
        const Problem& both = planned ? planned->problem : j_.problem;
        const Whitener w(both, planned ? planned->noise : j_.noise);
        const Candidate truth = carried_over(both, *winner_->best);
        const bool heaps = std::all_of(j_.problem.records.begin(), j_.problem.records.end(),
                                       [](const Record& r) { return r.covariance.size() > 0; });
        const double negligible = heaps ? negligible_of_heaps : negligible_odds;
        std::vector<std::pair<double, const Group*>> list;
        for (const Group& g : groups_) {
            if (&g == winner_ || is_unknown(g) || contains(g.effects, winner_->effects)) continue;
            const double behind = winner_->log_weight - g.log_weight;
            const bool near_in_odds = behind < close_odds;
            // Other two are too many for all of them to be 3 sigma away: odds alone must do.
            const bool two = winner_->effects.size() == 2, both_two = two && g.effects.size() == 2;
            if (behind > negligible || (both_two && !near_in_odds)) continue;
            if (g.effects.empty()) {  // chance
                if (near_in_odds) list.push_back({0.0, &g});
                continue;
            }
            const double apart = separation(both, w, truth, carried_over(both, *g.best));
            const bool close = near_in_odds && winner_->probability < (two ? sure_of_two : sure);
            if (close || (apart < far_apart && explains(g))) list.push_back({apart, &g});
        }
        std::stable_sort(list.begin(), list.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [apart, g] : list) rivals_.push_back(g);
    }

    // Of the user's model with a fine step; NaN where that changes nothing.
    double refined_p() const {
        const Candidate* c = j_.artefact();
        const bool changes = c && c->fit.objective() < j_.base.fit.objective() - seen;
        return changes ? j_.own_p(*c) : std::nan("");
    }

    void weigh_winner() {
        const Candidate& c = *winner_->best;
        const GateInput input{j_.problem, *j_.whiten, j_.base, c, own_p_.at(winner_), refined_p()};
        bool all_pass = true;
        for (std::size_t k = 0; k < c.h.terms.size(); ++k) {
            Effect e = effect_of(*winner_, *c.h.terms[k]);
            e.gates = gates(input, k);
            e.named = passes(e.gates);
            all_pass = all_pass && e.named;
            v_.effects.push_back(std::move(e));
        }
        j_.left_out_base = left_out_misfit(j_.problem, *j_.whiten, j_.base.h, j_.base.fit);
        j_.left_out_winner = left_out_misfit(j_.problem, *j_.whiten, c.h, c.fit);
        const bool beyond_unknown =
            !unknown_ || unknown_->log_weight < winner_->log_weight - close_odds;
        const bool named = rivals_.empty() && beyond_unknown && v_.p_value < name_level && all_pass;
        v_.answer = named ? Answer::explained : Answer::ambiguous;
        if (named) return;
        for (Effect& e : v_.effects) e.named = false;
        if (rivals_.empty()) rivals_ = {&runner_up()};
        std::vector<const Candidate*> alike{&c};
        std::vector<const Group*> told{winner_};
        for (const Group* g : rivals_) {
            if (alike.size() == most_alike) break;
            alike.push_back(g->best), told.push_back(g);
            for (const Term* t : g->best->h.terms)
                if (std::none_of(v_.effects.begin(), v_.effects.end(),
                                 [&](const Effect& e) { return e.name == t->effect; }))
                    v_.effects.push_back(effect_of(*g, *t));
        }
        std::stable_sort(told.begin(), told.end(), [](const Group* a, const Group* b) {
            return a->probability > b->probability;
        });
        for (const Group* g : told) v_.alike.push_back(g->effects);
        j_.report(0.9, "the next experiment");
        v_.next_experiment = next_experiment(j_.problem, j_.noise, alike, j_.settings.threads);
    }

    // Where a gate failed, or chance is not out: the best of the others.
    const Group& runner_up() const {
        for (const Group& g : groups_)
            if (&g != winner_ && !is_unknown(g)) return g;
        return groups_.back();
    }

    Effect effect_of(const Group& g, const Term& term) const {
        Effect e{.name = term.effect,
                 .probability = 0.0,
                 .named = false,
                 .parameters = {},
                 .gates = {},
                 .why = {},
                 .missing = {}};
        for (const Group& other : groups_)
            if (contains(other.effects, {term.effect})) e.probability += other.probability;
        if (term.missing_variable.empty())
            e.parameters = estimates(j_.problem, *j_.whiten, *g.best, term);
        else
            e.missing = missing_of(*g.best);
        return e;
    }

    // Nothing passed its own test: what is left of their probability is that of none of these.
    const Candidate& none_of_these() {
        constexpr double left = 0.1;
        v_.answer = Answer::unexplained;
        double moved = 0.0;
        for (Group& g : groups_)
            if (&g != unknown_) moved += (1.0 - left) * g.probability, g.probability *= left;
        if (unknown_) {
            unknown_->probability += moved;
            v_.effects.push_back(effect_of(*unknown_, *unknown_->best->h.terms.back()));
        } else {
            v_.effects.push_back({.name = "unknown",
                                  .probability = moved,
                                  .named = false,
                                  .parameters = {},
                                  .gates = {},
                                  .why = {},
                                  .missing = {}});
            v_.hypotheses.push_back({{"unknown"}, moved});
        }
        publish();
        return unknown_ ? *unknown_->best : j_.base;
    }

    void publish() {
        for (const Group& g : groups_) v_.hypotheses.push_back({g.effects, g.probability});
        std::stable_sort(
            v_.hypotheses.begin(), v_.hypotheses.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.probability > b.probability; });
    }
};

}  // namespace

const Candidate& decide(Judge& j) { return Decision(j).make(); }

}  // namespace diagnose
