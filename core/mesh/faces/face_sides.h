// The sides of faces, sorted by the edges in which they meet: what all questions of who lies beside whom are asked of
// while a file's faces are put in order (face_topology.h).
#pragma once

#include "core/mesh/faces/tee_joints.h"
#include "core/mesh/mesh.h"

namespace mesh {

/// Which vertices are one, and which of these lie on sides of triangles that they are no corners of.
struct Places {
    std::vector<std::uint32_t> of; ///< of each vertex: the first that stands for all at its place
    TeeJoints joints;

    Triangle at(const Triangle& t) const { return {of[t[0]], of[t[1]], of[t[2]]}; }
};

/// The first vertex at exactly the same place, for every vertex.
std::vector<std::uint32_t> placesOf(std::span<const base::Vec3f> positions);

/// The side of a triangle from corner `corner` to the next, or a part of it between places that lie on it.
struct FaceSide {
    std::uint64_t key;    ///< the lower place, then the higher
    std::uint32_t corner; ///< 3 t + k
    bool downwards;       ///< runs from the higher place to the lower
};

/// By key, then corner. Sides between corners at one place are left out.
std::vector<FaceSide> sidesOf(std::span<const Triangle> triangles, const Places& places);

/// Between the two places of an edge.
double edgeLength(std::span<const base::Vec3f> positions, std::uint64_t key);

/// fn(sides) for every edge: the sides of the triangles that meet in it.
template <class Fn>
void forEdges(std::span<const FaceSide> sides, const Fn& fn) {
    for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
        for (end = begin + 1; end < sides.size() && sides[end].key == sides[begin].key;)
            ++end;
        fn(sides.subspan(begin, end - begin));
    }
}

} // namespace mesh
