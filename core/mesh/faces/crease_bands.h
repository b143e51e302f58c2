// Creases that end within a face (cells/README 1.4): the samples on either side of such an edge become a band of their
// own, which is smooth to the rest of the face and sharp to the band across, less and less so towards the edge's end.
#pragma once

#include "core/cells/labels.h"
#include "core/mesh/faces/face_topology.h"
#include "core/mesh/faces/sample_grid.h"

namespace mesh {

/// On which side of an edge between two faces p lies: positive on that of the left triangle.
double sideOf(const FaceTopology& topology, const SharpEdge& edge, const base::Vec3d& p);

class CreaseBands {
  public:
    /// `faces`: of each sample. `edges`: those with the same face on both sides, which is `edgeFaces` of each.
    /// `support` is that of the samples, which the grid finds within 2.2 spacings. Bands are numbered from `firstBand`,
    /// above all faces.
    CreaseBands(const FaceTopology& topology, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
                std::span<const std::uint32_t> faces, std::span<const SharpEdge> edges,
                std::span<const std::uint32_t> edgeFaces, double spacing, double support, std::uint32_t firstBand);

    /// Of each sample: its face, or a number of its own for each band.
    const std::vector<std::uint32_t>& cells() const { return m_cells; }
    /// Partner, sign and sharpness between bands; other labels stay as they are.
    void fade(std::span<cells::Label> labels) const;

  private:
    /// The edge that a link between two samples crosses; null for none.
    const SharpEdge* crossed(std::uint32_t a, std::uint32_t b) const;
    bool throughMatter(std::uint32_t a, std::uint32_t b) const;
    void findTips();
    void findMarks();
    void split();
    /// fn(b) for the samples of the same face around a, links through matter left out.
    template <class Fn>
    void forLinks(std::uint32_t a, const Fn& fn) const;
    std::uint32_t across(std::uint32_t band) const { return m_firstBand + ((band - m_firstBand) ^ 1u); }

    const FaceTopology& m_topology;
    const SampleGrid& m_grid;
    std::span<const surfel::Surfel> m_samples;
    std::span<const std::uint32_t> m_faces;
    std::span<const SharpEdge> m_edges;
    std::span<const std::uint32_t> m_edgeFaces;
    double m_spacing, m_support;
    std::vector<std::uint8_t> m_tips; ///< bit 0: the edge's beginning is the end of the crease; bit 1: its end is
    std::vector<bool> m_near; ///< samples beside such edges: one of them is at an end of every link that crosses
    base::CellMap<std::vector<std::uint32_t>> m_marks; ///< edges by places on them
    std::uint32_t m_firstBand = 0;
    std::vector<double> m_convex; ///< of each pair of bands, by links that cross: positive convex
    std::vector<std::uint32_t> m_cells;
};

} // namespace mesh
