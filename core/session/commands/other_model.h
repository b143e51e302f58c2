// Other models that a command reads beside the document's. What they were is pinned by content hashes, which journals
// always have; where a journal keeps their files it is read from the copies. Inside this room only.
#pragma once

#include "core/session/command.h"

namespace session {

/// The one of that number among the files that the command names (files_read.h), opened as `open` does it. Throws
/// base::Error where it cannot be, or where "hash" or "hashes" tell of another model.
Document otherModel(Context& context, const nlohmann::json& complete, std::size_t number,
                    const base::Progress& progress);

/// Of commands with one and with several: files that a journal keeps.
CommandParameter sourcesParameter();

} // namespace session
