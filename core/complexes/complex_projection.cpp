#include "core/complexes/complex_projection.h"

#include <algorithm>
#include <limits>

namespace complexes {

using base::Vec3d;
using surface::Status;

namespace {

/// Cells that bound no other, and how near they may be at best: no farther than a support from a point of theirs.
std::vector<std::pair<double, std::uint32_t>> topCells(const Complex& complex, const Vec3d& x) {
    std::vector<std::pair<double, std::uint32_t>> out;
    std::vector<tree::Neighbour> near;
    for (std::uint32_t i = 0; i < complex.cells().size(); ++i) {
        const Cell& cell = complex[i];
        if (cell.bounding)
            continue;
        double atLeast = std::sqrt(cell.bounds.distanceSq(x));
        if (!cell.own.tree().empty()) {
            cell.own.tree().nearest(base::cast<float>(x), 1, near);
            atLeast = std::max(atLeast, 0.999 * std::sqrt(static_cast<double>(near[0].distanceSq)) -
                                            static_cast<double>(cell.own.tree().maxSupport()));
        }
        out.emplace_back(atLeast, i);
    }
    std::sort(out.begin(), out.end());
    return out;
}

/// The foot, and the cell without a higher one that gave it.
std::pair<CellFoot, std::uint32_t> nearestFoot(const Complex& complex, const Vec3d& x, surface::Projector projector) {
    FootOptions options;
    options.projector = projector;
    options.anywhere = true;
    std::pair<CellFoot, std::uint32_t> out;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [atLeast, cell] : topCells(complex, x)) {
        if (atLeast > nearest)
            break;
        const CellFoot foot = footOn(complex, cell, x, options);
        const double d = base::distance(foot.position, x);
        if (foot.ok() ? d < nearest : !out.first.ok() && foot.status != Status::Outside) {
            out = {foot, cell};
            nearest = foot.ok() ? d : nearest;
        }
    }
    return out;
}

/// By differences of gradients.
base::Mat3d hessianOf(const Complex& complex, std::uint32_t cell, const Vec3d& x, const CellFrame& frame) {
    const double step = 1e-3 * frame.unit;
    base::Mat3d out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec3d to;
        to[axis] = step;
        const Vec3d rise = gradientOf(complex, cell, x + to, frame) - gradientOf(complex, cell, x - to, frame);
        for (int row = 0; row < 3; ++row)
            out[row][axis] = rise[static_cast<std::size_t>(row)] / (2 * step);
    }
    return (out + transposed(out)) * 0.5;
}

} // namespace

CellFoot project(const Complex& complex, const Vec3d& x, surface::Projector projector) {
    return nearestFoot(complex, x, projector).first;
}

surface::Evaluationd evaluate(const Complex& complex, const Vec3d& x, surface::Need need) {
    surface::Evaluationd out;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    out.value = out.offCentre = nan;
    out.centroid = out.normal = out.gradient = {nan, nan, nan};
    const auto [foot, cell] = nearestFoot(complex, x, surface::Projector::Almost);
    if (!foot.ok() || complex[cell].dimension != 2)
        return out;
    const CellFrame frame = frameOf(complex, cell, x, foot.axis);
    out.status = frame.status;
    out.cause = frame.cause;
    out.samples = frame.samples;
    out.unit = frame.unit;
    out.agreement = frame.agreement;
    if (!frame.ok())
        return out;
    out.centroid = frame.centre;
    out.normal = frame.axis;
    out.value = dot(frame.axis, x - frame.centre);
    out.offCentre = base::distance(x, frame.centre);
    if (need != surface::Need::Value)
        out.gradient = gradientOf(complex, cell, x, frame);
    if (need == surface::Need::Hessian)
        out.hessian = hessianOf(complex, cell, x, frame);
    return out;
}

} // namespace complexes
