// What both programs share: `pointclay`, which has the subcommands and no Qt, and `pointclay-window`, which it becomes
// without one. The same options, and the one door for errors: exit code 0 done, 1 the input or the data is at fault,
// 2 wrong usage.
#pragma once

#include "app/usage_error.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct CommonOptions {
    int threads = 0;
    bool quiet = false;
    std::vector<std::string> models; ///< to open in windows
};

/// --threads and --quiet.
void addCommon(CLI::App& command, CommonOptions& options);
/// What it is, its version, the common options and the models.
void describe(CLI::App& program, CommonOptions& options);

/// Tells it on stderr, without memory of its own; returns the code.
int fail(std::string_view message, int code);
/// Turns what the work throws into an exit code.
int guarded(const std::function<int()>& work);
/// Fills in the options; with an exit code where there is nothing left to do (--help, --version, wrong usage).
std::optional<int> parse(CLI::App& program, int argc, char** argv);

} // namespace app
