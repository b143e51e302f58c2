// A grid on the ground: where each pixel's ray meets the plane, how much of the pixel its lines cover.
//
//     coverage of lines of a width (pixels):  clamp(width/2 + 1/2 - |u - nearest line| / footprint, 0, 1)
//
// with the footprint of a pixel from the exact derivatives of the point hit: no edge is ever jagged, and lines that
// come closer than a few pixels fade. Nearer surfaces hide it, it hides farther ones.
#pragma once

#include "core/base/box.h"
#include "core/render/effects/pixel_geometry.h"
#include "core/render/shared_constant.h"

namespace render {

struct GroundGrid {
    base::Vec3d centre;        ///< a crossing of lines
    base::Vec3d along, across; ///< unit axes of the plane; along is drawn reddish, across bluish
    double cell = 1;           ///< between lines; every tenth is stronger
    double radius = 10;        ///< where it has faded out
    bool operator==(const GroundGrid&) const = default;
};

/// Below a model, across the axis of coordinates nearest to `up`: cells of 1, 2 or 5 times a power of ten, about a
/// fifteenth of its size. `origin`: of the file, so that lines stand at round numbers of its coordinates.
GroundGrid gridBelow(const base::Box3f& box, const base::Vec3d& up, const base::Vec3d& origin);

/// The grid as the pixel loops of both renderers read it: view coordinates x right, y down, z forward, the eye at zero.
struct GridPlan {
    base::Vec3f normal, along, across;
    float offset = 0, alongStart = 0, acrossStart = 0; ///< of its centre
    float cell = 1, inverseRadiusSq = 1;
    float width = 1; ///< of lines, pixels
    base::Vec3f ink; ///< sRGB, 0 to 1
    bool parallel = false;

    GridPlan() = default;
    GridPlan(const GroundGrid& grid, const Camera& camera, const base::Vec3f& ink, float pixelScale);
};

/// Of lines: what they hide of what is behind.
constexpr SharedConstant gridMinor{"gridMinor", 0.3f}, gridMajor{"gridMajor", 0.55f}, gridAxis{"gridAxis", 0.85f};
constexpr SharedConstant gridFadeFrom{"gridFadeFrom", 2}, gridFadeTo{"gridFadeTo", 10}; ///< pixels between lines
inline constexpr SharedConstant gridConstants[] = {gridMinor, gridMajor, gridAxis, gridFadeFrom, gridFadeTo};
constexpr float gridRed[3] = {0.83f, 0.3f, 0.28f}, gridBlue[3] = {0.3f, 0.48f, 0.85f};

/// Draws over pixels [left, right) of a row, in place; `colours` begins at `left`. The alpha of what is transparent
/// grows with the lines.
void applyGrid(const GridPlan& plan, const ViewFrame& view, const PixelGeometry& geometry, int row, int left, int right,
               surfel::Colour* colours);

} // namespace render
