// The loops of segments around a cube (mesh/README 3.5). Internal to the room.
//
// Every crossing of a cube lies on two of its faces and has one segment in each: to another crossing or, if it is loose
// there, to the vertex where the surface ends. Crossings and ends therefore form closed loops, and chains between two
// ends. An edge between its two ends closes a chain; that edge is boundary of the mesh.
#pragma once

#include "core/mesh/marching/boundary_trace.h"
#include "core/mesh/marching/cube_graph.h"

namespace mesh {

/// Where loose ends lead: to a vertex where the surface ends, or to the loose crossing at the other end of the trace.
class LooseEnds {
  public:
    /// Ends are numbered after the crossings.
    LooseEnds(const CrossingGrid& grid, std::vector<LooseEnd> ends, std::span<const TracedEnd> traced);

    /// The vertex beside the loose crossing in a face. REQUIRES: it is loose there.
    std::uint32_t partner(std::uint32_t node, int axis, std::uint32_t crossing) const;
    std::span<const LooseEnd> ends() const { return m_ends; }
    /// Indices of the loose ends that became boundary vertices, in order.
    const std::vector<std::uint32_t>& boundary() const { return m_boundary; }

  private:
    std::vector<LooseEnd> m_ends; ///< by node, axis, index
    std::vector<std::uint32_t> m_partner;
    std::vector<std::uint32_t> m_boundary;
};

/// Replaces `out` by the loops of the cube above a node; none where it lacks a corner. `around` as in faceAt.
void loopsOf(const SurfaceGrid& grid, const LooseEnds& loose, const Neighbourhood& around, const GridIndex& place,
             std::vector<Loop>& out);

} // namespace mesh
