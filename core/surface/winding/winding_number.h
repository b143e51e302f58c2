// The generalised winding number of oriented surfels [Jacobson13, Barill18]: 1 inside of what they enclose, 0 outside,
// and between where they leave gaps (surface/README 11).
//
//     w(x) = 1 / 4 pi  sum a_i n_i . (p_i - x) / (|p_i - x|^2 + a_i / 4)^(3/2)
//
// a_i is the area that a surfel stands for (surfel_areas.h). Far groups of surfels count as one dipole at their centre
// of area: whole nodes, blocks and clusters of the tree. A query costs some microseconds, whatever the model's size.
//
// Ownership: holds what it needs by value, the tree may go. Immutable; any number of threads may ask.
#pragma once

#include "core/surface/winding/surfel_areas.h"

namespace surface {

class WindingNumber {
  public:
    /// REQUIRES: oriented normals. Throws base::Cancelled.
    explicit WindingNumber(const tree::SurfelTree& tree, const base::Progress& progress = {},
                           Areas which = Areas::Each);

    double at(const base::Vec3d& x) const;
    /// Its derivative, in 1 / model units: points inwards.
    base::Vec3d gradient(const base::Vec3d& x) const;

    /// One of the terms: a surfel, or a group of them.
    struct Dipole {
        base::Vec3f place;
        base::Vec3f area; ///< times the normal
        float softSq = 0; ///< what is added to the squared distance
    };
    /// Of all surfels: what the sum is without grouping.
    const std::vector<Dipole>& dipoles() const { return m_dipoles; }

  private:
    struct Cell {
        Dipole whole;
        float farSq = 0;                    ///< squared distance from which it counts as one dipole
        std::uint32_t next = 0;             ///< the cell after all that are below this one
        std::uint32_t first = 0, count = 0; ///< its surfels, where nothing is below
    };
    template <class Fn>
    void forTerms(const base::Vec3d& x, const Fn& fn) const;
    void addNode(const tree::Node& node, const base::Box3f& box);
    void addBlock(const surfel::SurfelBlock& block);
    void finish(std::size_t cell, std::size_t firstDipole, const base::Box3f& box);

    std::vector<Dipole> m_dipoles; ///< in tree order
    std::vector<Cell> m_cells;     ///< each before those below it
    std::vector<float> m_areas;    ///< while it is built
};

} // namespace surface
