// Normals of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/estimation/neighbour_table.h"

namespace process {

/// The normal of the plane through position i and its neighbours, nearest first; its sign means nothing.
base::Vec3f planeNormal(std::span<const base::Vec3f> positions, std::size_t i, std::span<const std::uint32_t> index,
                        std::span<const float> distanceSq);
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
