// How far apart a model's surfels are beside another surface: as dense come the caps that close it there
// (solid/README 2.4).
#pragma once

#include "core/solid/loops/loop.h"
#include "core/solid/side.h"

namespace solid {

class SpacingBeside {
  public:
    /// Of surfels whose support reaches the side's surface.
    SpacingBeside(const tree::SurfelTree& tree, const Side& side);

    /// As the places of a loop tell.
    explicit SpacingBeside(const Loop& loop);

    bool empty() const { return m_beside.empty(); }
    /// Of the five surfels nearest to a place the middle one's: a stray has no say. REQUIRES: not empty.
    double at(const base::Vec3d& x) const;
    template <class Fn>
    void forPlaces(const Fn& fn) const {
        m_beside.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                fn(base::cast<double>(block.position(slot)));
        });
    }

  private:
    tree::SurfelTree m_beside; ///< each one's support is the spacing there
};

} // namespace solid
