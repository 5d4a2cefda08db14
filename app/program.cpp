// SPDX-License-Identifier: MIT
#include "app/program.hpp"

#include "app/advise.hpp"
#include "app/bench.hpp"
#include "app/calibrate.hpp"
#include "app/convert.hpp"
#include "app/diagnose.hpp"
#include "app/exit_code.hpp"
#include "app/export.hpp"
#include "app/measure.hpp"
#include "app/photo.hpp"
#include "app/prove.hpp"
#include "app/scale.hpp"
#include "app/simulate.hpp"
#include "app/verify.hpp"
#include "app/version.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace app {

namespace {

// As typed, with quotes where the shell needs them.
std::string command_line(int argc, char** argv) {
    std::string line = "similitude";
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const bool plain =
            !word.empty() && word.find_first_of(" \t'\"$^*()<>|&;`\\") == std::string::npos;
        line += plain ? " " + word : " \"" + word + "\"";
    }
    return line;
}

std::string one_line(std::string text) {
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

int complain(const std::string& what, int code) {
    fmt::print(stderr, "similitude: {}\n", one_line(what));
    return code;
}

// What is typed where a verb should stand; empty where nothing is.
std::string missing_verb(const std::vector<Verb>& verbs, const std::string& typed) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs) names.push_back(verb.app->get_name());
    const std::string rule = "must be one of " + scaling::joined(names);
    if (typed.empty())
        return scaling::mistake("verb", "none", rule, "similitude --help says what each does");
    return scaling::mistake("verb", '"' + typed + '"', rule,
                            "did you mean " + scaling::nearest_name(typed, names) + "?");
}

// Help and version are no mistakes; anything else that CLI11 throws is the user's.
int explain(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::string verb;
    for (const CLI::App* sub : app.get_subcommands()) verb = " " + sub->get_name();
    return complain(fmt::format("{} (see similitude{} --help)", error.what(), verb), bad_input);
}

}  // namespace

int program(int argc, char** argv, const Judge& judge) {
    CLI::App cli{
        "Scale factors, adhesion and similarity checks for simulations of cohesive powders",
        "similitude"};
    cli.set_version_flag("--version", fmt::format("similitude {} ({})", version, git));
    cli.require_subcommand(1);
    const std::string command = command_line(argc, argv);
    std::vector<Verb> verbs = {
        scale_verb(cli, command),     simulate_verb(cli, command), verify_verb(cli, command),
        bench_verb(cli, command),     prove_verb(cli, command),    convert_verb(cli, command),
        photo_verb(cli, command),     measure_verb(cli, command),  export_verb(cli, command),
        calibrate_verb(cli, command), advise_verb(cli, command)};
    if (judge) verbs.push_back(diagnose_verb(cli, command, judge));
    try {
        cli.parse(argc, argv);
        for (const Verb& verb : verbs)
            if (verb.app->parsed()) return verb.run();
    } catch (const CLI::RequiredError& error) {
        if (!cli.get_subcommands().empty()) return explain(cli, error);
        return complain(missing_verb(verbs, argc > 1 ? argv[1] : ""), bad_input);
    } catch (const CLI::ParseError& error) {
        return explain(cli, error);
    } catch (const scaling::InvalidInput& error) {
        return complain(error.what(), bad_input);
    } catch (const scaling::InvalidParameter& error) {
        return complain(error.what(), bad_input);
    } catch (const std::exception& error) {
        return complain(error.what(), internal_fault);
    }
    return internal_fault;
}

}  // namespace app
