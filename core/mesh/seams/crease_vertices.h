// Which cells the vertices of a mesh lie on, and where its edges cross creases (mesh/README 10). Internal to the room.
#pragma once

#include "core/cells/cell_source.h"
#include "core/mesh/mesh.h"

#include <algorithm>
#include <optional>
#include <span>

namespace mesh {

/// Cells that meet in a place: one within a face, two on a seam, more at a corner; none where that is not known.
/// Of more than `most` the others are left out.
class CellsAt {
  public:
    static constexpr std::size_t most = 6;

    CellsAt() = default;
    CellsAt(std::initializer_list<std::uint32_t> cells) {
        for (const std::uint32_t cell : cells)
            add(cell);
    }
    void add(std::uint32_t cell) {
        if (!has(cell) && m_count < most)
            m_cells[m_count++] = cell;
    }
    bool has(std::uint32_t cell) const { return std::find(begin(), end(), cell) != end(); }
    bool shares(const CellsAt& o) const {
        return std::any_of(begin(), end(), [&](std::uint32_t cell) { return o.has(cell); });
    }
    bool sameAs(const CellsAt& o) const {
        return m_count == o.m_count && std::all_of(begin(), end(), [&](std::uint32_t cell) { return o.has(cell); });
    }
    std::size_t count() const { return m_count; }
    bool operator==(const CellsAt&) const = default; ///< the same in the same order
    const std::uint32_t* begin() const { return m_cells; }
    const std::uint32_t* end() const { return m_cells + m_count; }

  private:
    std::uint32_t m_cells[most] = {};
    std::uint32_t m_count = 0;
};

/// A place on a seam or at a corner.
struct CreasePlace {
    CellsAt cells;
    base::Vec3d position;
    base::Vec3f normal; ///< mean of those of the cells
};

/// A vertex on the surface of its cell.
struct CreaseVertex {
    CellsAt cells;         ///< that it lies on
    std::uint32_t own = 0; ///< the one that it came to first
    base::Vec3d position;
    base::Vec3f normal; ///< of its own cell
    bool mixed = false; ///< other cells are near

    void goTo(const CreasePlace& place) {
        cells = place.cells;
        position = place.position;
        normal = place.normal;
    }
    bool atCorner() const { return cells.count() >= 3; }
};

/// May creases move a vertex? Not those where the mesh ends. Bridges are inside: at acute edges the smooth surface has
/// gaps, and its cells have none.
inline bool movable(const Mesh& mesh, std::size_t v) {
    return mesh.kinds.empty() || mesh.kinds[v] == VertexKind::Inner || mesh.kinds[v] == VertexKind::Bridge;
}

/// Vertices near creases come to rest on the face of their cell; others stay as they are, to the bit. In parallel, the
/// same at any thread count.
std::vector<CreaseVertex> ontoFaces(const cells::CellSurface& surface, const Mesh& mesh);

/// Where creases are, for one thread.
class CreaseFinder {
  public:
    explicit CreaseFinder(const cells::CellSurface& surface) : m_source(surface) {}

    /// The place of a seam nearest to x, between one of the cells `a` and one of `b`; where that is cut off by a third
    /// one, their corner. Nothing where none of them meet, or farther away than `reach`.
    std::optional<CreasePlace> between(const CellsAt& a, const CellsAt& b, const base::Vec3d& x, double reach);
    /// The corner of three cells and more.
    std::optional<CreasePlace> corner(const CellsAt& cells, const base::Vec3d& x, double reach);

  private:
    std::optional<CreasePlace> seam(std::uint32_t a, std::uint32_t b, const base::Vec3d& x, double reach);
    std::optional<CreasePlace> accepted(const CellsAt& cells, const base::Vec3d& x);
    bool meet(std::uint32_t a, std::uint32_t b);

    cells::CellSource m_source;
};

} // namespace mesh
