// A session file: one command as a JSON object per line (session/README 3). Macro, journal, script and test are the
// same format, read here and nowhere else.
//
// Empty lines and lines that begin with # are skipped. Lines are executed one by one; the first that fails ends the
// session with its number in the message, and nothing after it is executed.
#pragma once

#include "core/session/command.h"

#include <functional>

namespace session {

/// What one line did.
struct LineReport {
    int line = 0; ///< counted from 1
    std::string op;
    double seconds = 0;
    std::size_t surfels = 0; ///< of the model afterwards
    std::vector<double> dabSeconds;
};

struct ReplayOptions {
    /// A last line that a crash has torn (no newline, or no JSON) is left out instead of refused.
    bool allowTornEnd = false;
    std::function<void(const LineReport&)> done; ///< after each line; may be empty
    /// Told of a line behind the first command that fails, which is then passed over; empty: it ends the session.
    std::function<void(const base::Error&)> passedOver = {};
    std::function<void(int line)> torn = {}; ///< told of the torn line's number; may be empty
};

/// Executes the session in `context`, whose folder becomes the file's. Throws base::Error naming file and line,
/// base::Cancelled. Returns the number of commands executed.
int replay(const std::filesystem::path& file, Context& context, const ReplayOptions& options = {});

} // namespace session
