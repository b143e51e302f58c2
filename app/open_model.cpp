#include "app/open_model.h"

#include "core/process/samples/samples.h"
#include "core/session/face_options.h"
#include "core/session/model_argument.h"
#include "core/session/read_options.h"
#include "core/session/scene/scene_file.h"
#include "core/session/scene/scene_ply.h"

#include <nlohmann/json.hpp>

namespace app {

/// "-" is what comes in by a pipe.
static nlohmann::json commandOf(const std::string& model) {
    return session::modelCommand(model == "-" ? "/dev/stdin" : model);
}

io::FileModel readModel(const std::string& model, const nlohmann::json& parameters, const base::Progress& progress) {
    const nlohmann::json command = session::complete(commandOf(model));
    const bool file = command.at("op") == "open";
    if (!file || session::opensAsScene(model))
        session::refuseReadParameters(parameters, model);
    if (file && session::opensAsScene(model)) {
        session::Document document;
        session::Context context{document, {}, progress, {}, 0, {}, nullptr};
        session::run(context, command);
        return session::togetherAsParts(document.scene());
    }
    if (file)
        return session::readFile(command.at("path").get<std::string>(), {}, parameters, progress);
    const process::SampleRow& sample = process::sample(command.at("sample").get<std::string>());
    io::FileModel out;
    const std::size_t count = command.value("count", sample.count);
    out.points = sample.make(count, command.at("seed").get<std::uint64_t>());
    if (sample.manifold == surface::Manifold::Complex)
        out.definition = process::definitionOf(sample, count);
    out.up = base::UpAxis::Y; // samples stand as they are made
    out.format = std::string("sample ") + sample.id;
    return out;
}

void standInScene(session::Context& context) {
    const session::Scene& scene = context.document.scene();
    const session::SceneModel active = scene.models[scene.active];
    if (session::isNothing(active.pose))
        return;
    if (active.locked)
        session::run(context, {{"op", "scene"}, {"do", "unlock"}});
    if (!active.visible)
        session::run(context, {{"op", "scene"}, {"do", "show"}});
    session::run(context, {{"op", "scene"}, {"do", "apply"}});
    if (!active.visible)
        session::run(context, {{"op", "scene"}, {"do", "hide"}});
}

void openModel(session::Context& context, const std::string& model, const nlohmann::json& surface, Console& console,
               SceneUse use) {
    nlohmann::json command = commandOf(model);
    command.update(surface);
    if (command.at("op") != "open") { // a sample has no faces
        session::refuseSamples(session::faceOptions(command), model);
        session::refuseReadParameters(command, model);
        for (const session::CommandParameter& p : session::faceParameters())
            command.erase(p.id);
    }
    session::run(context, command);
    if (use != SceneUse::AsItIs)
        standInScene(context);
    const session::Scene& scene = context.document.scene();
    if (scene.models.size() > 1 && use == SceneUse::Active)
        context.messages.push_back("A scene of " + std::to_string(scene.models.size()) + " models: this is about \"" +
                                   scene.models[scene.active].name + "\" alone, the active one, where it stands.");
    console.tell(context.messages);
    context.messages.clear();
}

surface::Surface shifted(const surface::Surface& surface, const base::Vec3d& by) {
    if (by == base::Vec3d{})
        return surface;
    surfel::SurfelList list = surface.tree().surfels();
    for (surfel::Surfel& surfel : list.items)
        surfel.position = base::cast<float>(base::cast<double>(surfel.position) + by);
    return {tree::SurfelTree::build(list), surface.definition()};
}

} // namespace app
