// Commands: everything a person can do to a model, as data. One table; menus, command line, manual and tests loop over
// it.
//
// A command line of a session file is {"op": NAME, ...parameters} (INTERFACES, Sessions). `run` checks it against the
// row (unknown op or parameter, wrong type, out of range: base::Error), executes it and leaves the document unchanged
// on failure.
#pragma once

#include "core/base/progress.h"
#include "core/session/document.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace session {

struct CommandParameter {
    const char* id;
    const char* type; ///< "path", "number", "integer", "boolean", "choice", "list", "text"
    const char* unit;
    const char* tip;
    const char* fallback; ///< as JSON text; "" where the parameter is required, "null" where it may be left out
    const char* choices;  ///< for "choice": separated by blanks
    double min, max;      ///< for numbers
};

/// What a command may use beside its parameters.
struct Context {
    Document& document;
    std::filesystem::path folder; ///< relative paths start here
    base::Progress progress;
    std::vector<std::string> messages; ///< for the person, appended by commands
    /// Filled by strokes for timings.
    int dabs = 0;
    std::vector<double> dabSeconds;
};

struct CommandRow {
    const char* op;
    const char* label;
    const char* tip;
    std::span<const CommandParameter> parameters;
    bool changesModel; ///< journalled
    void (*run)(Context&, const nlohmann::json& complete);
};

std::span<const CommandRow> commandTable();
const CommandRow& command(std::string_view op);

/// Checks, completes with defaults and executes one command. Debug builds validate the tree afterwards.
void run(Context& context, const nlohmann::json& command);

} // namespace session
