// The models of the document and how they stand to each other (session/README 1).
#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/selection/affine.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scene_parts.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/face_options.h"
#include "core/session/files_read.h"
#include "core/session/model_argument.h"
#include "core/session/number_lists.h"
#include "core/session/read_options.h"
#include "core/session/scene/models_read.h"
#include "core/session/scene/scene_file.h"
#include "core/session/surface_options.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;
using process::Rigid;

namespace {

base::Error needs(const char* parameter, const json& complete) {
    return base::Error(std::string("\"scene\" needs the parameter \"") + parameter + "\" to " +
                       complete.at("do").get<std::string>());
}

/// The model that "name" says, else the active one.
std::size_t modelOf(const Scene& scene, const json& complete) {
    if (!complete.contains("name"))
        return scene.active;
    return scene.find(complete.at("name").get<std::string>());
}

Rigid poseIn(const json& complete) {
    return complete.contains("matrix") ? poseOf(numbersOf(complete, "matrix", 16, "16 numbers by row")) : Rigid{};
}

/// A model at `pose`, turned about a point of the scene, its middle unless told, then moved.
Rigid moved(const Rigid& pose, const SceneModel& model, const json& complete) {
    const base::Vec3d by = vectorOf(complete, "move").value_or(base::Vec3d());
    const std::optional<Turn> turn = turnOf(complete);
    const base::Vec3d middle = base::cast<double>(model.surface.tree().bounds().centre()) + model.origin();
    const base::Vec3d about = vectorOf(complete, "about").value_or(pose(middle));
    const Rigid turned = turn ? process::motionOf(normalized(turn->axis) * turn->angle, {}) : Rigid();
    return Rigid{turned.rotation, about - turned.turn(about) + by} * pose;
}

/// The journal gets the command with the hash of what it read.
void pin(Context& context, json complete, const Scene& read) {
    const base::Hash128 hash = contentHash(read);
    if (const auto wanted = complete.find("hash"); wanted != complete.end())
        requireRecorded(context, *wanted, hash, complete.at("path").get<std::string>());
    complete["hash"] = hash.text();
    context.instead = std::make_shared<json>(json::array({std::move(complete)}));
}

/// Into an empty document a model is opened rather than added.
void requireOne(const Context& context) {
    if (context.document.surface().tree().empty())
        throw base::Error("there is no model yet that others could stand beside", {}, "open one first");
}

/// Made as `new` does it.
Scene sampled(Context& context, const json& complete) {
    refuseReadParameters(complete, complete.at("sample").get<std::string>());
    Document out;
    Context inner{out, context.folder, context.progress, {}, 0, {}, nullptr};
    run(inner, modelCommand("sample:" + complete.at("sample").get<std::string>()));
    Scene scene = out.scene();
    scene.models.front().id = 0;
    const auto text = complete.at("sample").get<std::string>();
    scene.models.front().name = text.substr(0, text.find(':'));
    return scene;
}

Scene fromFile(Context& context, const json& complete) {
    const auto path = complete.at("path").get<std::string>();
    if (opensAsScene(path))
        throw base::Error("is a scene, which is opened by itself", path, "add its models one by one");
    Scene out = readModels(path, filesRead(complete).at(0), complete, context.messages, context.progress);
    pin(context, complete, out);
    return out;
}

void add(Context& context, const json& complete) {
    requireOne(context);
    if (complete.contains("path") == complete.contains("sample"))
        throw base::Error("\"scene\" needs a \"path\" or a \"sample\" to add", {}, "give one of them");
    Scene read = complete.contains("sample") ? sampled(context, complete) : fromFile(context, complete);
    Scene next = context.document.scene();
    const std::size_t first = next.models.size();
    for (SceneModel& model : read.models) {
        const bool alone = read.models.size() == 1;
        model.name = alone ? newName(next, complete, "name", model.name) : next.freshName(model.name);
        model.pose = moved(poseIn(complete), model, complete);
        next.models.push_back(std::move(model));
    }
    next.active = first + read.active;
    context.document.rearrange(std::move(next), "Add model");
}

void remove(Context& context, const json& complete) {
    Scene next = context.document.scene();
    const std::size_t index = modelOf(next, complete);
    if (next.models[index].locked)
        refuseChange(next.models[index]);
    if (next.models.size() == 1)
        throw base::Error("it is the only model of the scene", {}, "open another one in its place");
    next.models.erase(next.models.begin() + static_cast<std::ptrdiff_t>(index));
    if (next.active > index || next.active == next.models.size())
        --next.active;
    context.document.rearrange(std::move(next), "Remove model");
}

void activate(Context& context, const json& complete) {
    Scene next = context.document.scene();
    const std::size_t index = modelOf(next, complete);
    if (index == next.active)
        return;
    next.active = index;
    context.document.rearrange(std::move(next), "Activate model");
}

void rename(Context& context, const json& complete) {
    if (!complete.contains("to"))
        throw needs("to", complete);
    Scene next = context.document.scene();
    SceneModel& model = next.models[modelOf(next, complete)];
    const auto to = complete.at("to").get<std::string>();
    if (model.name == to)
        return;
    requireName(next, to);
    model.name = to;
    context.document.rearrange(std::move(next), "Rename model");
}

template <bool SceneModel::*flag, bool to>
void set(Context& context, const json& complete) {
    Scene next = context.document.scene();
    SceneModel& model = next.models[modelOf(next, complete)];
    if (model.*flag == to)
        return;
    model.*flag = to;
    const char* label =
        flag == &SceneModel::visible ? (to ? "Show model" : "Hide model") : (to ? "Lock model" : "Unlock model");
    context.document.rearrange(std::move(next), label);
}

void setPose(Context& context, const json& complete, const char* label, const auto& change) {
    Scene next = context.document.scene();
    SceneModel& model = next.models[modelOf(next, complete)];
    if (model.locked)
        refuseChange(model);
    model.pose = change(model);
    context.document.rearrange(std::move(next), label);
}

void place(Context& context, const json& complete) {
    if (!complete.contains("matrix"))
        throw needs("matrix", complete);
    setPose(context, complete, "Place model", [&](const SceneModel&) { return poseIn(complete); });
}

void move(Context& context, const json& complete) {
    if (!complete.contains("move") && !complete.contains("axis"))
        throw needs("move", complete);
    setPose(context, complete, "Move model",
            [&](const SceneModel& model) { return moved(model.pose, model, complete); });
}

/// The pose goes into the points.
void apply(Context& context, const json& complete) {
    Scene next = context.document.scene();
    SceneModel& model = next.models[modelOf(next, complete)];
    if (isNothing(model.pose))
        return;
    Document one(model);
    Context inner{one, context.folder, context.progress, {}, 0, {}, nullptr};
    SceneModel there = model;
    there.pose = {};
    const Rigid motion = between(model, there);
    commitMoved(inner, {motion.rotation, motion.translation}, selection::Limit::Everything, "Apply pose");
    model = one.scene().models.front();
    model.pose = {};
    context.document.rearrange(std::move(next), "Apply pose");
}

void duplicate(Context& context, const json& complete) {
    Scene next = context.document.scene();
    SceneModel copy = next.models[modelOf(next, complete)];
    copy.name = newName(next, complete, "to", copy.name);
    copy.id = 0;
    copy.visible = true;
    copy.locked = false;
    copy.pose = moved(poseIn(complete) * copy.pose, copy, complete);
    next.active = next.models.size();
    next.models.push_back(std::move(copy));
    context.document.rearrange(std::move(next), "Duplicate model");
}

struct Action {
    const char* id;
    void (*run)(Context&, const json&);
};
constexpr Action actions[] = {
    {"add", add},
    {"remove", remove},
    {"activate", activate},
    {"rename", rename},
    {"show", set<&SceneModel::visible, true>},
    {"hide", set<&SceneModel::visible, false>},
    {"lock", set<&SceneModel::locked, true>},
    {"unlock", set<&SceneModel::locked, false>},
    {"move", move},
    {"place", place},
    {"apply", apply},
    {"duplicate", duplicate},
    {"split", splitModel},
    {"join", joinModels},
};

void scene(Context& context, const json& complete) {
    requireModel(context);
    base::findRow(actions, complete.at("do").get<std::string>())->run(context, complete);
}

} // namespace

