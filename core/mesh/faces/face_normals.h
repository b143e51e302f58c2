// Normals from faces: smooth within a patch, kept apart where edges are sharp.
//
//     n(fan) = sum of angle x unit normal over the fan's corners, normalised    [Thuermer98]
//     n(x)   = sum of b_k n(fan of corner k) over the barycentric coordinates b of x, normalised; of samples blended
//              with the face's own where the triangle is large (mesh/README 8.3)
#pragma once

#include "core/mesh/faces/face_topology.h"

namespace mesh {

/// Makes one fan of those on both sides of the edges, at both ends.
void joinFans(FaceTopology& topology, std::span<const base::Vec3f> positions, std::span<const SharpEdge> edges);

/// Of each fan; that of one of its triangles where the sum vanishes, zero where none has an area.
std::vector<base::Vec3f> fanNormals(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// 1 for each triangle that looks away from what lies about two of its corners: a flap, folded over its neighbours.
std::vector<std::uint8_t> foldedOver(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// Of each vertex of the file: the sum over its corners, whatever their fans. Zero for vertices without faces, and
/// where a face is folded over so far that it looks away from the sum: points tell more there.
std::vector<base::Vec3f> vertexNormals(const FaceTopology& topology, std::span<const base::Vec3f> positions);

} // namespace mesh
