// A subcommand is one row of a table (subcommand_table.cpp): name, what it does, an example, and a function that adds
// its options and returns what runs once they are parsed. One file per subcommand; `--help` and tests loop over the
// table.
#pragma once

#include "app/console.h"
#include "app/options/option_set.h"
#include "app/usage_error.h"

#include <functional>
#include <span>

namespace app {

/// The work of a subcommand. Throws base::Error (exit code 1), UsageError (2), base::Cancelled (1).
using Action = std::function<void(Console&)>;

struct SubcommandRow {
    const char* name;
    const char* tip;
    const char* example;
    Action (*add)(OptionSet command);
};

std::span<const SubcommandRow> subcommandTable();

Action addInfo(OptionSet command);
Action addConvert(OptionSet command);
Action addClean(OptionSet command);
Action addMeasure(OptionSet command);
Action addRegister(OptionSet command);
Action addResample(OptionSet command);
Action addShapes(OptionSet command);
Action addQuery(OptionSet command);
Action addIntersect(OptionSet command);
Action addBoundary(OptionSet command);
Action addSeams(OptionSet command);
Action addSection(OptionSet command);
Action addMesh(OptionSet command);
Action addHaptic(OptionSet command);
Action addFill(OptionSet command);
Action addCut(OptionSet command);
Action addTrim(OptionSet command);
Action addTube(OptionSet command);
Action addMerge(OptionSet command);
Action addSolid(OptionSet command);
Action addCrease(OptionSet command);
Action addRefine(OptionSet command);
Action addReduce(OptionSet command);
Action addRender(OptionSet command);
Action addRun(OptionSet command);
Action addRecover(OptionSet command);
Action addBench(OptionSet command);

} // namespace app
