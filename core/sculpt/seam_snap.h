// Strokes that keep to edges (sculpt/README 1.6): rays are moved sideways so that they meet the nearest seam or corner
// of the model, where one is near.
#pragma once

#include "core/sculpt/stroke/stroke_sample.h"
#include "core/surface/surface.h"

#include <vector>

namespace sculpt {

class SeamSnap {
  public:
    /// `reach` in model units. The seams are those of this version, traced here; corners are where they end.
    SeamSnap(const surface::Surface& surface, float reach);

    /// The same ray through the nearest corner within half the reach of where it meets the version, else through the
    /// nearest place of a seam within the reach; as it is where there is neither, or where it misses.
    base::Rayf snapped(const base::Rayf& ray) const;

  private:
    struct Segment {
        base::Vec3d from, to;
    };
    surface::Surface m_surface;
    float m_reach;
    std::vector<Segment> m_segments;
    std::vector<base::Vec3d> m_corners;
};

} // namespace sculpt
