// Surfels by what they carry: a quantity within a range, a colour, the direction of the normal (selection/README 3).
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"
#include "core/tree/selection.h"

#include <span>
#include <string_view>

namespace selection {

/// What can be asked for beside the model's own attributes, which go by their names.
struct QuantityRow {
    const char* id;
    const char* tip;
};
std::span<const QuantityRow> quantityTable();

/// The surfels whose quantity lies in [low, high]; `origin` is what positions are relative to. Curvature that is not
/// known is in no range. Throws base::Error naming what there is where the model has no such quantity.
tree::Selection inRange(const surface::Surface& surface, std::string_view quantity, double low, double high,
                        const base::Vec3d& origin = {}, const base::Progress& progress = {});

/// Those whose colour is no farther than `tolerance` from this one: the distance of red, green and blue, 0 to 255 each.
tree::Selection nearColour(const tree::SurfelTree& tree, surfel::Colour colour, double tolerance);

/// Those whose normal is no farther than an angle from a direction; normals without sides count either way.
tree::Selection facing(const tree::SurfelTree& tree, const base::Vec3d& direction, double angleRad);

} // namespace selection
