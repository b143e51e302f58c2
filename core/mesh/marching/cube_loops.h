// The loops of segments around a cube (RULES-4 B5). Internal to the room.
//
// Every crossing of the cube lies on two of its faces and has one segment in each: to another crossing, or to the rim
// vertex where it is loose. So crossings and rim vertices make closed loops and chains between two rim vertices; a
// chain is closed by the edge between them, which is boundary of the mesh.
#pragma once

#include "core/mesh/marching/cube_graph.h"
#include "core/mesh/marching/rim_trace.h"

namespace mesh {

/// Where loose ends lead to: a rim vertex, or the loose crossing at the other end of their trace.
class LooseEnds {
  public:
    /// Vertices of rims are numbered after the crossings.
    LooseEnds(const SurfaceGrid& grid, std::vector<LooseEnd> ends, std::span<const TracedEnd> traced);

    /// The vertex beside the loose crossing in a face. REQUIRES: it is loose there.
    std::uint32_t partner(std::uint32_t node, int axis, std::uint32_t crossing) const;
    std::span<const LooseEnd> ends() const { return m_ends; }
    /// Indices of the ends that became rim vertices, in their order.
    const std::vector<std::uint32_t>& rims() const { return m_rims; }

  private:
    std::vector<LooseEnd> m_ends; ///< by node, axis, index
    std::vector<std::uint32_t> m_partner;
    std::vector<std::uint32_t> m_rims;
};

/// The loops of the cube above a node, cleared and filled; none where it lacks a corner. `around` as in faceAt.
void loopsOf(const SurfaceGrid& grid, const LooseEnds& loose, const Neighbourhood& around, const Place& place,
             std::vector<Loop>& out);

} // namespace mesh
