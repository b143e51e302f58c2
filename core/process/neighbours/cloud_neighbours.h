// One search for neighbours, and all that estimation takes from it: each position's 12 nearest, what duplicates are
// told by, and normals where they are wanted (process/README 1.6).
#pragma once

#include "core/process/neighbours/neighbour_table.h"

namespace process {

struct CloudNeighbours {
    NeighbourTable table;
    base::LargeArray<float> spacing;        ///< as spacingsOf, the distances rounded first
    base::LargeArray<std::uint8_t> doubles; ///< how many of the nearest are one place with each (duplicates.h)
    std::vector<float> closestPile;         ///< of each cell: least squared distance to a (leastPile - 1)th neighbour
    std::vector<float> farthest;            ///< of each cell: largest squared distance to the last one looked at
    base::LargeArray<base::Vec3f> normals;  ///< as normalsOf; empty unless asked for
};

/// `normalNeighbours`: that normals are estimated from; 0 for none.
CloudNeighbours neighboursOf(const Cloud& cloud, std::size_t normalNeighbours, const base::Progress& progress);

/// The neighbours of what is left when some of a cloud's positions go. Where few do, only those rows are sought again
/// that may have seen one of these; what duplicates are told by is left out.
///
///     KeptNeighbours kept(cloud, std::move(near), stays);    here the cloud may go, to make room for
///     near = std::move(kept).in(left, 18, progress);         the one of what stays
class KeptNeighbours {
  public:
    /// `stays`: for each position of `cloud` whether it does.
    KeptNeighbours(const Cloud& cloud, CloudNeighbours near, std::span<const std::uint8_t> stays);
    /// REQUIRES: a cloud of what stays, and the `normalNeighbours` that `near` was made with.
    CloudNeighbours in(const Cloud& left, std::size_t normalNeighbours, const base::Progress& progress) &&;

  private:
    base::Box3f m_box;                     ///< of the cloud: its order along the curve is laid over it
    std::size_t m_before;                  ///< positions of the cloud
    CloudNeighbours m_near;                ///< numbered as what is left; empty where too much goes
    std::vector<std::uint32_t> m_doubtful; ///< positions whose rows are sought again, ascending, numbered likewise
};

} // namespace process
