// SPDX-License-Identifier: MIT
// What every verb shares: its options, where its results go, how it says who it is.
#pragma once

#include "reports/json.hpp"
#include "reports/page.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace app {

struct CommonOptions {
    std::string json;    // file, or "-" for standard output; empty: none
    std::string report;  // HTML file; empty: none
    std::string xlsx;    // workbook; empty: none
    std::uint64_t seed = 1;
    int threads = 0;  // 0: as many as there are cores
    bool resume = false, quiet = false;

    bool json_on_stdout() const { return json == "-"; }
};

// --json, --report, --seed, --threads, --resume, --quiet.
void add_common(CLI::App& verb, CommonOptions&);

// --xlsx, of verbs whose results are tables.
void add_workbook(CLI::App& verb, CommonOptions&);

int threads_of(const CommonOptions&);

// A verb as main sees it: which sub-command, and what to do when it was asked for. `run` returns an
// exit code.
struct Verb {
    CLI::App* app;
    std::function<int()> run;
};

reports::Provenance provenance(const std::string& command, const std::string& case_path);

// Writes JSON and page where the options ask for them. Throws as write_file.
void write_results(const CommonOptions&, const reports::Json&,
                   const std::function<reports::Page()>&);

// Text for a person, on standard output, unless that is taken by JSON or --quiet.
void print(const CommonOptions&, const std::string& text);

// Makes the folder where needed. Throws scaling::InvalidInput where the file cannot be written.
void write_file(const std::string& path, const std::string& text);

// What the shell gets for an answer: app/exit_code.hpp.
int exit_code_of(reports::Answer);

}  // namespace app
