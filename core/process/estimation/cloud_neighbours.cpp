#include "core/process/estimation/cloud_neighbours.h"

#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/duplicates.h"

#include <limits>

namespace process {

CloudNeighbours neighboursOf(const Cloud& cloud, std::size_t normalNeighbours, const base::Progress& progress) {
    CloudNeighbours out;
    const std::size_t n = cloud.size(), count = std::min(NeighbourTable::most, n > 0 ? n - 1 : 0);
    out.table = NeighbourTable(n, count);
    out.spacing = base::LargeArray<float>(n);
    out.doubles = base::LargeArray<std::uint8_t>(n);
    out.closestPile.assign(cloud.cells().count(), std::numeric_limits<float>::infinity());
    if (normalNeighbours > 0)
        out.normals = base::LargeArray<base::Vec3f>(n);
    const bool plane = normalNeighbours > 0 && n > 2;
    if (count == 0 || !plane)
        std::fill(out.normals.begin(), out.normals.end(), base::Vec3f{0, 0, 1});
    if (count == 0) {
        std::fill(out.doubles.begin(), out.doubles.end(), std::uint8_t(0));
        std::fill(out.spacing.begin(), out.spacing.end(), 0.0f);
        return out;
    }
    const char* const what = plane ? "Estimating normals" : "Looking at neighbours";
    cloud.forEachCell(std::max(count, plane ? normalNeighbours : 0), progress, what, [&](const NearestRows& rows) {
        float closest = std::numeric_limits<float>::infinity();
        for (std::size_t r = 0; r < rows.count; ++r) {
            const std::size_t i = rows.first + r;
            const auto index = std::span(rows.index).subspan(r * rows.k, rows.k);
            const auto distanceSq = std::span(rows.distanceSq).subspan(r * rows.k, rows.k);
            out.table.set(i, index.first(count));
            out.doubles[i] = static_cast<std::uint8_t>(duplicatesBeside(distanceSq.first(count)));
            out.spacing[i] = spacingOfRing(distanceSq.first(count));
            if (count >= leastPile - 1)
                closest = std::min(closest, distanceSq[leastPile - 2]);
            if (plane) {
                const std::size_t k = std::min(normalNeighbours, rows.k);
                out.normals[i] = planeNormal(cloud.positions(), i, index.first(k), distanceSq.first(k));
            }
        }
        out.closestPile[rows.cell] = closest;
    });
    return out;
}

} // namespace process
