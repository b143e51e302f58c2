// Normals of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/neighbours/neighbour_table.h"

namespace process {

/// The normals of the planes through each position of the rows and its nearest `k`, into `out`, one a row; their signs
/// mean nothing. REQUIRES: 1 <= k <= rows.k.
void planeNormals(std::span<const base::Vec3f> positions, const NearestRows& rows, std::size_t k, base::Vec3f* out);
/// Unit normals without a meaningful sign, one per position.
std::vector<base::Vec3f> normalsOf(const Cloud& cloud, int neighbours = 18, const base::Progress& progress = {});

/// What the signs of normals say that shall be oriented. Mostly: in each component that has no clear outside the side
/// of most of them stays.
enum class Sides { Unknown, Mostly };

/// Flips unit normals in place so that they agree over the surface. False where they cannot: along some seam neighbours
/// that are certain of each other end up opposite, as on a Moebius strip.
/// `links`: the nearest neighbours along which they are compared.
bool orient(const Cloud& cloud, const NeighbourTable& links, std::span<base::Vec3f> normals,
            const base::Progress& progress = {}, Sides given = Sides::Unknown);

} // namespace process
