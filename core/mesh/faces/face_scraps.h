// Parts of triangles so small that each lies in one place: what measures by cells of space sorts into them.
#pragma once

#include "core/mesh/faces/face_topology.h"

#include <span>
#include <vector>

namespace mesh {

struct Scrap {
    base::Vec3f place;
    float area = 0;
    std::uint32_t triangle = 0;
};

/// Scraps of triangle t of sides of `sizes[t]` > 0, of larger ones where slivers would else make millions: no more than
/// some `most` beyond one of each triangle. Triangles without area have none. In the order of the triangles; the same
/// at any thread count. Throws base::Cancelled.
std::vector<Scrap> scrapsOf(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                            std::span<const double> sizes, std::size_t most = 8'000'000);

} // namespace mesh
