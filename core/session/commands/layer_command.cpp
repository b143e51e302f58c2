#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/cells/measured_labels.h"
#include "core/selection/field.h"
#include "core/session/commands/commands.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace session {

using layers::Layer, layers::Stack;
using nlohmann::json;

namespace {

std::string quoted(const std::string& name) {
    return "\"" + name + "\"";
}

base::Error needs(const char* parameter, const json& complete) {
    return base::Error(std::string("\"layer\" needs the parameter \"") + parameter + "\" to " +
                       complete.at("do").get<std::string>());
}

/// A name that no layer has. Throws base::Error for others.
std::string freshName(const Stack& stack, const std::string& name) {
    if (!layers::isName(name))
        throw base::Error(quoted(name) + " is no name for a layer", {},
                          "use 1 to 64 characters without blanks at the ends and control characters");
    if (stack.indexOf(name) >= 0)
        throw base::Error("there is a layer " + quoted(name) + " already", {}, "choose another name");
    return name;
}

/// The layer that "name" says, else the active one.
std::size_t layerOf(const Stack& stack, const json& complete) {
    if (stack.empty())
        throw base::Error("the model has no layers", {}, R"(add one: {"op":"layer","do":"add"})");
    if (!complete.contains("name")) {
        if (stack.target() < 0)
            throw base::Error("no layer is active", {}, "say which one is meant: \"name\"");
        return static_cast<std::size_t>(stack.target());
    }
    const auto name = complete.at("name").get<std::string>();
    const int index = stack.indexOf(name);
    std::string known;
    for (const Layer& each : stack.layers)
        known += (known.empty() ? "" : ", ") + quoted(each.name);
    if (index < 0)
        throw base::Error("there is no layer " + quoted(name), {}, "known are " + known);
    return static_cast<std::size_t>(index);
}

/// Edges turn over with the shape; creases stay where it is flat, as another strength brings their edges back.
surface::Surface measured(const surface::Surface& surface, const std::vector<base::Box3f>& changed) {
    std::vector<cells::EditedBall> balls;
    for (const base::Box3f& box : changed)
        balls.push_back({box.centre(), 0.5f * box.diagonal()});
    const tree::Edit edit = cells::measuredLabels(surface, balls, cells::Partners::Kept);
    return edit.empty() ? surface : surface::Surface{surface.tree().apply(edit), surface.definition()};
}

void commit(Context& context, const layers::Restacked& next, Stack stack, const std::string& label) {
    const surface::SurfaceDefinition& definition = context.document.surface().definition();
    context.document.restack(measured({next.tree, definition}, next.changed), std::move(stack), label);
}

/// The same surfels, another list.
void commitList(Context& context, Stack stack, const std::string& label) {
    if (!(stack == context.document.layers()))
        context.document.restack(context.document.surface(), std::move(stack), label);
}

void show(Context& context, const Stack& stack, const std::string& label) {
    if (stack == context.document.layers())
        return;
    commit(context, layers::restacked(context.document.surface().tree(), context.document.layers(), stack), stack,
           label);
}

void add(Context& context, const json& complete) {
    Stack stack = context.document.layers();
    std::string name = complete.value("name", std::string());
    for (std::size_t number = stack.layers.size() + 1; name.empty(); ++number)
        if (stack.indexOf("Layer " + std::to_string(number)) < 0)
            name = "Layer " + std::to_string(number);
    freshName(stack, name);
    const Stack before = stack;
    const std::uint32_t id = stack.add(name).id;
    commit(context, {layers::withWords(context.document.surface().tree(), before, id), {}}, stack, "Add layer");
}

/// `tree`: where the layer holds nothing that is shown.
void drop(Context& context, layers::Restacked next, Stack stack, std::size_t index, const char* label) {
    const std::uint32_t id = stack.layers[index].id;
    if (stack.active == id)
        stack.active = index > 0 ? stack.layers[index - 1].id : 0;
    stack.layers.erase(stack.layers.begin() + static_cast<std::ptrdiff_t>(index));
    next.tree = layers::withoutWords(next.tree, stack, id);
    commit(context, next, stack, label);
}

void remove(Context& context, const json& complete) {
    const Stack stack = context.document.layers();
    const std::size_t index = layerOf(stack, complete);
    Stack hidden = stack;
    hidden.layers[index].visible = false;
    drop(context, layers::restacked(context.document.surface().tree(), stack, hidden), stack, index, "Remove layer");
}

void merge(Context& context, const json& complete) {
    const Stack stack = context.document.layers();
    const std::size_t index = layerOf(stack, complete);
    if (index > 0 && std::abs(stack.layers[index - 1].weight()) < layers::leastRecording)
        throw base::Error("the layer below, " + quoted(stack.layers[index - 1].name) + ", does not show what it holds",
                          {}, "show it, or move the layer");
    drop(context, {layers::merged(context.document.surface().tree(), stack, static_cast<int>(index)), {}}, stack, index,
         "Merge layer");
}

void setStrength(Context& context, const json& complete) {
    if (!complete.contains("strength"))
        throw needs("strength", complete);
    Stack stack = context.document.layers();
    stack.layers[layerOf(stack, complete)].strength = complete.at("strength").get<float>();
    show(context, stack, "Layer strength");
}

void setVisible(Context& context, const json& complete) {
    Stack stack = context.document.layers();
    const bool visible = complete.at("do") == "show";
    stack.layers[layerOf(stack, complete)].visible = visible;
    show(context, stack, visible ? "Show layer" : "Hide layer");
}

void activate(Context& context, const json& complete) {
    Stack stack = context.document.layers();
    stack.active = stack.layers[layerOf(stack, complete)].id;
    commitList(context, stack, "Activate layer");
}

void activateBase(Context& context, const json&) {
    Stack stack = context.document.layers();
    stack.active = 0;
    commitList(context, stack, "Sculpt below layers");
}

void rename(Context& context, const json& complete) {
    if (!complete.contains("to"))
        throw needs("to", complete);
    Stack stack = context.document.layers();
    Layer& layer = stack.layers[layerOf(stack, complete)];
    if (layer.name == complete.at("to").get<std::string>())
        return;
    layer.name = freshName(stack, complete.at("to").get<std::string>());
    commitList(context, stack, "Rename layer");
}

void move(Context& context, const json& complete) {
    if (!complete.contains("place"))
        throw needs("place", complete);
    Stack stack = context.document.layers();
    const std::size_t from = layerOf(stack, complete), to = complete.at("place").get<std::size_t>() - 1;
    if (to >= stack.layers.size())
        throw base::Error("there are only " + std::to_string(stack.layers.size()) + " layers", {},
                          "give a place from 1, the lowest, to that number");
    const Layer layer = stack.layers[from];
    stack.layers.erase(stack.layers.begin() + static_cast<std::ptrdiff_t>(from));
    stack.layers.insert(stack.layers.begin() + static_cast<std::ptrdiff_t>(to), layer);
    show(context, stack, "Move layer");
}

void mask(Context& context, const json& complete) {
    const Stack& stack = context.document.layers();
    const std::size_t index = layerOf(stack, complete);
    const surface::Surface& now = context.document.surface();
    const auto from = complete.at("from").get<std::string>();
    const bool bySelection = from == "selection";
    const int channel =
        selection::channelOf(*now.tree().layout(), bySelection ? selection::Field::Selection : selection::Field::Mask);
    const layers::Restacked next =
        layers::masked(now.tree(), stack, static_cast<int>(index), [&](const surfel::SurfelBlock& block, int slot) {
            return from == "nothing" ? 0.0f : std::clamp(selection::valueAt(block, channel, slot), 0.0f, 1.0f);
        });
    if (!(next.tree == now.tree()))
        commit(context, next, stack, "Mask layer");
}

struct Action {
    const char* id;
    void (*run)(Context&, const json&);
};
constexpr Action actions[] = {
    {"add", add},         {"remove", remove},   {"merge", merge},       {"strength", setStrength},
    {"show", setVisible}, {"hide", setVisible}, {"activate", activate}, {"base", activateBase},
    {"rename", rename},   {"move", move},       {"mask", mask},
};

void layer(Context& context, const json& complete) {
    requireModel(context);
    base::findRow(actions, complete.at("do").get<std::string>())->run(context, complete);
}

} // namespace

CommandRow layerCommand() {
    static const std::string ids = idsOf(actions);
    static const CommandParameter parameters[] = {
        {"do", "choice", "",
         "add: a new one on top, which keeps the shape for the tool morph; merge: into the one below; base: strokes go "
         "below all layers; move: to another place; "
         "mask: hide it in parts",
         "", ids.c_str(), 0, 0},
        {"name", "text", "", "which layer, the active one unless told; add: what the new one is called", "null", "", 0,
         0},
        {"strength", "number", "", "how much of what the layer holds is shown; below 0 the other way", "null", "",
         double(layers::leastStrength), double(layers::mostStrength)},
        {"to", "text", "", "rename: the new name", "null", "", 0, 0},
        {"place", "integer", "", "move: 1 is the lowest", "null", "", 1, 1000},
        {"from", "choice", "", "mask: hide the layer where the model is masked, where it is selected, or nowhere",
         "\"mask\"", "mask selection nothing", 0, 0},
    };
    return {
        "layer",
        "Layers",
        "Keeps strokes apart in layers, of which more or less is shown at any time; strokes go into the active one.",
        parameters,
        true,
        false,
        layer,
        nullptr};
}

} // namespace session
