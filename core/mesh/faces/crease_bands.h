// Creases that end within a face (cells/README 1.4): the samples on either side of such an edge become a band of their
// own, which is smooth to the rest of the face and sharp to the band across, less and less so towards the edge's end.
#pragma once

#include "core/cells/labels.h"
#include "core/mesh/faces/edge_crossings.h"
#include "core/mesh/faces/sample_grid.h"

namespace mesh {

/// Does a link lead from one side of a wall to the other?
bool throughMatter(const surfel::Surfel& a, const surfel::Surfel& b);

class CreaseBands {
  public:
    /// `faces`: of each sample. `edges`: all of these faces; those with one face on both sides are meant. `support` is
    /// that of the samples, which the grid finds within 2.2 spacings. Bands are numbered from `firstBand`, above all
    /// faces.
    CreaseBands(const EdgeCrossings& edges, const SampleGrid& grid, std::span<const surfel::Surfel> samples,
                std::span<const std::uint32_t> faces, double spacing, double support, std::uint32_t firstBand);

    /// Of each sample: its face, or a number of its own for each band.
    const std::vector<std::uint32_t>& cells() const { return m_cells; }
    /// Partner, sign and sharpness between bands; other labels stay as they are.
    void fade(std::span<cells::Label> labels) const;

  private:
    EdgeCrossings::Crossed crossed(std::uint32_t a, std::uint32_t b) const {
        return m_edges.crossed(m_faces[a], m_grid.at(a), m_grid.at(b));
    }
    void split();
    /// fn(b) for the samples of the same face around a, links through matter left out.
    template <class Fn>
    void forLinks(std::uint32_t a, const Fn& fn) const;
    std::uint32_t across(std::uint32_t band) const { return m_firstBand + ((band - m_firstBand) ^ 1u); }

    const EdgeCrossings& m_edges;
    const SampleGrid& m_grid;
    std::span<const surfel::Surfel> m_samples;
    std::span<const std::uint32_t> m_faces;
    double m_spacing, m_support;
    std::uint32_t m_firstBand = 0;
    std::vector<double> m_convex; ///< of each pair of bands, by links that cross: positive convex
    std::vector<std::uint32_t> m_cells;
};

} // namespace mesh
