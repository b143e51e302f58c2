// Planes that cut a picture open: what lies behind any of them is not there. Every way to draw honours them per pixel:
// splats test the place where the pixel's ray meets their disc, cast rays begin behind the plane.
#pragma once

#include "core/base/plane.h"

#include <array>
#include <span>

namespace render {

/// A short list that compares by what is in it.
class ClipPlanes {
  public:
    static constexpr std::size_t most = 6;

    bool operator==(const ClipPlanes&) const = default;

    bool empty() const { return m_count == 0; }
    bool full() const { return m_count == most; }
    /// REQUIRES: not full.
    void add(const base::Plane& plane) { m_planes[m_count++] = plane; }
    std::span<const base::Plane> all() const { return {m_planes.data(), m_count}; }
    bool keeps(const base::Vec3d& p) const {
        for (const base::Plane& plane : all())
            if (plane.distance(p) < 0)
                return false;
        return true;
    }

  private:
    std::array<base::Plane, most> m_planes; ///< unused ones as made
    std::size_t m_count = 0;
};

} // namespace render
