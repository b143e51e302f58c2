// Triangles that know their neighbours, to be edited: sides flipped, faces and sides split, sides collapsed.
//
// What begins manifold stays so: an operation that would join more than two triangles at an edge, or two fans at a
// vertex, is refused. Faces are known by numbers that stay theirs; those of faces gone are not used again. Surfaces
// without two sides are as welcome as others: a face is turned over where an operation needs it to run like its
// neighbour.
//
// Connectivity only; positions are the caller's. One thread at a time.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

/// Side k of a face lies opposite to its corner k.
struct Side {
    static constexpr std::uint32_t nobody = ~0u;
    std::uint32_t face = nobody;
    int k = 0;

    bool exists() const { return face != nobody; }
    bool operator==(const Side&) const = default;
};

class TriangleNet {
  public:
    static constexpr std::uint32_t none = ~0u;

    /// REQUIRES: edges of one or two triangles, a single fan at every vertex.
    TriangleNet(std::span<const Triangle> triangles, std::size_t vertices);

    /// With those that are gone.
    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(m_faces.size()); }
    bool alive(std::uint32_t face) const { return m_faces[face].corners[0] != none; }
    const Triangle& corners(std::uint32_t face) const { return m_faces[face].corners; }
    std::uint32_t apex(const Side& s) const { return m_faces[s.face].corners[std::size_t(s.k)]; }
    /// The side's ends, in the direction in which its face runs.
    std::uint32_t from(const Side& s) const { return m_faces[s.face].corners[std::size_t((s.k + 1) % 3)]; }
    std::uint32_t to(const Side& s) const { return m_faces[s.face].corners[std::size_t((s.k + 2) % 3)]; }
    /// The same side of the neighbour; does not exist on a rim.
    Side across(const Side& s) const { return unpack(m_faces[s.face].across[std::size_t(s.k)]); }
    bool onRim(const Side& s) const { return !across(s).exists(); }

    /// Makes the neighbour across a side run like its face, so that the side's ends swap roles in it.
    /// REQUIRES: it has one.
    void align(const Side& s);

    /// Faces at a vertex, in order around it; along a rim from one end to the other. None of vertices not in use.
    void fan(std::uint32_t vertex, std::vector<std::uint32_t>& out) const;
    bool onRim(std::uint32_t vertex) const;
    /// Vertices at the other ends of a vertex' sides.
    void neighbours(std::uint32_t vertex, std::vector<std::uint32_t>& out) const;
    bool joined(std::uint32_t a, std::uint32_t b) const;

    /// Not in use yet.
    std::uint32_t addVertex();
    /// Joins the two apices instead of the ends: faces (p, a, b), (q, b, a) become (p, a, q), (q, b, p). False, and
    /// nothing changed, on rims and where the apices are joined already.
    bool flip(const Side& s);
    /// REQUIRES: the vertex is not in use. The new faces' numbers follow the last one.
    void splitFace(std::uint32_t face, std::uint32_t vertex);
    /// The same at a side; a rim's becomes two.
    void splitSide(const Side& s, std::uint32_t vertex);
    /// Moves the vertex into its neighbour; false, and nothing changed, where that would not leave a manifold of the
    /// same topology.
    bool collapse(std::uint32_t vertex, std::uint32_t into);
    /// Takes away a face with two or three sides on rims.
    void removeEar(std::uint32_t face);

  private:
    struct Face {
        Triangle corners{none, none, none};
        std::array<std::uint32_t, 3> across{none, none, none};
    };
    static Side unpack(std::uint32_t packed) {
        return packed == none ? Side{} : Side{packed >> 2, static_cast<int>(packed & 3)};
    }
    static std::uint32_t pack(const Side& s) {
        return s.exists() ? s.face << 2 | static_cast<std::uint32_t>(s.k) : none;
    }
    void tie(const Side& s, const Side& other);
    void turnOver(std::uint32_t face);
    std::uint32_t addFace();
    void setFace(std::uint32_t face, const Triangle& corners);
    Side sideBetween(std::uint32_t a, std::uint32_t b) const;
    int cornerOf(std::uint32_t face, std::uint32_t vertex) const;
    bool mayCollapse(std::uint32_t vertex, std::uint32_t into, const Side& side) const;
    Side walk(std::uint32_t vertex, Side s, std::vector<std::uint32_t>& out) const;

    std::vector<Face> m_faces;
    std::vector<std::uint32_t> m_faceOf; ///< one of each vertex
};

} // namespace mesh
