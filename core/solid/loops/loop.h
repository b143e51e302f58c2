// A boundary loop as the edge of a patch that is to fill it: places one spacing apart, with what the surface is there.
//
// Model coordinates, float64. Immutable values.
#pragma once

#include "core/surface/curves/boundary.h"

#include <algorithm>
#include <span>
#include <string>

namespace solid {

struct LoopPoint {
    base::Vec3d position;
    base::Vec3d normal;  ///< unit, of the surface
    base::Vec3d outward; ///< unit, along the surface into the hole
    double spacing = 0;  ///< between surfels around
    double support = 0;  ///< of theirs
    bool corner = false; ///< the loop turns sharply there
};

/// Counter-clockwise about the hole as seen from where the normals point: the surface is to the right.
struct Loop {
    std::vector<LoopPoint> points;
    double length = 0;
    base::Vec3d middle;

    std::size_t size() const { return points.size(); }
    double meanSpacing() const;
};

/// The loop's points about `coarser` spacings apart, 6 at least, where spacings are those of the surfels around, or of
/// those so many spacings `behind` it: the last rows have neighbours on one side only, which lie a quarter farther
/// apart. (Small patches come out denser than asked for, and make up for that.) REQUIRES: a closed curve.
Loop evenLoop(const surface::Surface& surface, const surface::BoundaryCurve& curve, double coarser = 1,
              double behind = 0);

/// Of what a loop's places have, about each of them: nearer ones count more, up to `reach` places away.
template <class T>
std::vector<T> meansAlong(const std::vector<T>& of, std::size_t reach) {
    const std::size_t n = of.size();
    const auto sum = static_cast<double>((reach + 1) * (reach + 1));
    std::vector<T> out(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k <= 2 * reach; ++k)
            out[i] += of[(i + n * reach + k - reach) % n] * (static_cast<double>(1 + std::min(k, 2 * reach - k)) / sum);
    return out;
}

/// How far beyond the edge of a half-plane full of surfels a limit draws the boundary, in h; below 0: before it.
double pastEdge(float limit);

/// Of a loop that the surface's limit draws, where the area ends that the surfels stand for.
Loop edgeOf(const surface::Surface& surface, const Loop& loop);

/// Where along a loop: the place before, and the share of the way from it to the next.
struct PlaceOnLoop {
    std::size_t before = 0;
    double share = 0;
};
/// `ways`: of each place along the loop, and of its end. Any way; its end leads around.
PlaceOnLoop placeOnLoop(std::span<const double> ways, double way);

/// The same loop without the raggedness of surfels that were taken or left one by one: no place goes farther than half
/// a spacing, and round loops stay as wide.
void straighten(Loop& loop, std::size_t reach);

/// Which loops come nearer than half a spacing to themselves, other than along themselves, or to another one.
std::vector<std::uint8_t> touching(const std::vector<Loop>& loops);

} // namespace solid
