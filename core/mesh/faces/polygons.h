// Faces of any number of corners, as files hold them, and the triangles that they are cut into.
#pragma once

#include "core/mesh/mesh.h"

#include <span>
#include <vector>

namespace mesh {

/// Faces as lists of vertex numbers, one behind the other: face i has the corners [ends[i - 1], ends[i]).
struct Polygons {
    std::vector<std::uint32_t> corners;
    std::vector<std::size_t> ends;

    std::size_t size() const { return ends.size(); }
    std::span<const std::uint32_t> face(std::size_t i) const {
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        return {corners.data() + begin, ends[i] - begin};
    }
    /// Ends the face whose corners were pushed last.
    void close() { ends.push_back(corners.size()); }
    void append(const Polygons& more);
    /// Gives every corner the number `renumbered[corner]`, and leaves out faces with a corner that has none (the
    /// largest number) or that is beyond the list; returns how many.
    std::size_t renumber(std::span<const std::uint32_t> renumbered);
};

/// Cut along diagonals inside each face, in its mean plane (ear clipping, [Meisters75]), the roundest ear first; faces
/// that cross themselves come out as they can. Repeated corners are taken once; faces of fewer than three are none.
/// REQUIRES: corners below positions.size().
std::vector<Triangle> triangulated(const Polygons& polygons, std::span<const base::Vec3f> positions);

} // namespace mesh
