// Target spacings that vary over a model: by curvature, or as its supports do.
//
// The target at a place is that of the surfels nearest to it, weighted by the inverse of their squared distance. Fields
// are graded: along the surface the target changes by at most `grading` per length, a tenth of itself from one surfel
// to the next, so that supports that follow it change as smoothly.
//
// A value; const functions may run on any thread. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"
#include "core/tree/nearest_together.h"

namespace process {

/// Largest change of a target per length.
constexpr float grading = 0.1f;

/// sqrt(tolerance / curvature) between two limits: a flat facet as wide as the spacing stays within about an eighth of
/// the tolerance of the surface.
struct CurvatureSpacing {
    float tolerance = 0; ///< model units
    float finest = 0, coarsest = 0;
};

class SpacingField {
  public:
    /// As the supports of a version are: that times `scale`, as graded as they are.
    SpacingField(tree::SurfelTree tree, float scale);
    /// One target for each surfel of the list, then graded.
    SpacingField(const surfel::SurfelList& surfels, std::vector<float> targets);
    /// By the larger of the principal curvatures at the surface's own surfels; the coarsest where it has none. Throws
    /// base::Cancelled.
    static SpacingField byCurvature(const surface::Surface& surface, const CurvatureSpacing& by,
                                    const base::Progress& progress = {});

    float at(const base::Vec3f& x) const;
    /// The same for many places, best those that lie together: for a fraction of the cost; one thread.
    class Search {
      public:
        explicit Search(const SpacingField& field);
        /// REQUIRES: as many answers.
        void at(std::span<const base::Vec3f> x, std::span<float> out);

      private:
        const SpacingField& m_field;
        tree::NearestTogether m_around;
    };
    float finest() const { return m_finest; } ///< 0 where nobody counted
    float coarsest() const { return m_coarsest; }

  private:
    float meanOf(std::span<const tree::Neighbour> near) const;

    tree::SurfelTree m_tree; ///< targets are its supports times the scale
    float m_scale = 1;
    float m_finest = 0, m_coarsest = 0;
};

} // namespace process
