// Which triangles are adjacent, and where they end: the one structure that all code of the room asks
// (mesh/README 2). It takes any triangles, non-manifold ones too, and surfaces with one side or two; where they are
// manifold it can be edited: sides flipped, faces and sides split, sides collapsed.
//
//     Triangulation t(mesh);
//     t.forEdges([&](const Side& s) { ... t.onBoundary(s) ... });      each edge once
//     t.oneRing(vertex, faces);                                        in order around it
//     boundaryLoops(t)                                                 boundary_loops.h
//     umbrellasOf(t)                                                   umbrellas.h
//
// A corner table: side k of a face lies opposite to its corner k and knows the next side at the same edge. Sides at one
// edge form a cycle: of one side on the boundary, of two inside, of more where the triangles are not manifold. Faces
// keep their numbers; those of removed faces are not used again. A triangle that names a vertex twice has no sides and
// counts as removed.
//
// Connectivity only; positions are the caller's. Edits belong to one thread at a time, reading is for any number.
#pragma once

#include "core/mesh/mesh.h"

#include <span>

namespace mesh {

struct Side {
    static constexpr std::uint32_t nobody = ~0u;
    std::uint32_t face = nobody;
    int k = 0;

    bool exists() const { return face != nobody; }
    bool operator==(const Side&) const = default;
};

class Triangulation {
  public:
    static constexpr std::uint32_t none = ~0u;
    /// Of a face, in the order of the corners that they start from.
    static constexpr std::array<int, 3> sides{2, 0, 1};

    /// REQUIRES: fewer than 2^30 triangles, whose corners are below `vertices`.
    Triangulation(std::span<const Triangle> triangles, std::size_t vertices);
    explicit Triangulation(const Mesh& mesh) : Triangulation(mesh.triangles, mesh.positions.size()) {}

    /// With those that are gone.
    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(m_faces.size()); }
    std::uint32_t vertexCount() const { return static_cast<std::uint32_t>(m_faceOf.size()); }
    bool alive(std::uint32_t face) const { return m_faces[face].corners[0] != none; }
    const Triangle& corners(std::uint32_t face) const { return m_faces[face].corners; }
    /// Which of its corners the vertex is. REQUIRES: it is one.
    int cornerOf(std::uint32_t face, std::uint32_t vertex) const {
        const Triangle& t = m_faces[face].corners;
        return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    }

    std::uint32_t apex(const Side& s) const { return m_faces[s.face].corners[std::size_t(s.k)]; }
    /// The side's ends, in the direction in which its face runs.
    std::uint32_t from(const Side& s) const { return m_faces[s.face].corners[std::size_t((s.k + 1) % 3)]; }
    std::uint32_t to(const Side& s) const { return m_faces[s.face].corners[std::size_t((s.k + 2) % 3)]; }
    std::uint32_t otherEnd(const Side& s, std::uint32_t vertex) const { return from(s) == vertex ? to(s) : from(s); }
    /// The face's other side at one of the side's ends.
    Side besideAt(const Side& s, std::uint32_t vertex) const { return {s.face, 3 - cornerOf(s.face, vertex) - s.k}; }

    /// The next side at the same edge, round and round; on the boundary the side itself.
    Side next(const Side& s) const { return unpack(m_faces[s.face].next[std::size_t(s.k)]); }
    /// The boundary: edges of exactly one face.
    bool onBoundary(const Side& s) const { return m_faces[s.face].next[std::size_t(s.k)] == pack(s); }
    /// The same side of the neighbour; does not exist on the boundary nor where more than two faces share the edge.
    Side across(const Side& s) const {
        const Side other = next(s);
        return other == s || next(other) != s ? Side{} : other;
    }
    std::size_t facesAtEdge(const Side& s) const;
    /// Do face and neighbour run along the side opposite ways, as faces with the same orientation do? REQUIRES: it has
    /// a neighbour.
    bool agrees(const Side& s) const { return from(s) != from(across(s)); }

