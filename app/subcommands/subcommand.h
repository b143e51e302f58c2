// A subcommand is one row of a table (subcommand_table.cpp): name, what it does, an example, and a function that adds
// its options and returns what runs once they are parsed. One file per subcommand; `--help` and tests loop over the
// table.
#pragma once

#include "app/command_line.h"
#include "app/console.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <span>

namespace app {

/// The work of a subcommand. Throws base::Error (exit code 1), UsageError (2), base::Cancelled (1).
using Action = std::function<void(Console&)>;

struct SubcommandRow {
    const char* name;
    const char* tip;
    const char* example;
    Action (*add)(CLI::App& command);
};

std::span<const SubcommandRow> subcommandTable();

Action addInfo(CLI::App& command);
Action addConvert(CLI::App& command);
Action addClean(CLI::App& command);
Action addMeasure(CLI::App& command);
Action addRegister(CLI::App& command);
Action addResample(CLI::App& command);
Action addQuery(CLI::App& command);
Action addIntersect(CLI::App& command);
Action addBoundary(CLI::App& command);
Action addSection(CLI::App& command);
Action addMesh(CLI::App& command);
Action addHaptic(CLI::App& command);
Action addFill(CLI::App& command);
Action addCut(CLI::App& command);
Action addSolid(CLI::App& command);
Action addReduce(CLI::App& command);
Action addRefine(CLI::App& command);
Action addRender(CLI::App& command);
Action addRun(CLI::App& command);
Action addRecover(CLI::App& command);
Action addBench(CLI::App& command);

} // namespace app
