// Ways along a surface from point to point: a graph of its surfels' positions, shortest walks in it [Dijkstra59], and
// from these some few ways between two places that nothing short of the whole leads from one to the other of, such as
// around the one or the other side of a hole (process/README 12.3). Walks are too long by some per cent, which differs
// with their direction: what is the shortest shows once they are straightened (geodesic.h).
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <vector>

namespace process {

class Walks {
  public:
    /// The graph: positions with their `neighbours` nearest ones, but none on the other side of something thin.
    Walks(const surface::Surface& surface, std::size_t neighbours, const base::Progress& progress = {});

    /// Positions from `from` to `to`, both places on the surface, the shortest walk first; none where no walk leads
    /// there. At most `most`.
    std::vector<std::vector<base::Vec3d>> between(const base::Vec3d& from, const base::Vec3d& to, std::size_t most,
                                                  const base::Progress& progress = {}) const;

  private:
    struct Field { // of walks from a place
        std::vector<double> distance;
        std::vector<std::uint32_t> before; ///< the position that a walk comes from
    };
    struct Crossing { // of the middle between two places, from a position to the next
        std::uint32_t from = 0, to = 0;
        double length = 0;
    };

    std::vector<std::uint32_t> nearest(const base::Vec3d& x) const;
    Field walked(const base::Vec3d& from, const std::vector<std::uint32_t>& goals, double farthest,
                 const base::Progress& progress) const;
    std::vector<Crossing> crossings(const Field& there, const Field& back, double longest) const;
    std::vector<Crossing> leastOfEach(std::vector<Crossing> crossings, double longest, double apart) const;

    template <class Fn>
    void forNeighbours(std::uint32_t i, const Fn& fn) const {
        for (std::size_t k = m_first[i]; k < m_first[i + 1]; ++k)
            fn(m_neighbour[k], distance(m_position[i], m_position[m_neighbour[k]]));
    }

    std::vector<base::Vec3d> m_position;
    std::vector<std::size_t> m_first; ///< of each position's neighbours, and the end
    std::vector<std::uint32_t> m_neighbour;
    tree::SurfelTree m_tree;
    std::vector<std::uint32_t> m_place, m_firstOfBlock; ///< of each surfel in tree order; of each block
};

} // namespace process
