// Which surfels are neighbours along the surface: closer than a few spacings of the sparser one of the two, and not on
// opposite sides of something thin (selection/README 2).
//
//     i ~ j    where |p_i - p_j| < 2.2 max(s_i, s_j)   and   n_i . n_j > -1/2 where normals have sides
//
// s is read off the supports, so that fine detail beside a coarse sampling is linked with it, and neither is linked
// with what lies its own few spacings away. The relation is symmetric. Threads may share one object; it holds the
// version.
#pragma once

#include "core/surface/surface.h"

#include <bit>

namespace selection {

class Links {
  public:
    explicit Links(const surface::Surface& surface)
        : m_tree(surface.tree()), m_oriented(m_tree.layout()->oriented), m_reach(reachOf(surface.definition())) {}

    /// How far a surfel of this support is linked with finer ones.
    float lengthAt(float support) const { return m_reach * support; }
    /// Part of the support that links reach over.
    float reach() const { return m_reach; }
    bool alike(const base::Vec3f& n, const base::Vec3f& m) const { return !m_oriented || dot(n, m) > -0.5f; }

    /// fn(number, block, slot, distance) for each surfel linked with this one.
    template <class Fn>
    void forEach(const surfel::SurfelBlock& block, int slot, const Fn& fn) const;

  private:
    static float reachOf(const surface::SurfaceDefinition& definition);

    tree::SurfelTree m_tree;
    bool m_oriented;
    float m_reach;
};

/// Distance of neighbouring surfels as a part of their supports, by how supports were made.
float spacingsPerSupport(const surface::SurfaceDefinition& definition);

template <class Fn>
void Links::forEach(const surfel::SurfelBlock& block, int slot, const Fn& fn) const {
    const base::Vec3f p = block.position(slot), n = block.normal(slot);
    const float own = block.support(slot);
    base::Box3f near{p, p};
    near = near.inflated(m_reach * own);
    m_tree.forBlocksInSupport(
        near,
        [&](std::uint32_t number, const surfel::SurfelBlock& other) {
            for (unsigned in = other.boundsLanes().supporting(near, m_reach) & other.clusterMask(); in; in &= in - 1) {
                const int first = std::countr_zero(in) * surfel::clusterSize;
                const int end = std::min(other.size(), first + surfel::clusterSize);
                for (int k = first; k < end; ++k) {
                    const float distanceSq = base::distanceSq(other.position(k), p);
                    const float length = m_reach * std::max(own, other.support(k));
                    if (distanceSq < length * length && (&other != &block || k != slot) && alike(n, other.normal(k)))
                        fn(number, other, k, std::sqrt(distanceSq));
                }
            }
        },
        m_reach);
}

} // namespace selection
