// SPDX-License-Identifier: MIT
// A blind case of heaps: what is poured for it, its files, its key.
#pragma once

#include "prove/blind_case.hpp"
#include "prove/heap_response.hpp"

#include <map>
#include <string>
#include <vector>

namespace prove {

// What is concealed, with everything that is still free decided.
struct HeapSecret {
    HeapPlan plan;  // with the friction of a cancelling one
    Oracle oracle;
};
// `responses`: of all arrangements of the family.
HeapSecret heap_secret(std::uint64_t seed, const HeapPlan&, const HeapFamily&,
                       const std::vector<Response>& responses);

// The recordings of a case: `repeats` of each arrangement that is fitted, then one of the last, held out.
struct HeapRecording {
    std::string id;
    std::size_t arrangement;
    bool held_out;
    Pour pour;
};
std::vector<HeapRecording> heap_recordings(std::uint64_t seed, const HeapPlan&, const HeapFamily&);

// What the scanner writes down: heights of the heap, measurement effect and instrument noise added, m.
std::vector<double> recorded(std::uint64_t seed, const HeapPlan&, const Arrangement&,
                             const std::vector<double>& heights, std::size_t recording);

// name -> content; `rows`: of every recording.
std::map<std::string, std::string> heap_files(const HeapPlan&, const HeapFamily&,
                                              const std::vector<HeapRecording>&,
                                              const std::vector<std::vector<double>>& rows);

// `rows` of the held-out recording, for the noise floor.
Key heap_key(const HeapSecret&, const HeapFamily&, const std::vector<Response>&,
             const std::vector<double>& rows);

}  // namespace prove
