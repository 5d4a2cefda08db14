// SPDX-License-Identifier: MIT
// A pile that Python steps, and whose grains it sees in place.
#pragma once

#include "cases/case.hpp"
#include "python/answer.hpp"
#include "rigs/pile.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <pybind11/numpy.h>
#include <string>

namespace python {

struct PileOptions {
    std::string experiment;  // empty: the case's first pile
    std::uint64_t seed = 1;
    int threads = 0;  // 0: as many as there are cores
    bool sleep = false, yes = false;
    std::string command;
};

class Pile : public std::enable_shared_from_this<Pile> {
  public:
    // Throws scaling::InvalidInput as `similitude simulate` does.
    Pile(const std::string& case_path, const PileOptions&);

    // At most `steps` more, fewer where the run comes to its end. Without Python's lock, which it takes a few times a
    // second to see whether a signal came: then it throws what Python's handler raised, between two steps, and may be
    // called again. Throws std::runtime_error where another thread is stepping.
    void advance(std::int64_t steps);

    // The core's own array, read-only, without a copy. It stays as it is when the pile goes on: the pile then goes on
    // with a copy. Order of the core, see id.
    template <class Array>
    pybind11::array view(Array dem_min::Particles::*array);

    const rigs::PileRun& run() const;  // throws std::runtime_error while another thread is stepping
    const rigs::PileSetup& setup() const { return setup_; }
    const std::string& id() const { return id_; }

    const rigs::PileRecord& record();  // throws std::runtime_error before the end
    Answer answer();                   // likewise
    std::string status() const;        // one line, at any time

  private:
    struct Loan {
        std::weak_ptr<void> holder;
        std::function<void(void*)> hand_over;
    };

    void hand_over_loans();

    cases::Case case_;
    std::string id_;
    PileOptions options_;
    rigs::PileSetup setup_;
    rigs::PileRun run_;
    bool busy_ = false;  // guarded by Python's lock
    std::map<const void*, Loan> loans_;
    std::optional<rigs::PileRecord> record_;
};

void bind_pile(pybind11::module_&);

}  // namespace python
