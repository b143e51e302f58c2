// The edges that a model keeps sharp as polylines with the normals of both sides: seams of models with cells
// (cells/README 9), curves of complexes (complexes/README 1).
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <vector>

namespace cells {

struct SeamPoint {
    base::Vec3d position;
    base::Vec3d normal; ///< unit, midway between both sides
    double turn = 0;    ///< of the normals, in degrees: > 0 where the edge stands out, < 0 in grooves
    double unit = 0;    ///< h about there
};

struct SeamLine {
    std::uint32_t a = 0, b = 0; ///< the cells that meet
    std::vector<SeamPoint> points;
    bool closed = false;

    double length() const;
};

/// The longest first; those that meet at a corner share its place as their ends. Nothing for models that have no sharp
/// edges. Throws base::Cancelled.
std::vector<SeamLine> seamLines(const surface::Surface& surface, const base::Progress& progress = {});

} // namespace cells
