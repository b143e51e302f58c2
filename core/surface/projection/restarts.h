// Where to start a projection anew (surface/README 3.3): the nearest surfels, nearest first, that lie in other
// directions than those that led to a foot (more than 60 degrees apart as seen from the position) and outside the
// supports of those that led nowhere. Internal to the room; one thread, one position.
#pragma once

#include "core/tree/surfel_tree.h"

#include <vector>

namespace surface {

class Restarts {
  public:
    Restarts(const tree::SurfelTree& tree, const base::Vec3f& x);

    /// Distance to the nearest surfel; infinity where there is none.
    float nearest() const;
    /// The next start nearer than `limit`, or null. Valid until the next call.
    const tree::Neighbour* next(float limit);
    /// Tells what became of a start.
    void tried(const tree::Neighbour& start, bool led);

  private:
    bool allowed(const tree::Neighbour& candidate) const;
    void more();

    const tree::SurfelTree& m_tree;
    base::Vec3f m_x;
    std::vector<tree::Neighbour> m_found; ///< nearest first
    std::size_t m_at = 0;                 ///< those before it were looked at
    struct Tried {
        base::Vec3f position;
        float reach; ///< of its support; 0 where it led to a foot
    };
    std::vector<Tried> m_tried;
};

} // namespace surface