CommandRow sceneCommand() {
    static const std::string ids = idsOf(actions);
    static const CommandParameter own[] = {
        {"do", "choice", "",
         "add: the models of a file; activate: commands and tools work on it; move: turn and move it; place: where its "
         "file's origin and axes come to stand; apply: put its place into its points; split: what is selected becomes "
         "a model; join: all that is shown, or the one of that name, goes into the active one",
         "", ids.c_str(), 0, 0},
        {"name", "text", "", "which model, the active one unless told; add: what the new one is called", "null", "", 0,
         0},
        {"to", "text", "", "rename, duplicate, split: the new name", "null", "", 0, 0},
        {"by", "text", "",
         "split: an attribute, such as scan, each value of which becomes a model; the selection unless told", "null",
         "", 0, 0},
        {"path", "path", "", "add: file to open, in any readable format", "null", "", 0, 0},
        {"sample", "text", "", "add: a sample in place of a file, NAME[:COUNT[:SEED]]", "null", "", 0, 0},
        {"hash", "text", "", "content hash that what is added must have", "null", "", 0, 0, true},
        {"source", "path", "", "file to read in place of path, kept by a journal", "null", "", 0, 0, true},
        {"matrix", "list", "",
         "16 numbers by row, a rigid motion from the file's coordinates to the scene's; "
         "duplicate: of the scene's",
         "null", "", 0, 0},
        {"move", "list", "model units", "add, duplicate, move: [x,y,z] to move by, last", "null", "", 0, 0},
        {"axis", "list", "", "add, duplicate, move: [x,y,z] of the scene to turn about", "null", "", 0, 0},
        {"angle", "number", "degrees", "to turn by, right-handed", "null", "", -3600, 3600},
        {"about", "list", "model units", "[x,y,z] of the scene that turning leaves; the model's middle unless told",
         "null", "", 0, 0},
    };
    static const auto parameters = [] {
        std::vector<CommandParameter> out(std::begin(own), std::end(own));
        out.insert(out.end(), readParameters().begin(), readParameters().end());
        out.insert(out.end(), faceParameters().begin(), faceParameters().end());
        return withSurfaceParameters(out);
    }();
    return {
        "scene",
        "Models",
        "Puts several models beside each other in one scene; one of them is active, and all other commands and tools "
        "work on that one, in the coordinates of its own file, wherever its pose puts it; \"apply\" makes these the "
        "scene's.",
        parameters,
        true,
        false,
        scene,
        nullptr};
}

} // namespace session
