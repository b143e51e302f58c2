#include "core/mesh/faces/join_boundary.h"

#include "core/base/cells.h"
#include "core/mesh/faces/face_sides.h"

#include <algorithm>
#include <numeric>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

/// Of the longest edge of the boundary there, what is joined at most: small parts of large scenes keep their shape.
constexpr double mostOfEdge = 0.01;

/// For each place on the boundary.
static std::vector<double> tolerances(std::span<const Vec3f> positions, double most,
                                      const std::vector<std::uint64_t>& edges,
                                      const std::vector<std::uint32_t>& boundary) {
    std::vector<double> longest(boundary.size());
    for (const std::uint64_t edge : edges) {
        const double length = edgeLength(positions, edge);
        for (const std::uint64_t end : {edge >> 32, edge & 0xffffffffu}) {
            const auto at = std::lower_bound(boundary.begin(), boundary.end(), end) - boundary.begin();
            double& known = longest[static_cast<std::size_t>(at)];
            known = std::max(known, length);
        }
    }
    for (double& each : longest)
        each = std::min(most, mostOfEdge * each);
    return longest;
}

bool joinBoundary(std::vector<std::uint32_t>& places, std::span<const Vec3f> positions, double tolerance,
                  const std::vector<std::uint64_t>& edges, const std::vector<std::uint32_t>& boundary) {
    const std::vector<double> near = tolerances(positions, tolerance, edges, boundary);
    const Vec3d origin = base::cast<double>(positions[boundary.front()]);
    base::CellMap<std::vector<std::uint32_t>> cells;
    std::vector<std::uint32_t> joined(places.size());
    std::iota(joined.begin(), joined.end(), 0u);
    bool any = false;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        const std::uint32_t place = boundary[i];
        const Vec3d p = base::cast<double>(positions[place]);
        const base::Cell cell = base::cellOf(p, origin, 1 / tolerance);
        base::forCellsAround(cell, [&](const base::Cell& beside) {
            if (const auto* found = cells.find(beside); found && joined[place] == place)
                for (const std::uint32_t other : *found)
                    if (distance(base::cast<double>(positions[other]), p) <= near[i])
                        joined[place] = other;
        });
        if (joined[place] == place)
            cells.at(cell).push_back(place);
        else
            any = true;
    }
    for (std::uint32_t& place : places)
        place = joined[place];
    return any;
}

} // namespace mesh
