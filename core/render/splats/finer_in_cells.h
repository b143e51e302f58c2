// Finer discs (finer_blocks.h) near the creases of models with cells: each lies on the surface of its surfel's own
// cell, and ends where the other cells end that (cells/README 3), which is found on their surfaces: where an edge is
// bent, its discs follow the bend.
//
// Float64; answers depend on the place and the model alone. One thread at a time.
#pragma once

#include "core/cells/cell_source.h"
#include "core/render/splats/disc_cuts.h"

namespace render {

class FinerInCells {
  public:
    /// `radiusOfSupport`: radius of a disc in supports. `cells` outlives it.
    FinerInCells(const cells::CellSurface& cells, float radiusOfSupport) : m_source(cells), m_radius(radiusOfSupport) {}

    /// Have several cells weight there, or end beside ones that have none? Else the smooth surface tells all.
    bool concerns(const base::Vec3f& x);
    /// May the cell's surface about a foot of x end so near?
    bool endsWithin(const base::Vec3f& x, std::uint32_t cell, float within);
    /// Brings a disc to its foot on the cell, where that goes on. False where no foot is within `far`.
    bool place(surfel::Surfel& disc, std::uint32_t cell, float far);
    /// The same anywhere, and from beyond an edge, by up to its radius, back to that; `code` tells
    /// where it ends. False where no foot is within `far`, or none of the cell's surface.
    bool settle(surfel::Surfel& disc, std::uint32_t cell, float far, CutCode& code);

  private:
    /// A line in the disc's plane where another cell ends it, in model units; alone or together with another one.
    struct Edge {
        base::Vec3d direction; ///< away from what is kept
        double distance = 0;
        std::uint32_t other = 0; ///< the cell
        bool alone = false;
    };
    /// What tells of the other cell: its f, or a plane.
    struct Level {
        double value = 0; ///< above 0 where it ends the disc's
        base::Vec3d slope;
    };

    static void put(surfel::Surfel& disc, const base::Vec3d& y, const base::Vec3d& gradient);
    std::optional<std::size_t> footOf(base::Vec3d& y, std::uint32_t cell);
    std::optional<Level> levelOf(std::size_t other, cells::Meeting how);
    static std::optional<Edge> edgeOf(const Level& level, const base::Vec3d& normal);
    double toleranceHere(std::size_t i);
    bool isCutOff(std::size_t i);
    bool isGone(std::uint32_t cell);
    void findEdges(const base::Vec3d& normal, std::size_t i, double within);
    void follow(Edge& edge, const base::Vec3d& y, const base::Vec3d& normal, std::uint32_t cell, double within);

    cells::CellSource m_source;
    float m_radius;
    std::vector<Edge> m_edges;
};

} // namespace render
