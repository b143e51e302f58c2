// pointclay info: what is in a model, as text or as JSON (app/README 2.2).
#include "app/open_model.h"
#include "app/options/surface_options.h"
#include "app/subcommands/scene_info.h"
#include "app/subcommands/subcommand.h"
#include "core/base/error.h"
#include "core/cells/cell_surface.h"
#include "core/mesh/surface_traits.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing.h"
#include "core/selection/field.h"
#include "core/session/document.h"
#include "core/session/opened_file.h"
#include "core/session/scene/models_read.h"
#include "core/session/scene/scene_file.h"
#include "core/session/scene/scene_ply.h"
#include "core/surfel/shape.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

using nlohmann::ordered_json;

namespace {

struct InfoArguments {
    std::string model;
    bool json = false;
    std::shared_ptr<SurfaceOptions> surface;
};

ordered_json vectorOf(const base::Vec3d& v) {
    return {v.x, v.y, v.z};
}

ordered_json summaryOf(const std::vector<float>& values) {
    const process::Summary s = process::summarise(values);
    return {{"min", s.min}, {"median", s.median}, {"max", s.max}};
}

base::Box3f boundsOf(const surfel::SurfelList& points) {
    base::Box3f out;
    for (const surfel::Surfel& s : points.items)
        out.extend(s.position);
    return out;
}

bool anyEllipsoid(const surfel::SurfelList& points) {
    if (surfel::shapeChannel(*points.layout) == 0)
        return false;
    const std::size_t first = surfel::shapeWord(*points.layout);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (surfel::shapeIn(points.extraOf(i), first) != base::Vec3f())
            return true;
    return false;
}

/// Support radii, hash and what is up are those of the model that `open` makes; null where the points make none.
void describeSurface(ordered_json& out, session::OpenedFile file, const base::Progress& progress, Console& console) {
    out["up"] = out["hash"] = nullptr;
    try {
        const std::size_t told = file.model.messages.size();
        const session::MadeModel made = session::made(file, process::part(progress, 0, 0.8));
        for (std::size_t k = told; k < file.model.messages.size(); ++k)
            console.tell(file.model.messages[k]);
        const surfel::SurfelList surfels = made.surface.tree().surfels();
        if (made.merged > 0) {
            out["surfels"] = surfels.size();
            out["spacing"] = summaryOf(process::spacings(surfels.items, process::part(progress, 0.8, 1)));
        }
        out["merged"] = made.merged;
        const surface::SurfaceDefinition& definition = made.surface.definition();
        if (file.model.faces == 0) // of faces these themselves tell
            out["closed"] =
                mesh::SurfaceTraits(made.surface).closed && definition.manifold == surface::Manifold::Surface;
        out["cells"] = definition.manifold == surface::Manifold::Complex ? definition.connectivity->cells.size()
                                                                         : cells::countCells(surfels).cells;
        out["shapes"] = anyEllipsoid(surfels);
        countParts(out, made.surface.tree());
        std::vector<float> supports;
        for (const surfel::Surfel& s : surfels.items)
            supports.push_back(s.support);
        out["support"] = summaryOf(supports);
        out["up"] = base::upRow(made.up).id;
        std::vector<std::string> comments = file.model.comments, said;
        surface::Surface surface = made.surface;
        const layers::Stack stack = session::layersIn(comments, surface, said);
        for (const layers::Layer& each : stack.layers) // no key where there are none
            out["layers"].push_back({{"name", each.name}, {"strength", each.strength}, {"visible", each.visible}});
        out["hash"] = session::contentHash(surface.tree(), file.model.origin, stack).text();
    } catch (const base::Error& error) {
        console.tell(error.message());
    }
}

/// Normals that come of the faces are not the file's, and are told neither here nor as `normals`.
std::vector<std::string> attributesOf(const session::OpenedFile& from) {
    std::vector<std::string> out = from.model.points.layout->names();
    if (!from.ownNormals)
        std::erase(out, "normal");
    return out;
}

ordered_json describe(session::OpenedFile from, const base::Progress& progress, Console& console) {
    const io::FileModel& model = from.model;
    const base::Box3f box = boundsOf(model.points);
    ordered_json out;
    out["surfels"] = model.points.size();
    out["bounds"] = {{"min", vectorOf(base::cast<double>(box.lo) + model.origin)},
                     {"max", vectorOf(base::cast<double>(box.hi) + model.origin)}};
    out["origin"] = vectorOf(model.origin);
    out["spacing"] = summaryOf(process::spacings(model.points.items, process::part(progress, 0.3, 0.5)));
    out["support"] = nullptr;
    out["normals"] = from.ownNormals;
    out["attributes"] = attributesOf(from);
    out["faces"] = model.faces;
    out["sampled"] = from.faces.sampled;
    out["closed"] = from.faces.closed;
    out["dropped"] = model.dropped;
    out["merged"] = 0;
    out["cells"] = 0;
    out["shapes"] = false;
    out["format"] = model.format;
    describeSurface(out, std::move(from), process::part(progress, 0.5, 1), console);
    return out;
}

std::string asText(const ordered_json& value) {
    if (value.is_string())
        return value.get<std::string>();
    if (value.is_boolean())
        return value.get<bool>() ? "yes" : "no";
    if (value.is_null())
        return "none";
    if (!value.is_structured())
        return value.dump();
    std::string out;
    for (const auto& [key, part] : value.items())
        out += (out.empty() ? "" : value.is_array() ? " " : ", ") + (value.is_object() ? key + " " : "") + asText(part);
    return out;
}

void print(const ordered_json& info, bool json) {
    if (json)
        std::cout << info.dump(2, ' ', false, ordered_json::error_handler_t::replace) << "\n";
    else
        for (const auto& [key, value] : info.items())
            if (key == "normals" && value == false && info.at("faces") != 0)
                std::cout << "normals     no, opening gives those of the faces\n";
            else if (key != "models")
                std::cout << key << std::string(12 - key.size(), ' ') << asText(value) << "\n";
            else
                for (ordered_json model : value) {
                    model.erase("matrix"); // --json has it
                    std::cout << "model       " << asText(model) << "\n";
                }
}

void describeFile(const InfoArguments& options, io::FileModel model, const base::Progress& progress, Console& console) {
    session::OpenedFile file = session::opened(options.model, std::move(model), options.surface->parameters(),
                                               process::part(progress, 0.2, 0.3));
    console.tell(file.model.messages);
    const ordered_json info = describe(std::move(file), progress, console);
    console.clear();
    print(info, options.json);
}

void describeScene(const session::Scene& scene, bool json, Console& console) {
    const ordered_json info = infoOf(scene);
    console.clear();
    print(info, json);
}

void describeSceneFile(const InfoArguments& options, const base::Progress& progress, Console& console) {
    session::Document document;
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    openModel(context, options.model, options.surface->parameters(), console, SceneUse::AsItIs);
    describeScene(document.scene(), options.json, console);
}

void describeParts(const InfoArguments& options, io::FileModel file, const base::Progress& progress, Console& console) {
    std::vector<std::string> messages;
    const session::Scene scene =
        session::modelsOf(std::move(file), options.model, options.surface->parameters(), messages, progress);
    console.tell(messages);
    describeScene(scene, options.json, console);
}

} // namespace

Action addInfo(OptionSet command) {
    auto options = std::make_shared<InfoArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.addFlag("--json", options->json, "print a JSON object, lengths in model units");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) {
        const base::Progress progress = console.progress();
        if (session::opensAsScene(options->model))
            return describeSceneFile(*options, progress, console);
        io::FileModel model =
            readModel(options->model, options->surface->parameters(), process::part(progress, 0, 0.2));
        if (session::tellsOfParts(model))
            describeParts(*options, std::move(model), process::part(progress, 0.2, 1), console);
        else
            describeFile(*options, std::move(model), progress, console);
    };
}

} // namespace app
