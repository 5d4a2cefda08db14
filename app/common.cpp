// SPDX-License-Identifier: MIT
#include "app/common.hpp"

#include "app/exit_code.hpp"
#include "app/version.hpp"
#include "scaling/errors.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

namespace app {

void add_common(CLI::App& verb, CommonOptions& options) {
    verb.add_option("--json", options.json,
                    "write the result as JSON to FILE, or to standard output with -")
        ->type_name("FILE");
    verb.add_option("--report", options.report, "write a self-contained HTML page")
        ->type_name("FILE.html");
    verb.add_option("--seed", options.seed, "what chance starts from")->capture_default_str();
    verb.add_option("--threads", options.threads,
                    "0: as many as there are cores and work for; results do not depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    verb.add_flag("--resume", options.resume, "go on from the checkpoint of an interrupted run");
    verb.add_flag("--quiet", options.quiet, "no table and no progress");
}

void add_workbook(CLI::App& verb, CommonOptions& options) {
    verb.add_option("--xlsx", options.xlsx, "write the tables as a workbook, units in columns")
        ->type_name("FILE.xlsx");
}

int threads_of(const CommonOptions& options) {
    if (options.threads > 0) return options.threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

reports::Provenance provenance(const std::string& command, const std::string& case_path) {
    return {.version = version,
            .git = git,
            .compiler = compiler,
            .command = command,
            .case_path = case_path,
            .seeds = {},
            .threads = std::nullopt};
}

void write_file(const std::string& path, const std::string& text) {
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code ignored;  // the opening below says what is wrong
    if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw scaling::InvalidInput(scaling::mistake(path, "a place that cannot be written",
                                                     "must be writable",
                                                     "choose another file or folder"));
}

void write_results(const CommonOptions& options, const reports::Json& json,
                   const std::function<reports::Page()>& page) {
    const std::string text = reports::text_of(json);
    if (options.json_on_stdout())
        std::fwrite(text.data(), 1, text.size(), stdout);
    else if (!options.json.empty())
        write_file(options.json, text);
    if (options.report.empty()) return;
    reports::Page made = page();
    made.data = text;
    write_file(options.report, reports::html(made));
}

void print(const CommonOptions& options, const std::string& text) {
    if (options.quiet || options.json_on_stdout()) return;
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

int exit_code_of(reports::Answer answer) {
    switch (answer) {
        case reports::Answer::yes:
            return fine;
        case reports::Answer::no:
            return answer_is_no;
        case reports::Answer::cannot_tell:
            return cannot_tell;
        case reports::Answer::outside_validity:
            return outside_validity;
    }
    return internal_fault;
}

}  // namespace app
