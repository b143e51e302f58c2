// Where a patch lies: between no more than its loop, or on from the surface around with the least variation of
// curvature (solid/README 1.3).
//
// Before: patchOver. After: patchNormals. Linear systems are Eigen's, which stays behind this header.
#pragma once

#include "core/solid/loops/patch.h"
#include "core/surface/surface.h"

namespace solid {

enum class Shape {
    Flat,  ///< least area: the plane of a plane loop
    Smooth ///< tangent planes of the surface around go on into the patch, and curvatures where noise lets them be told
};

/// Moves the vertices inside. False, and nothing moved, where no surface of that shape comes to lie about the loop (it
/// swings farther than twice the loop's extent). Throws base::Cancelled.
bool shapePatch(const surface::Surface& surface, const Loop& loop, Shape shape, Patch& patch,
                const base::Progress& progress = {});

/// Each vertex' unit normal: the surface's at the loop, that of the triangles around, by angle, inside.
std::vector<base::Vec3d> patchNormals(const Loop& loop, const Patch& patch);

/// For each vertex a weighted mean of the loop's values, smoothly from one side to the other. `values`: of each of the
/// loop's points, all of one length.
std::vector<std::vector<double>> spreadOver(const Patch& patch, const std::vector<std::vector<double>>& values);

/// For each vertex the loop's point that is nearest along the patch.
std::vector<std::uint32_t> nearestOfLoop(const Patch& patch);

} // namespace solid
