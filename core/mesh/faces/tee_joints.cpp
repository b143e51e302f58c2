#include "core/mesh/faces/tee_joints.h"

#include "core/base/cells.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;

TeeJoints teeJoints(std::span<const base::Vec3f> positions, std::span<const std::uint64_t> edges, double tolerance) {
    const auto at = [&](std::uint64_t place) {
        return base::cast<double>(positions[static_cast<std::uint32_t>(place)]);
    };
    TeeJoints out;
    std::vector<std::uint32_t> places;
    double lengths = 0;
    for (const std::uint64_t edge : edges) {
        places.push_back(static_cast<std::uint32_t>(edge >> 32));
        places.push_back(static_cast<std::uint32_t>(edge));
        lengths += distance(at(edge >> 32), at(edge));
    }
    if (!(lengths > 0) || !std::isfinite(lengths))
        return out;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const double cell = std::max(lengths / static_cast<double>(edges.size()), 2 * tolerance);
    const Vec3d origin = at(places.front());
    base::CellMap<std::vector<std::uint32_t>> cells;
    for (const std::uint32_t place : places)
        cells.at(base::cellOf(at(place), origin, 1 / cell)).push_back(place);
    struct On {
        double along; ///< the edge, 0 to 1
        std::uint32_t place;
        auto operator<=>(const On&) const = default;
    };
    std::vector<On> found;
    for (const std::uint64_t edge : edges) {
        const Vec3d from = at(edge >> 32), way = at(edge) - from;
        const double size = length(way);
        const auto steps = static_cast<std::size_t>(std::ceil(size / cell));
        found.clear();
        for (std::size_t step = 0; size > 2 * tolerance && step <= steps; ++step) {
            const Vec3d here = from + way * (static_cast<double>(step) / static_cast<double>(steps));
            base::forCellsAround(base::cellOf(here, origin, 1 / cell), [&](const base::Cell& near) {
                if (const std::vector<std::uint32_t>* there = cells.find(near))
                    for (const std::uint32_t place : *there) {
                        const Vec3d to = at(place) - from;
                        const double along = dot(to, way) / (size * size);
                        if (along * size > tolerance && (1 - along) * size > tolerance &&
                            distance(to, way * along) <= tolerance)
                            found.push_back({along, place});
                    }
            });
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        if (found.empty())
            continue;
        std::vector<std::uint32_t>& inside = out[edge];
        for (const On& each : found)
            inside.push_back(each.place);
    }
    return out;
}

} // namespace mesh
