#include "core/session/commands/other_model.h"

#include "core/session/commands/commands.h"
#include "core/session/files_read.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

Document otherModel(Context& context, const json& complete, std::size_t number, const base::Progress& progress) {
    const std::string path = filesNamed(complete).at(number);
    Document out;
    Context inner{out, context.folder, progress, {}, 0, {}, nullptr};
    run(inner, {{"op", "open"}, {"path", path}, {"source", filesRead(complete).at(number)}});
    json hashes = complete.value("hashes", json::array());
    if (complete.contains("hash"))
        hashes.push_back(complete.at("hash"));
    if (number < hashes.size())
        requireRecorded(context, hashes[number], out.hash(), path);
    return out;
}

CommandParameter sourcesParameter() {
    return {"sources", "paths", "",  "files to read in place of those that are named, kept by a journal", "null", "",
            0,         0,       true};
}

} // namespace session
