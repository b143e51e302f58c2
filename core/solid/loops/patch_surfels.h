// What stands at the vertices of patches: surfels of the model's own kind (solid/README 1.4).
#pragma once

#include "core/solid/loops/plane_cap.h"
#include "core/surface/surface.h"

namespace solid {

/// How often the edges of a patch are halved after it was shaped, and how much coarser its loop is before (2 to that
/// power): what has an area of so many spacings squared that it would have more than 8,000 vertices.
int halvingsFor(double area, double spacing);

class PatchSurfels {
  public:
    explicit PatchSurfels(const surface::Surface& surface);

    /// One at each place where none of the same sheet stands within 0.65 spacings, and how many these are. Supports and
    /// colours go over evenly from the loop's, further attributes are those of its nearest place. `patch` is what has
    /// been shaped, `fine` the same after halveEdges, with normals at its vertices.
    std::size_t add(const Loop& loop, const Patch& patch, int halvings, const Patch& fine,
                    std::span<const base::Vec3d> normals);
    /// At the places of a cap, as the loop's nearest are; facing as its plane does, or against it where `turned`.
    void addCap(const PlaneCap& cap, bool turned);
    const surfel::SurfelList& surfels() const { return m_out; }

  private:
    const surface::Surface& m_surface;
    surfel::SurfelList m_out;
    bool m_oriented = false;
};

/// The model with more surfels, whose boundary limit is not yet looked for.
surface::Surface withSurfels(const surface::Surface& surface, const surfel::SurfelList& more);

} // namespace solid
