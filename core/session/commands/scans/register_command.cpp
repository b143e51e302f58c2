#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/prepare.h"
#include "core/selection/affine.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/other_model.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/scans.h"

#include <nlohmann/json.hpp>
#include <span>

namespace session {

using base::Vec3d;
using nlohmann::json;
using selection::Affine, selection::Limit;

static void bringTogether(Context& context, Scans& scans, const json& complete) {
    bring(scans, complete.at("global").get<bool>(), context.messages, process::part(context.progress, 0.3, 0.8));
    for (const auto& [name, value] : {std::pair{"rms", &process::Placed::rms}, {"overlap", &process::Placed::overlap}})
        context.figures[name] = scans.placed.back().*value; // of the last one
}

/// What the journal gets: the same, with what the other models were.
static void pin(Context& context, json complete, std::span<const Document> others) {
    json hashes = json::array();
    for (const Document& other : others)
        hashes.push_back(other.hash().text());
    complete["hashes"] = std::move(hashes);
    context.instead = std::make_shared<json>(json::array({std::move(complete)}));
}

/// One surface of all their points, as the model is defined.
static void join(Context& context, const Scans& scans, const Vec3d& shift) {
    process::PrepareOptions options;
    options.definition = context.document.surface().definition();
    options.keepSupports = false;
    const surfel::SurfelList points = together(scans, shift);
    if (const std::string loss = lossOf(scans); !loss.empty())
        context.messages.push_back(loss);
    context.messages.push_back(std::to_string(points.size()) + " points of " + std::to_string(scans.placed.size()) +
                               " scans; where they overlap there are points of each: \"thin\" or \"resample\" makes "
                               "one even layer of them.");
    clean::commit(context, process::prepare(points, options, process::part(context.progress, 0.8, 1)), "Register");
}

/// The model onto another one, which it then has beside it where asked for.
static void moveTo(Context& context, const json& complete) {
    const auto path = complete.at("to").get<std::string>();
    Scans scans;
    add(scans, path, otherModel(context, complete, 0, process::part(context.progress, 0, 0.3)));
    add(scans, "the model", context.document);
    bringTogether(context, scans, complete);
    pin(context, complete, std::span(scans.documents).first(1));
    const Vec3d shift = scans.origin() - context.document.provenance().origin;
    const process::Rigid& pose = scans.placed[1].pose;
    const Affine map{pose.rotation, pose.translation + shift};
    if (!complete.at("join").get<bool>())
        return commitMoved(context, map, Limit::Everything, "Register");
    selection::transformed(context.document.surface(), map, Limit::Everything);                // is there room for it?
    selection::transformed(scans.placed[0].surface, Affine::moving(shift), Limit::Everything); // and for that?
    join(context, scans, shift);
}

/// Others onto the model.
static void take(Context& context, const json& complete) {
    Scans scans;
    add(scans, "the model", context.document);
    std::size_t number = 0;
    for (const json& path : complete.at("moving"))
        add(scans, path.get<std::string>(),
            otherModel(context, complete, number++, process::part(context.progress, 0, 0.3)));
    bringTogether(context, scans, complete);
    pin(context, complete, std::span(scans.documents).subspan(1));
    join(context, scans, {});
}

/// Models of the scene onto the active one: their places change, and nothing else.
static void placeScene(Context& context, const json& complete) {
    Scene scene = context.document.scene();
    const SceneModel active = scene.models[scene.active];
    Scans scans;
    add(scans, active.name, context.document);
    std::vector<SceneModel*> moving;
    for (SceneModel& model : scene.models) {
        if (model.id == active.id || !model.visible || model.locked)
            continue;
        add(scans, model.name, Document(model));
        scans.placed.back().pose = between(model, active);
        moving.push_back(&model);
    }
    if (moving.empty())
        throw base::Error("no other model is shown and not locked", {}, "show or unlock those that are to be moved");
    bringTogether(context, scans, complete);
    for (std::size_t m = 0; m < moving.size(); ++m)
        moving[m]->pose = active.pose * betweenFiles(scans, m + 1);
    context.document.rearrange(std::move(scene), "Register");
}

static void registerScans(Context& context, const json& complete) {
    requireModel(context);
    const bool to = complete.contains("to"), scene = complete.at("scene").get<bool>();
    if (to + complete.contains("moving") + scene != 1)
        throw base::Error("\"register\" needs either \"to\", \"moving\" or \"scene\"", {},
                          "name the model that this one is moved onto, or those that are moved onto this one; scene: "
                          "the other models of the scene");
    if (scene)
        placeScene(context, complete);
    else if (to)
        moveTo(context, complete);
    else
        take(context, complete);
}

CommandRow registerCommand() {
    static const CommandParameter parameters[] = {
        {"to", "path", "", "the model that this one is moved onto; give this or moving", "null", "", 0, 0},
        {"moving", "paths", "", "models that are moved onto this one and added to it", "null", "", 0, 0},
        {"scene", "boolean", "",
         "the other models of the scene, as far as they are shown and not locked, come to lie on "
         "the active one: their poses change",
         "false", "", 0, 0},
        {"global", "boolean", "",
         "look for their places everywhere, by what the surfaces look like; otherwise they begin where they are",
         "false", "", 0, 0},
        {"join", "boolean", "", "add the points of the model that this one was moved onto", "false", "", 0, 0},
        {"hashes", "list", "", "content hashes that the other models must have, in their order", "null", "", 0, 0,
         true},
        sourcesParameter(),
    };
    return {"register",
            "Register",
            "Moves the model onto another scan of the same thing, or others onto it: one model with an attribute "
            "\"scan\" that tells whose a point was.",
            parameters,
            true,
            false,
            registerScans,
            nullptr};
}

} // namespace session
