#include "core/session/commands/scene_parts.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/known_rims.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/scene/joined_models.h"
#include "core/surface/rims.h"

#include <map>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static std::string called(const std::string& name) {
    return "\"" + name + "\"";
}

void requireName(const Scene& scene, const std::string& name) {
    if (!isModelName(name))
        throw base::Error(called(name) + " is no name for a model", {},
                          "use 1 to 64 characters without blanks at the ends and control characters");
    if (scene.indexOf(name) >= 0)
        throw base::Error("there is a model " + called(name) + " already", {}, "choose another name");
}

std::string newName(const Scene& scene, const json& complete, const char* key, const std::string& like) {
    if (!complete.contains(key))
        return scene.freshName(like);
    const auto out = complete.at(key).get<std::string>();
    requireName(scene, out);
    return out;
}

namespace {

/// Cells of a complex belong together, and what layers hold belongs to all of it.
void requireParts(const SceneModel& model) {
    if (model.surface.definition().connectivity || !model.layers.empty())
        throw base::Error(model.layers.empty() ? "a cell complex is not split" : "a model with layers is not split", {},
                          "merge its layers, or save the part");
}

/// The same model, of other surfels.
SceneModel withSurfels(Context& context, SceneModel model, tree::SurfelTree tree) {
    model.surface = selection::asPart(model.surface, std::move(tree), context.progress);
    return model;
}

SceneModel fresh(SceneModel model, std::string name) {
    model.id = 0;
    model.name = std::move(name);
    return model;
}

/// What is selected becomes a model of its own, in the same place.
void splitSelected(Context& context, const json& complete) {
    requireSelection(context);
    Scene next = context.document.scene();
    SceneModel& whole = next.models[next.active];
    requireParts(whole);
    const tree::SurfelTree tree = whole.surface.tree();
    SceneModel part = withSurfels(context, fresh(whole, newName(next, complete, "to", whole.name)),
                                  tree::SurfelTree::build(selection::partOf(tree, true)));
    whole = withSurfels(context, whole, selection::withoutSelected(tree));
    context.messages.push_back(std::to_string(part.surface.tree().size()) + " surfels are the model " +
                               called(part.name) + ", " + std::to_string(whole.surface.tree().size()) + " stay in " +
                               called(whole.name) + ".");
    next.models.push_back(std::move(part));
    context.document.rearrange(std::move(next), "Split off");
}

/// Surfels by the value of an attribute, as of scans that one file holds.
std::map<double, surfel::SurfelList> byValue(const surfel::SurfelList& list, const std::string& name) {
    constexpr std::size_t most = 256;
    const surfel::Attribute* attribute = list.layout->find(name);
    if (!attribute)
        throw base::Error("the model has no attribute " + called(name), {},
                          "`info` lists what it has; without \"by\" the selection is split off");
    std::map<double, surfel::SurfelList> out;
    for (std::size_t i = 0; i < list.size(); ++i) {
        surfel::SurfelList& own = out[surfel::read(*attribute, list.extraOf(i))];
        own.layout = list.layout;
        own.append(list.items[i], list.extraOf(i));
        if (out.size() > most)
            throw base::Error(called(name) + " has more than " + std::to_string(most) + " values", {},
                              "choose an attribute that numbers parts");
    }
    return out;
}

/// Each value of an attribute becomes a model; the first keeps the name's place.
void splitByValue(Context& context, const std::string& attribute) {
    Scene next = context.document.scene();
    const SceneModel whole = next.models[next.active];
    requireParts(whole);
    const auto parts = byValue(whole.surface.tree().surfels(), attribute);
    if (parts.size() < 2)
        throw base::Error("all surfels have one value of " + called(attribute), {}, "choose another attribute");
    bool first = true;
    for (const auto& [value, surfels] : parts) {
        SceneModel part = withSurfels(context, whole, tree::SurfelTree::build(surfels, context.progress));
        if (std::exchange(first, false))
            next.models[next.active] = std::move(part);
        else
            next.models.push_back(fresh(std::move(part), next.freshName(whole.name)));
    }
    context.messages.push_back(std::to_string(parts.size()) + " models, one for each value of " + called(attribute) +
                               ".");
    context.document.rearrange(std::move(next), "Split");
}

} // namespace

void splitModel(Context& context, const json& complete) {
    if (complete.contains("by"))
        splitByValue(context, complete.at("by").get<std::string>());
    else
        splitSelected(context, complete);
}

/// All that is seen goes into the active model.
void joinModels(Context& context, const json& complete) {
    Scene next = context.document.scene();
    const std::size_t only =
        complete.contains("name") ? next.find(complete.at("name").get<std::string>()) : next.active;
    std::vector<std::string> kept;
    std::vector<SceneModel> all{next.models[next.active]};
    Scene left;
    left.models.clear();
    for (std::size_t k = 0; k < next.models.size(); ++k) {
        const SceneModel& model = next.models[k];
        const bool wanted = only == next.active || k == only;
        const bool taken = k == next.active || (wanted && model.visible && !model.locked);
        if (wanted && !taken)
            kept.push_back(called(model.name) + (model.locked ? " (locked)" : " (hidden)"));
        if (taken && k != next.active)
            all.push_back(model);
        if (k == next.active)
            left.active = left.models.size();
        if (!taken || k == next.active)
            left.models.push_back(model);
    }
    refuseChange(all.front());
    if (all.size() == 1)
        throw base::Error("there is no other model that is shown and not locked", {},
                          "show or unlock what is to be joined");
    const surface::Surface whole = joined(all);
    left.models[left.active].surface = surface::knowsRims(whole)
                                           ? process::withKnownRims(whole.tree(), whole.definition(), context.progress)
                                           : process::withOwnLimit(whole.tree(), whole.definition(), context.progress);
    context.messages.push_back(std::to_string(all.size()) + " models are one of " +
                               std::to_string(whole.tree().size()) + " surfels.");
    if (!kept.empty())
        context.messages.push_back("Left as they are: " + base::listed(kept) + ".");
    context.document.rearrange(std::move(left), "Join models");
}

} // namespace session
