// Spacings at places, and what they ask for around themselves: a spacing that grows with the distance from a place, but
// no faster than supports may (process/README 1.3).
#pragma once

#include "core/base/box.h"

#include <cstdint>
#include <vector>

namespace mesh {

struct SpacedPlace {
    base::Vec3d place;
    double spacing = 0; ///< > 0
    double reach = 0;   ///< so far around it the same holds
};

class NearSpacings {
  public:
    /// `slope`: by which spacings differ over a distance.
    NearSpacings(std::vector<SpacedPlace> places, double slope);

    /// The least that any place allows at `p`; `most` where none asks for less. Safe for threads. Time: that of a
    /// search among those that ask for less.
    double at(const base::Vec3d& p, double most) const;

  private:
    struct Node {
        base::Box3d box;
        double least, foot;       ///< spacing; the same less slope times reach
        std::uint32_t begin, end; ///< in m_places
        std::uint32_t second = 0; ///< child; the first one stands right behind; 0: a leaf
    };
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);
    double foot(const SpacedPlace& place) const { return place.spacing - m_slope * place.reach; }
    double allowed(double spacing, double foot, double distanceSq) const;
    void search(std::uint32_t node, const base::Vec3d& p, double& most) const;

    std::vector<SpacedPlace> m_places;
    std::vector<Node> m_nodes;
    double m_slope;
};

} // namespace mesh
