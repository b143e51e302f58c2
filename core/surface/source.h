// Where the room's own loops evaluate: a surface with the neighbourhood that consecutive positions share.
//
//     Source source(surface);
//     source.expect(box);                   a packet of positions, or nothing
//     source.evaluate(x, need, hint)        again and again
//
// Float positions that come close to the one before find their clusters among those collected around it; the answer has
// the same bits as that of a fresh Source. One thread at a time.
#pragma once

#include "core/surface/candidates.h"
#include "core/surface/surface.h"

namespace surface {

/// How evaluations follow each other: anywhere, or most of them close to the one before, as iterations do.
enum class Steps { Apart, Close };

class Source {
  public:
    explicit Source(const Surface& surface, Steps steps = Steps::Close) : m_surface(surface), m_steps(steps) {}

    const Surface& surface() const { return m_surface; }
    /// Collects for positions in `box` at once.
    void expect(const base::Box3f& box) { m_candidates.collect(m_surface, box); }

    bool covers(const base::Vec3f& x) const { return m_candidates.covers(x); }

    Evaluationf evaluate(const base::Vec3f& x, Need need, const Hint& hint = {});
    Evaluationd evaluate(const base::Vec3d& x, Need need, const Hint& hint = {});

    void gather(const base::Vec3f& x, ClusterList& out) const;
    void gather(const base::Vec3d& x, ClusterList& out) const;

  private:
    /// In float for summed normals; the other frames go through the reference.
    Evaluationf hessian(const base::Vec3f& x, ClusterSpan clusters, const Hint& hint) const;

    const Surface& m_surface;
    Steps m_steps;
    Candidates m_candidates;
    float m_slack = 0; ///< how far around a position to collect; 0 before anything is known
};

} // namespace surface
