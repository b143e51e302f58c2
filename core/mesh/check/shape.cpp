#include "core/mesh/check/shape.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <limits>

namespace mesh {

using base::Vec3d;

double smallestAngle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    constexpr double rounding = 1e-12; // of the square of the longest side
    const double twiceArea = length(cross(b - a, c - a));
    double sides[3] = {distanceSq(a, b), distanceSq(b, c), distanceSq(c, a)};
    std::sort(sides, sides + 3);
    // It lies opposite to the shortest side, between the two others.
    const double sine = twiceArea, cosine = 0.5 * (sides[1] + sides[2] - sides[0]);
    return twiceArea <= rounding * sides[2] ? 0 : std::atan2(sine, cosine);
}

Shape shapeOf(const Mesh& mesh) {
    const std::size_t n = mesh.triangles.size();
    Shape out;
    if (n == 0)
        return out;
    constexpr std::size_t grain = 4096;
    std::vector<double> angles(n);
    std::vector<Shape> parts(base::chunkCount(n, grain));
    base::parallelChunks(n, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Shape& part = parts[chunk];
        part.shortestEdge = std::numeric_limits<double>::infinity();
        for (std::size_t f = begin; f < end; ++f) {
            const auto at = [&](std::size_t k) { return mesh.positions[mesh.triangles[f][k % 3]]; };
            angles[f] = smallestAngle(at(0), at(1), at(2));
            part.degenerate += angles[f] == 0;
            part.area += 0.5 * length(cross(at(1) - at(0), at(2) - at(0)));
            for (std::size_t k = 0; k < 3; ++k) {
                part.shortestEdge = std::min(part.shortestEdge, distance(at(k), at(k + 1)));
                part.longestEdge = std::max(part.longestEdge, distance(at(k), at(k + 1)));
            }
        }
    });
    out.shortestEdge = parts.front().shortestEdge;
    for (const Shape& part : parts) {
        out.degenerate += part.degenerate;
        out.area += part.area;
        out.shortestEdge = std::min(out.shortestEdge, part.shortestEdge);
        out.longestEdge = std::max(out.longestEdge, part.longestEdge);
    }
    std::sort(angles.begin(), angles.end());
    out.leastAngle = angles.front();
    out.hundredthAngle = angles[n / 100];
    out.medianAngle = angles[n / 2];
    return out;
}

} // namespace mesh
