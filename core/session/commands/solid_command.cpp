#include "core/base/error.h"
#include "core/base/unit_normal.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/known_rims.h"
#include "core/process/estimation/left_rims.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/other_model.h"
#include "core/session/model_argument.h"
#include "core/session/number_text_list.h"
#include "core/surfel/shape.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// Another model of the scene.
static std::size_t sceneModel(const Scene& scene, const std::string& name) {
    const std::size_t out = scene.find(name);
    if (out == scene.active)
        throw base::Error("\"" + name + "\" is the active model itself", {}, "name another model of the scene");
    return out;
}

/// As it stands beside the active model.
static Document standing(const Scene& scene, std::size_t index) {
    const SceneModel& active = scene.models[scene.active];
    SceneModel model = scene.models[index];
    model.surface = session::placed(model.surface, between(model, active));
    model.provenance = active.provenance; // the coordinates that it is in now
    model.pose = {};
    return Document(std::move(model));
}

/// Opened or made as `open` and `new` do it.
static Document otherSolid(Context& context, const json& complete) {
    const bool file = complete.contains("path");
    if (file + complete.contains("sample") + complete.contains("model") != 1)
        throw base::Error("\"solid\" needs one of \"path\", \"sample\" and \"model\"", {}, "give the other solid once");
    if (file)
        return otherModel(context, complete, 0, context.progress);
    const Scene& scene = context.document.scene();
    if (complete.contains("model"))
        return standing(scene, sceneModel(scene, complete.at("model").get<std::string>()));
    Document out;
    Context inner{out, context.folder, context.progress, {}, 0, {}, nullptr};
    run(inner, modelCommand("sample:" + complete.at("sample").get<std::string>()));
    if (const auto wanted = complete.find("hash"); wanted != complete.end())
        requireRecorded(context, *wanted, out.hash(), "the sample");
    return out;
}

/// Where its surfels are in the model's coordinates.
static surfel::SurfelList placed(const Document& other, const solid::Pose& pose, double scale) {
    surfel::SurfelList out = other.surface().tree().surfels();
    if (!out.layout->normals || !out.layout->oriented)
        throw base::Error("the other model has no normals that tell inside from outside", "solid",
                          "open it by itself, orient its normals and save it as PLY");
    const base::Vec3d origin = other.provenance().origin;
    for (surfel::Surfel& s : out.items) {
        s.position = base::cast<float>(pose.place((base::cast<double>(s.position) + origin) * scale));
        s.normal = base::unitNormal(base::cast<float>(pose.turn * base::cast<double>(s.normal)));
        s.support *= static_cast<float>(scale);
    }
    surfel::mapShapes(out, 0,
                      [&](const base::Vec3f& b) { return base::cast<float>(pose.turn * base::cast<double>(b)); });
    return out;
}

static void solidWith(Context& context, const json& complete) {
    requireModel(context);
    const tree::SurfelTree before = context.document.surface().tree();
    const Document other = otherSolid(context, complete);
    if (complete.contains("path")) { // a journal notices when the file has changed
        json pinned = complete;
        pinned["hash"] = other.hash().text();
        context.instead = std::make_shared<json>(json::array({std::move(pinned)}));
    }
    const surface::Surface* both[] = {&context.document.surface(), &other.surface()};
    const bool known = process::knowRimsTogether(both);
    surface::Surface model = context.document.surface();
    if (known)
        model = {process::withRimAttribute(model.tree()), model.definition()};
    surfel::SurfelList surfels =
        placed(other, poseOf(complete, context.document.provenance().origin), complete.at("scale").get<double>());
    const solid::SurfaceSide side({tree::SurfelTree::build(surfels), other.surface().definition()});
    const bool modelOpen = tellOfGuess(context, model),
               open = tellOfGuess(context, other.surface(), "other model") || modelOpen;
    solid::CombineOptions options = combineOptions(complete);
    options.seams = complete.at("seams").get<bool>();
    solid::Combined result =
        solid::combine(model, {side, std::move(surfels)}, solid::operation(complete.at("operation").get<std::string>()),
                       options, context.progress);
    if (open && result.removed + result.inserted > 0) // its rims may be in the result, or the model's may be gone
        result.surface =
            known ? process::withKnownRims(result.surface.tree(), result.surface.definition(), context.progress)
                  : process::withOwnLimit(result.surface.tree(), result.surface.definition(), context.progress);
    takeBoth(context, std::move(result), "Combine");
    if (complete.contains("model") && !(context.document.surface().tree() == before)) { // it is in this one now
        Scene scene = context.document.scene();
        scene.models[sceneModel(scene, complete.at("model").get<std::string>())].visible = false;
        context.document.amend(std::move(scene));
    }
}

CommandRow solidCommand() {
    static const std::string operations = idsOf(solid::operationTable());
    static const CommandParameter parameters[] = {
        {"path", "path", "", "the other model: a file; give this, sample or model", "null", "", 0, 0},
        {"sample", "text", "", "the other model: a sample, NAME[:COUNT[:SEED]]", "null", "", 0, 0},
        {"model", "text", "", "the other model: one of the scene, where it stands; it is hidden afterwards", "null", "",
         0, 0},
        {"hash", "text", "", "content hash that the other model must have", "null", "", 0, 0, true},
        sourcesParameter(),
        {"operation", "choice", "",
         "union: what is in either; difference: in this one and not in the other; intersection: in both", "\"union\"",
         operations.c_str(), 0, 0},
        {"position", "text", "model units", "where the other one's origin comes to stand, as x,y,z", "\"0,0,0\"", "", 0,
         0},
        {"rotation", "text", "degrees", "by which it is turned before, about x, then y, then z, as x,y,z", "\"0,0,0\"",
         "", 0, 0},
        {"scale", "number", "", "by which it is enlarged first", "1", "", positive, largest},
        creasesParameter(),
        filletParameter(),
        chamferParameter(),
        {"seams", "boolean", "", "trace the curves where both surfaces cross, and tell their number and length",
         "false", "", 0, 0},
    };
    return {"solid",
            "Combine solids",
            "Puts the model and another one together as solids: union, difference or intersection.",
            parameters,
            true,
            false,
            solidWith,
            nullptr};
}

} // namespace session
