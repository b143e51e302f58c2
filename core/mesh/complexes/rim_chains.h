// The vertices along the curves of a complex (mesh/README 11.2): what each patch cut its curve at, brought together, so
// that all patches of a curve have the same vertices there. Internal to the room.
#pragma once

#include "core/complexes/curve_trace.h"
#include "core/mesh/complexes/patch_mesh.h"

#include <map>

namespace mesh {

class RimChains {
  public:
    /// REQUIRES: patches by their number in the complex; those of other cells are empty.
    RimChains(const complexes::Complex& complex, const std::vector<PatchMesh>& patches);

    /// Those that patches share.
    const std::vector<base::Vec3d>& vertices() const { return m_vertices; }
    /// Of a patch's vertex that lies on the boundary.
    std::uint32_t vertexOf(std::uint32_t patch, std::uint32_t v) const { return m_of[patch].at(v); }
    /// What lies along the curves between two of them, from a to b, without these; nothing where no curve of the patch
    /// leads from one to the other.
    std::vector<std::uint32_t> between(std::uint32_t patch, std::uint32_t a, std::uint32_t b) const;

  private:
    struct Chain {
        std::vector<std::uint32_t>
            vertices; ///< from one end to the other, both included; of a closed curve the first twice
        bool closed = false;
    };
    using Places = std::vector<std::size_t>; ///< in a chain

    /// `vertices`: those that lie on the curve, as patch and number in it.
    void addCurve(const std::vector<PatchMesh>& patches, std::uint32_t curve,
                  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& vertices);
    Places placesIn(const Chain& chain, std::uint32_t v) const;
    std::vector<std::uint32_t> along(const Chain& chain, std::uint32_t a, std::uint32_t b) const;

    const complexes::Complex& m_complex;
    std::vector<base::Vec3d> m_vertices;
    std::map<std::uint32_t, std::uint32_t> m_points; ///< cells of dimension 0
    std::map<std::uint32_t, Chain> m_chains;         ///< by curve
    std::vector<std::map<std::uint32_t, std::uint32_t>> m_of;
};

} // namespace mesh
