// After a crash: journals whose process has died, and the model as of their last command.
#pragma once

#include "core/session/command.h"

namespace session {

/// A journal that nobody holds any more.
struct LeftJournal {
    std::filesystem::path path;
    std::filesystem::path model; ///< what it opened; empty for a model made by code
    std::filesystem::file_time_type time;
    int commands = 0; ///< after the first, which opened or made the model: 0 means that nothing is lost
};

/// Left journals of `folder`, newest first. Unreadable and empty ones are left out.
std::vector<LeftJournal> findLeftJournals(const std::filesystem::path& folder);
/// Those of stateFolder().
std::vector<LeftJournal> findLeftJournals();

/// What became of a journal's lines.
struct Recovery {
    int commands = 0; ///< executed
    int leftOut = 0;  ///< failed and passed over
    /// What the history calls the steps, and how many there were of each, in the order of their first.
    std::vector<std::pair<std::string, int>> steps = {};
};

/// Brings the model of a journal back into `context`, whose own journal, if any, records it anew. The journal itself
/// stays; remove it with removeJournal once the model is safe. Lines behind the first that fail are passed over and
/// named in the context's messages, as is a last line that a crash has torn, which is not counted. Throws base::Error
/// where it holds no command, or where the file that it opens is gone or, unless the context takes changed files, has
/// changed.
Recovery recover(const std::filesystem::path& journal, Context& context);

} // namespace session
