// Faces of any number of corners, as files hold them, and the triangles that they are cut into.
#pragma once

#include "core/mesh/faces/picture.h"
#include "core/mesh/mesh.h"

#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace mesh {

/// Faces as lists of vertex numbers, one behind the other: face i has the corners [ends[i - 1], ends[i]).
///
/// What faces look like stands beside them, in lists that are empty where no face has it: of each corner its place in a
/// picture, of each face the number of its picture and a colour of its own.
struct Polygons {
    struct Place {
        float u = std::numeric_limits<float>::quiet_NaN(), v = u;
    };
    static constexpr std::uint32_t noPicture = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::uint32_t> corners;
    std::vector<std::size_t> ends;
    std::vector<Place> places;                            ///< of corners; not finite where there is none
    std::vector<std::uint32_t> pictureOf;                 ///< of faces: number in `pictures`, or noPicture
    std::vector<surfel::Colour> colours;                  ///< of faces
    std::vector<std::shared_ptr<const Picture>> pictures; ///< null: could not be read

    bool painted() const { return !colours.empty() || (!places.empty() && !pictureOf.empty() && !pictures.empty()); }

    std::size_t size() const { return ends.size(); }
    std::span<const std::uint32_t> face(std::size_t i) const {
        const std::size_t begin = i == 0 ? 0 : ends[i - 1];
        return {corners.data() + begin, ends[i] - begin};
    }
    /// Ends the face whose corners were pushed last.
    void close() { ends.push_back(corners.size()); }
    /// Pictures are those of this. REQUIRES: the same lists have entries, unless one of the two has no faces.
    void append(const Polygons& more);
    /// Gives every corner the number `renumbered[corner]`, and leaves out faces with a corner that has none (the
    /// largest number) or that is beyond the list; returns how many.
    std::size_t renumber(std::span<const std::uint32_t> renumbered);
};

/// Triangles with where they come from.
struct CutPolygons {
    std::vector<Triangle> triangles; ///< vertices
    std::vector<Triangle> corners;   ///< the same as numbers in Polygons::corners
    std::vector<std::uint32_t> faces;
};

/// Cut along diagonals inside each face, in its mean plane (ear clipping, [Meisters75]), the roundest ear first; faces
/// that cross themselves come out as they can. Repeated corners are taken once; faces of fewer than three are none.
/// REQUIRES: corners below positions.size().
CutPolygons cut(const Polygons& polygons, std::span<const base::Vec3f> positions);
std::vector<Triangle> triangulated(const Polygons& polygons, std::span<const base::Vec3f> positions);

} // namespace mesh
