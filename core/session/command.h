// Commands: everything a person can do to a model, as data. One table; menus, command line, manual and tests loop over
// it.
//
// A command line of a session file is {"op": NAME, ...parameters} (session/README 3). `run` checks it against the
// row (unknown op or parameter, wrong type, out of range: base::Error), executes it and leaves the document unchanged
// on failure. What completed and changed the model goes to the context's journal.
//
//     window, command line, session file --json--> run --complete json--> CommandRow::run --> Document
//                                                   |
//                                                   +--> Journal::record
#pragma once

#include "core/base/progress.h"
#include "core/session/document.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>

namespace session {

class Journal;

struct CommandParameter {
    const char* id;
    /// "path", "paths", "number", "integer", "boolean" (true, false, "on" or "off"), "choice", "number or choice",
    /// "list" or "text". Paths are absolute when the command sees them, and several of them ("paths") always a list.
    const char* type;
    const char* unit;
    const char* tip;
    const char* fallback;  ///< as JSON text; "" where the parameter is required, "null" where it may be left out
    const char* choices;   ///< for choices: separated by blanks
    double min, max;       ///< for numbers
    bool recorded = false; ///< journals fill it in, so that dialogs do not ask for it
    /// Ends that stand for "any number above zero" and "any number that float32 holds".
    static constexpr double positive = std::numeric_limits<float>::min();
    static constexpr double largest = std::numeric_limits<float>::max();
};

/// What a command may use beside its parameters.
struct Context {
    Document& document;
    std::filesystem::path folder; ///< relative paths start here; empty: the working folder
    base::Progress progress;
    std::vector<std::string> messages; ///< for the person, appended by commands
    /// Filled by strokes for timings.
    int dabs = 0;
    std::vector<double> dabSeconds;
    Journal* journal = nullptr; ///< null: nothing is journalled
    /// `open` takes a file that is not the one that was recorded, and says so.
    bool takesChangedFiles = false;
    /// What commands counted and measured, by name: the numbers of their messages, for reports.
    std::map<std::string, double> figures = {};
    /// The commands that the journal gets in place of the one that runs: a list, which replays to the same bits. Set by
    /// commands whose own lines would not.
    std::shared_ptr<nlohmann::json> instead = {};
    /// Told of each completed command that changed the model, as the journal has it.
    std::function<void(const nlohmann::json& complete)> recorded = {};
};

/// What a command does to parts of the model that are hidden (selection/README 10).
enum class HiddenParts {
    Included, ///< the model is one: they change along with it, and the executor says how many surfels that were
    Spared    ///< they keep their shape, colour and mask
};

struct CommandRow {
    const char* op;
    const char* label;
    const char* tip;
    std::span<const CommandParameter> parameters;
    bool changesModel; ///< journalled
    bool startsModel;  ///< replaces the document: the journal begins anew
    void (*run)(Context&, const nlohmann::json& complete);
    /// Parameters that depend on others (a tool's own): throws base::Error for one that is unknown or out of range.
    /// Null where there are none.
    void (*checkFurther)(const nlohmann::json& command, const std::string& key, const nlohmann::json& value);
    HiddenParts hidden = HiddenParts::Included;
};

std::span<const CommandRow> commandTable();
/// Throws base::Error naming the known commands.
const CommandRow& command(std::string_view op);

/// The command checked and completed: defaults filled in, booleans as such, paths absolute. Throws base::Error.
nlohmann::json complete(const nlohmann::json& command, const std::filesystem::path& folder = {});

/// Checks, completes with defaults and executes one command. Debug builds validate the tree afterwards.
void run(Context& context, const nlohmann::json& command);
/// Journals a completed command that changed the model, and tells whoever wants to know.
void record(Context& context, const nlohmann::json& complete);

} // namespace session
