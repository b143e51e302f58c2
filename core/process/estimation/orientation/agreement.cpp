#include "core/process/estimation/orientation/agreement.h"

#include "core/base/parallel.h"
#include "core/process/estimation/orientation/contradictions.h"
#include "core/process/estimation/orientation/global_orientation.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace process {

namespace {

/// A normal gone wrong here and there is no other side.
constexpr double clearShare = 0.02;
/// What is left where the disagreement was in the signs alone.
constexpr double leftShare = 0.25;
constexpr std::size_t looked = 100'000, grain = 4096;

} // namespace

double opposedShare(const Cloud& cloud, const NeighbourTable& links, std::span<const base::Vec3f> normals) {
    const auto x = cloud.positions();
    const std::size_t stride = std::max<std::size_t>(1, cloud.size() / looked), count = cloud.size() / stride;
    std::vector<std::size_t> opposed(base::chunkCount(count, grain));
    base::parallelChunks(count, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t i = k * stride;
            const NeighbourTable::Row row = links.row(i);
            const auto isOpposed = [&](std::uint32_t j) {
                return lookOpposite(normals[i], normals[j]) && inSheet(x[j] - x[i], normals[i]);
            };
            opposed[chunk] +=
                std::any_of(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(links.count()), isOpposed) ? 1 : 0;
        }
    });
    return static_cast<double>(std::accumulate(opposed.begin(), opposed.end(), std::size_t(0))) /
           static_cast<double>(std::max<std::size_t>(1, count));
}

bool makeAgree(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
               const base::Progress& progress) {
    const double before = opposedShare(cloud, links, normals);
    if (before < clearShare)
        return false;
    std::vector<base::Vec3f> turned(normals.begin(), normals.end());
    if (!orientGlobally(cloud, links, turned, progress) || opposedShare(cloud, links, turned) > leftShare * before)
        return false;
    std::copy(turned.begin(), turned.end(), normals.begin());
    return true;
}

} // namespace process
