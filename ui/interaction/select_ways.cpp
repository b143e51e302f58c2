#include "ui/interaction/select_ways.h"

#include "core/surface/evaluation/weights.h"
#include "ui/interaction/picked_outline.h"

#include <nlohmann/json.hpp>

namespace ui {

using base::Vec3d;
using nlohmann::json;

namespace {

json listOf(const Vec3d& v) {
    return {v.x, v.y, v.z};
}

template <PickShape shape>
json inOutline(const Pick& pick, const SelectContext& context) {
    json out = outlineOf(pick, shape, context.origin);
    out["op"] = "select", out["by"] = "view", out["visible"] = context.visible;
    return out;
}

json inBall(const Pick& pick, const SelectContext& context) {
    return {{"op", "select"},
            {"by", "ball"},
            {"at", listOf(pick.contact->position + context.origin)},
            {"radius", context.radius}};
}

json ofPiece(const Pick& pick, const SelectContext& context) {
    return {{"op", "select"}, {"by", "piece"}, {"at", listOf(pick.contact->position + context.origin)}};
}

/// Up to where neighbours' normals differ as at an edge.
json ofFace(const Pick& pick, const SelectContext& context) {
    constexpr double creaseDeg = 20;
    json out = ofPiece(pick, context);
    out["angle"] = creaseDeg;
    return out;
}

/// The side that was clicked, whatever the stored normals say.
json facing(const Pick& pick, const SelectContext&) {
    return {{"op", "select"}, {"by", "normal"}, {"direction", listOf(pick.contact->normal)}, {"angle", 30}};
}

json ofColour(const Pick& pick, const SelectContext& context) {
    surfel::Colour colour = 0;
    double nearest = std::numeric_limits<double>::infinity();
    surface::forWeights(context.surface, base::cast<float>(pick.contact->position),
                        [&](const surfel::SurfelBlock& block, int slot, float) {
                            const double d = distance(base::cast<double>(block.position(slot)), pick.contact->position);
                            if (d < nearest)
                                nearest = d, colour = block.surfel(slot).colour;
                        });
    return {{"op", "select"}, {"by", "colour"}, {"colour", {colour & 255u, colour >> 8 & 255u, colour >> 16 & 255u}}};
}

constexpr SelectWay ways[] = {
    {"rectangle", "Box", "Hold the button and draw a rectangle", PickShape::Rectangle, inOutline<PickShape::Rectangle>},
    {"lasso", "Lasso", "Hold the button and draw around what is wanted", PickShape::Lasso, inOutline<PickShape::Lasso>},
    {"polygon", "Polygon", "Click the corners; Enter or a double click closes it, Backspace takes one back",
     PickShape::Polygon, inOutline<PickShape::Polygon>},
    {"ball", "Ball", "Click: what lies within the brush's radius", PickShape::Place, inBall},
    {"piece", "Piece", "Click: all that hangs together with that place", PickShape::Place, ofPiece},
    {"face", "Face", "Click: all around that place up to where the surface bends sharply", PickShape::Place, ofFace},
    {"facing", "Facing", "Click: all whose normals are within 30 degrees of the one there", PickShape::Place, facing},
    {"colour", "Colour", "Click: all of about the colour there", PickShape::Place, ofColour},
};

} // namespace

std::span<const SelectWay> selectWays() {
    return ways;
}

const char* modeOf(Qt::KeyboardModifiers modifiers, const char* chosen) {
    const bool add = modifiers.testFlag(Qt::ShiftModifier), less = modifiers.testFlag(Qt::ControlModifier);
    return add && less ? "intersect" : add ? "add" : less ? "subtract" : chosen;
}

} // namespace ui