    /// fn(side) for all sides, face by face.
    template <class Fn>
    void forSides(const Fn& fn) const {
        for (std::uint32_t f = 0; f < faceCount(); ++f)
            for (const int k : sides)
                if (alive(f))
                    fn(Side{f, k});
    }
    /// fn(side) for every edge once, by the side of its first face.
    template <class Fn>
    void forEdges(const Fn& fn) const {
        forSides([&](const Side& s) {
            if (isFirst(s))
                fn(s);
        });
    }

    // At vertices. REQUIRES of all: the vertex' faces form one umbrella (umbrellas.h).

    /// Faces at a vertex, in order around it; from one end of the boundary to the other. None where it is not in use.
    void oneRing(std::uint32_t vertex, std::vector<std::uint32_t>& faces) const;
    /// Vertices at the other ends of a vertex' sides.
    void neighbours(std::uint32_t vertex, std::vector<std::uint32_t>& out) const;
    bool joined(std::uint32_t a, std::uint32_t b) const { return sideBetween(a, b).exists(); }
    /// The two sides on the boundary that end at a vertex; inside they do not exist.
    std::array<Side, 2> boundarySides(std::uint32_t vertex) const;
    bool onBoundary(std::uint32_t vertex) const { return boundarySides(vertex)[0].exists(); }

    /// Goes around a vertex: from a side of it across to the next face, fn(face), and on. Returns the side at which
    /// there is no neighbour to go on to, or none back at the first face.
    template <class Fn>
    Side turn(std::uint32_t vertex, Side s, const Fn& fn) const {
        const std::uint32_t start = s.face;
        for (;;) {
            const Side other = across(s);
            if (!other.exists())
                return s;
            if (other.face == start)
                return {};
            fn(other.face);
            s = besideAt(other, vertex);
        }
    }

    // Edits (triangulation_edits.cpp). REQUIRES of all: edges of one or two faces, one umbrella at every vertex. They
    // stay so: what would join more than two faces at an edge, or two umbrellas at a vertex, is refused. A face is
    // turned over where an edit needs it to run like its neighbour.

    /// Makes the neighbour across a side run like its face, so that the side's ends swap roles in it.
    /// REQUIRES: it has one.
    void align(const Side& s);
    /// Not in use yet.
    std::uint32_t addVertex();
    /// Joins the two apices instead of the ends: faces (p, a, b), (q, b, a) become (p, a, q), (q, b, p). False, and
    /// nothing changed, on the boundary and where the apices are joined already.
    bool flip(const Side& s);
    /// REQUIRES: the vertex is not in use. The new faces' numbers follow the last one.
    void splitFace(std::uint32_t face, std::uint32_t vertex);
    /// The same at a side; one on the boundary becomes two.
    void splitSide(const Side& s, std::uint32_t vertex);
    /// Moves the vertex into its neighbour; false, and nothing changed, where that would not leave a manifold of the
    /// same topology.
    bool collapse(std::uint32_t vertex, std::uint32_t into);
    /// Takes away a face with two or three sides on the boundary.
    void removeEar(std::uint32_t face);

  private:
    struct Face {
        Triangle corners{none, none, none};
        std::array<std::uint32_t, 3> next{none, none, none}; ///< by side: packed
    };
    static Side unpack(std::uint32_t packed) { return {packed >> 2, static_cast<int>(packed & 3)}; }
    static std::uint32_t pack(const Side& s) { return s.face << 2 | static_cast<std::uint32_t>(s.k); }
    void link();
    bool isFirst(const Side& s) const;
    void tie(const Side& s, const Side& other);
    void turnOver(std::uint32_t face);
    std::uint32_t addFace();
    void setFace(std::uint32_t face, const Triangle& corners);
    Side sideBetween(std::uint32_t a, std::uint32_t b) const;
    bool mayCollapse(std::uint32_t vertex, std::uint32_t into, const Side& side) const;

    std::vector<Face> m_faces;
    std::vector<std::uint32_t> m_faceOf; ///< one of each vertex
};

} // namespace mesh
