#include "core/mesh/faces/large_faces.h"

#include "core/base/ranked.h"
#include "core/mesh/faces/face_spacing.h"
#include "core/mesh/faces/sample_grid.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

constexpr double largeSide = 4;       ///< spacings
constexpr double tooNearVertex = 0.7; ///< spacings

std::vector<FacePoint> pointsOnLargeFaces(const FaceTopology& topology, std::span<const Vec3f> positions,
                                          const base::Progress& progress) {
    std::vector<float> spacings;
    for (const float s : vertexSpacings(topology, positions))
        if (s > 0)
            spacings.push_back(s);
    if (spacings.empty())
        return {};
    const auto spacing = static_cast<double>(base::median(spacings));
    FaceTopology large; // what the sampling looks at
    std::vector<std::uint32_t> number;
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
        const Triangle& f = topology.triangles[t];
        float longest = 0;
        for (std::size_t k = 0; k < 3; ++k)
            longest = std::max(longest, distance(positions[f[k]], positions[f[(k + 1) % 3]]));
        if (static_cast<double>(longest) <= largeSide * spacing || !(topology.areas[t] > 0))
            continue;
        number.push_back(t);
        large.triangles.push_back(f);
        large.normals.push_back(topology.normals[t]);
        large.areas.push_back(topology.areas[t]);
        large.area += topology.areas[t];
    }
    const double count = large.area / (spacing * spacing);
    if (!(count >= 1) || count > static_cast<double>(positions.size()))
        return {};
    std::vector<surfel::Surfel> vertices(positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        vertices[i].position = positions[i];
    const SampleGrid grid(vertices, tooNearVertex * spacing);
    std::vector<FacePoint> out;
    for (FacePoint point : spreadPoints(large, positions, static_cast<std::size_t>(std::ceil(count)), progress)) {
        bool room = true;
        grid.forAround(placeOf(point, large, positions), [&](std::uint32_t, double) { room = false; });
        point.triangle = number[point.triangle];
        if (room)
            out.push_back(point);
    }
    return out;
}

} // namespace mesh
