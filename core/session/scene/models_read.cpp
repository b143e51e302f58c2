#include "core/session/scene/models_read.h"

#include "core/process/estimation/part_progress.h"
#include "core/session/opened_file.h"
#include "core/session/read_options.h"
#include "core/session/scene/scene_ply.h"

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

/// Fills what the file holds of the model; how it stands in the scene is there already.
static void fill(SceneModel& out, io::FileModel model, const std::filesystem::path& path, const json& parameters,
                 std::vector<std::string>& messages, const base::Progress& progress) {
    Provenance provenance = provenanceOf(model, path);
    OpenedFile file = opened(path.string(), std::move(model), parameters, process::part(progress, 0, 0.5));
    provenance.sampled = file.faces.sampled;
    provenance.closed = file.faces.closed;
    provenance.guessedSides = !file.ownNormals && file.model.faces == 0;
    MadeModel fresh = made(file, process::part(progress, 0.5, 1));
    provenance.merged = fresh.merged;
    out.layers = layersIn(provenance.comments, fresh.surface, file.model.messages);
    out.surface = std::move(fresh.surface);
    out.up = fresh.up;
    out.provenance = std::make_shared<Provenance>(std::move(provenance));
    messages.insert(messages.end(), file.model.messages.begin(), file.model.messages.end());
}

Scene modelsOf(io::FileModel whole, const std::filesystem::path& path, const json& parameters,
               std::vector<std::string>& messages, const base::Progress& progress) {
    std::vector<ScenePart> parts = partsOf(whole);
    Scene out;
    if (parts.empty()) {
        out.models.front().name = nameOf(path);
        fill(out.models.front(), std::move(whole), path, parameters, messages, progress);
        return out;
    }
    out.models.clear();
    for (std::size_t k = 0; k < parts.size(); ++k) {
        SceneModel model = std::move(parts[k].model);
        model.name = out.freshName(model.name);
        const double share = 1.0 / static_cast<double>(parts.size()), begin = share * static_cast<double>(k);
        fill(model, std::move(parts[k].file), path, parameters, messages,
             process::part(progress, begin, begin + share));
        if (parts[k].active)
            out.active = k;
        out.models.push_back(std::move(model));
    }
    return out;
}

Scene readModels(const std::filesystem::path& path, const std::filesystem::path& source, const json& parameters,
                 std::vector<std::string>& messages, const base::Progress& progress) {
    io::FileModel file = readFile(source, path.parent_path(), parameters, process::part(progress, 0, 0.4));
    return modelsOf(std::move(file), path, parameters, messages, process::part(progress, 0.4, 1));
}

} // namespace session
