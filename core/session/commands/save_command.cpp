#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/session/commands/commands.h"
#include "core/session/journal.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// PLY is the native format: what it holds is all there is. In other formats the document remains unsaved.
static bool isNative(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension == ".ply";
}

static void save(Context& context, const json& complete) {
    requireModel(context);
    const std::filesystem::path path = complete.at("path").get<std::string>();
    std::error_code unequal;
    if (context.journal && std::filesystem::equivalent(path, context.journal->path(), unequal))
        throw base::Error("is the journal of this session, which the model would replace", path.string(),
                          "choose another name");
    if (context.journal)
        context.journal->keepSource(path, context);
    const bool linked = io::hasOtherNames(path);
    io::write(path, context.document.fileModel(), context.progress);
    if (linked)
        context.messages.push_back(path.string() +
                                   ": other names of this file (hard links) still hold what it held before");
    if (isNative(path))
        context.document.saved(path);
}

CommandRow saveCommand() {
    static const CommandParameter parameters[] = {
        {"path", "path", "", "file to write; its extension selects the format, .ply keeps everything", "", "", 0, 0},
    };
    return {"save", "Save", "Writes the model to a file.", parameters, false, false, save, nullptr};
}

} // namespace session
