#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/commands/commands.h"
#include "core/session/opened_file.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static Provenance provenanceOf(io::FileModel& model, const std::filesystem::path& path) {
    Provenance out;
    out.path = path;
    out.origin = model.origin;
    out.faces = model.faces;
    out.dropped = model.dropped;
    out.format = model.format;
    out.comments = std::move(model.comments);
    out.elements = std::move(model.elements);
    return out;
}

static void checkHash(Context& context, const json& complete, const base::Hash128& hash) {
    const auto wanted = complete.find("hash");
    if (wanted == complete.end() || *wanted == hash.text())
        return;
    const std::string path = complete.at("path").get<std::string>(),
                      what = "the file is not the one that was opened when this was recorded";
    if (!context.takesChangedFiles)
        throw base::Error(
            what, path,
            "restore that file, or go on with it as it is now: pointclay recover --anyway, or run --anyway");
    context.messages.push_back(path + ": " + what + "; it is taken as it is now");
}

static void open(Context& context, const json& complete) {
    const std::filesystem::path path = complete.at("path").get<std::string>();
    const std::filesystem::path source = complete.value("source", path.string());
    io::FileModel model = io::read(source, process::part(context.progress, 0, 0.4), path.parent_path());
    Provenance provenance = provenanceOf(model, path);
    OpenedFile file = opened(path.string(), std::move(model), complete, process::part(context.progress, 0.4, 0.7));
    provenance.sampled = file.faces.sampled;
    provenance.closed = file.faces.closed;
    provenance.guessedSides = !file.ownNormals && file.model.faces == 0;
    MadeModel fresh = made(file, process::part(context.progress, 0.7, 1));
    provenance.merged = fresh.merged;
    layers::Stack stack = layersIn(provenance.comments, fresh.surface, file.model.messages);
    checkHash(context, complete, contentHash(fresh.surface.tree(), provenance.origin, stack));
    context.messages.insert(context.messages.end(), file.model.messages.begin(), file.model.messages.end());
    context.document.reset(std::move(fresh.surface), std::move(provenance), fresh.up, std::move(stack));
}

CommandRow openCommand() {
    static const CommandParameter own[] = {
        {"path", "path", "", "file to open, in any readable format", "", "", 0, 0},
        {"hash", "text", "", "content hash that the opened model must have", "null", "", 0, 0},
        {"source", "path", "", "file to read in place of path, kept by a journal", "null", "", 0, 0},
    };
    static const auto parameters = [] {
        std::vector<CommandParameter> out(std::begin(own), std::end(own));
        out.insert(out.end(), faceParameters().begin(), faceParameters().end());
        return withSurfaceParameters(out);
    }();
    return {"open", "Open", "Opens a model and estimates what the file lacks.", parameters, true, true, open, nullptr};
}

} // namespace session
