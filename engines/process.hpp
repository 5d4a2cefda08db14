// SPDX-License-Identifier: MIT
// Other programs: where they are, and a run of one under a time limit.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace engines {

// The first executable file of this name on PATH; a name with a slash is looked up as it is.
std::optional<std::filesystem::path> find_program(const std::string& name);

struct Finished {
    int exit_code;         // 128 + the signal where one ended it, 127 where it could not be started
    bool timed_out;        // it was ended at the limit
    std::string out;       // standard output and error together, in the order in which they came
    double seconds;        // wall time
    bool stopped = false;  // by a signal to us
};

// Runs argv[0], found on PATH, in `folder`, without a shell, with nothing on standard input and in
// a process group of its own. At the limit the group gets SIGTERM, two seconds later SIGKILL; so
// too on SIGINT, SIGTERM or SIGHUP to us, which is then raised again for whoever handled it before.
// Handlers belong to the process: one call at a time.
// `watch`, where it is there, sees all output so far each time more of it has come.
Finished run(const std::vector<std::string>& argv, const std::filesystem::path& folder,
             double limit_s, const std::function<void(const std::string& out)>& watch = {});

// mpirun with so many ranks, without the program: as root it wants to be told that this is meant,
// and likewise where there are fewer cores than ranks.
std::vector<std::string> mpirun(int ranks);

// The words as they would be typed, quoted where a shell needs it.
std::string command_line(const std::vector<std::string>& argv);

}  // namespace engines
