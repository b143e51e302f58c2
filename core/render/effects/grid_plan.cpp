#include "core/render/effects/ground_grid.h"

#include <algorithm>
#include <cmath>

namespace render {

using base::Vec3d;
using base::Vec3f;

static double roundCell(double wanted) {
    const double power = std::pow(10, std::floor(std::log10(wanted))), factor = wanted / power;
    return power * (factor > 5 ? 10 : factor > 2 ? 5 : factor > 1 ? 2 : 1);
}

GroundGrid gridBelow(const base::Box3f& box, const Vec3d& up, const Vec3d& origin) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        axis = std::abs(up[k]) > std::abs(up[axis]) ? k : axis;
    const bool empty = !(box.diagonal() > 0);
    const double size = empty ? 1.0 : static_cast<double>(box.diagonal());
    GroundGrid out;
    out.cell = roundCell(0.06 * size);
    out.radius = 1.5 * size;
    out.along[axis == 0 ? 1 : 0] = 1;
    out.across[axis == 2 ? 1 : 2] = 1;
    const Vec3d middle = empty ? Vec3d{} : base::cast<double>(box.centre());
    for (std::size_t k = 0; k < 3; ++k)
        out.centre[k] = std::round((middle[k] + origin[k]) / out.cell) * out.cell - origin[k];
    if (!empty)
        out.centre[axis] = static_cast<double>(up[axis] < 0 ? box.hi[axis] : box.lo[axis]);
    return out;
}

GridPlan::GridPlan(const GroundGrid& grid, const Camera& camera, const Vec3f& lineInk, float pixelScale)
    : cell(static_cast<float>(grid.cell)), inverseRadiusSq(static_cast<float>(1 / (grid.radius * grid.radius))),
      width(std::max(1.0f, pixelScale)), ink(lineInk), parallel(ViewFrame(camera).parallel) {
    const Vec3d x = camera.right(), y = -camera.upright(), z = camera.forward();
    const auto turned = [&](const Vec3d& v) { return base::cast<float>(Vec3d{dot(v, x), dot(v, y), dot(v, z)}); };
    const Vec3d up = cross(grid.along, grid.across), away = grid.centre - camera.eye;
    normal = turned(up), along = turned(grid.along), across = turned(grid.across);
    offset = static_cast<float>(dot(up, away));
    alongStart = static_cast<float>(dot(grid.along, away));
    acrossStart = static_cast<float>(dot(grid.across, away));
}

} // namespace render
