#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/session/face_options.h"
#include "core/session/read_options.h"
#include "core/session/scene/models_read.h"
#include "core/session/scene/scene_file.h"
#include "core/session/surface_options.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

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

/// The journal gets the commands that make the scene, each with what it read.
static void openScene(Context& context, const std::filesystem::path& path) {
    Document scene;
    json lines = json::array();
    Context inner{scene, path.parent_path(), context.progress, {}, 0, {}, nullptr};
    inner.takesChangedFiles = context.takesChangedFiles;
    inner.recorded = [&](const json& line) {
        lines.push_back(line);
        if (line.at("op") == "open")
            lines.back()["hash"] = scene.hash().text();
    };
    for (const json& each : sceneCommands(path, inner.messages)) {
        std::error_code none;
        if (const std::string file = each.value("path", std::string());
            !file.empty() && !std::filesystem::exists(file, none))
            throw base::Error("its model " + file + " is not there", path.string(),
                              "put it back, or take it out of the scene file");
        run(inner, each);
    }
    for (const std::string& message : inner.messages) // what is true of several models is told once
        if (std::ranges::find(context.messages, message) == context.messages.end())
            context.messages.push_back(message);
    context.document.reset(scene.scene(), path);
    context.instead = std::make_shared<json>(std::move(lines));
}

static void open(Context& context, const json& complete) {
    const std::filesystem::path path = complete.at("path").get<std::string>();
    if (opensAsScene(path)) {
        refuseReadParameters(complete, path.string());
        return openScene(context, path);
    }
    Scene scene =
        readModels(path, complete.value("source", path.string()), complete, context.messages, context.progress);
    checkHash(context, complete, contentHash(scene));
    context.document.reset(std::move(scene), path);
}

CommandRow openCommand() {
    static const CommandParameter own[] = {
        {"path", "path", "", "file to open, in any readable format", "", "", 0, 0},
        {"hash", "text", "", "content hash that the opened model must have", "null", "", 0, 0, true},
        {"source", "path", "", "file to read in place of path, kept by a journal", "null", "", 0, 0, true},
    };
    static const auto parameters = [] {
        std::vector<CommandParameter> out(std::begin(own), std::end(own));
        out.insert(out.end(), readParameters().begin(), readParameters().end());
        out.insert(out.end(), faceParameters().begin(), faceParameters().end());
        return withSurfaceParameters(out);
    }();
    return {"open", "Open", "Opens a model and estimates what the file lacks.", parameters, true, true, open, nullptr};
}

} // namespace session
