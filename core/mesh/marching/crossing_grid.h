// What all grids of cubes have in common: the surface that they cut, where their edges cross it, and which nodes are
// inside (mesh/README 3.2, 3.14). Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/marching/edge_walk.h"
#include "core/mesh/marching/lattice.h"
#include "core/mesh/marching/slabs.h"
#include "core/mesh/marching/solid.h"

#include <optional>
#include <vector>

namespace mesh {

class CrossingGrid {
  public:
    const surface::Surface& surface() const { return m_surface; }
    const SurfaceTraits& traits() const { return m_traits; }
    /// Of the smallest cubes.
    const Lattice& lattice() const { return m_lattice; }
    const std::vector<Crossing>& crossings() const { return m_crossings; }

  protected:
    CrossingGrid(const surface::Surface& surface, const SurfaceTraits& traits, const Lattice& lattice)
        : m_surface(surface), m_traits(traits), m_lattice(lattice) {}
    ~CrossingGrid() = default;

    /// A surfel's tangent disc about its foot on the surface; `unit` is h there.
    struct Disc {
        base::Vec3d foot, normal;
        double unit = 0;
    };
    /// What fn(discs, part) makes of the discs of all surfels, part by part in the order of the tree.
    template <class Part, class Fn>
    std::vector<Part> fromDiscs(const base::Progress& progress, const Fn& fn) const {
        constexpr std::size_t blocksPerTask = 16;
        const std::vector<surfel::BlockPtr> blocks = allBlocks();
        std::vector<Part> parts(base::chunkCount(blocks.size(), blocksPerTask));
        parallelSlabs(blocks.size(), blocksPerTask, progress, "cutting cubes",
                      [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                          fn(discsOf({blocks.data() + begin, end - begin}), parts[chunk]);
                      });
        return parts;
    }

    struct NodeSide {
        NodeValue value;
        SolidSide side = SolidSide::Untold;
    };
    /// Of many nodes.
    std::vector<NodeSide> evaluated(std::span<const base::Vec3f> x) const;
    /// Where there is an inside at both ends, exactly the edges that enter or leave it do.
    bool mayCross(const Edge& edge, const NodeSide& first, const NodeSide& last) const;
    std::optional<Crossing> crossingOn(const Edge& edge, const NodeSide& first, const NodeSide& last,
                                       surface::Source& source, Care care) const;

  private:
    std::vector<surfel::BlockPtr> allBlocks() const;
    std::vector<Disc> discsOf(std::span<const surfel::BlockPtr> blocks) const;

  protected:
    const surface::Surface& m_surface;
    SurfaceTraits m_traits;
    Lattice m_lattice;
    std::optional<Solid> m_solid; ///< of surfaces with sides
    std::vector<Crossing> m_crossings;
};

} // namespace mesh
