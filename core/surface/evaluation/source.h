// Where the room's own loops evaluate: a surface with the neighbourhood that consecutive positions share.
//
//     Source source(surface);
//     source.expect(box);                   a packet of positions, or nothing
//     source.evaluate(x, need, hint)        again and again
//
// Float positions that come close to the one before find their clusters among those collected around it; the answer has
// the same bits as that of a fresh Source. One thread at a time.
#pragma once

#include "core/surface/evaluation/candidates.h"
#include "core/surface/evaluation/summed_normals.h"

namespace surface {

/// How evaluations follow each other: anywhere, or most of them close to the one before, as iterations do.
enum class Steps { Apart, Close };

class Source {
  public:
    explicit Source(const Surface& surface, Steps steps = Steps::Close)
        : m_surface(&surface), m_plain(surface), m_steps(steps) {}

    const Surface& surface() const { return *m_surface; }
    /// Collects for positions in `box` at once.
    void expect(const base::Box3f& box) { m_candidates.collect(*m_surface, box); }
    /// `expect` in two steps: what one does for several sources in turn has its memory at hand in the next. `slack`:
    /// how far around the box, in units of the least support there; `distance`: at least so far, in model units.
    /// Nothing is expected, and false returned, where `positions` in the box would share too little to pay for
    /// collecting it; a slack that costs too much is left out.
    bool announce(const base::Box3f& box, float slack, std::size_t positions, float distance = 0);
    void fetch() { m_candidates.fetchClusters(); }
    bool expect(const base::Box3f& box, float slack, std::size_t positions) {
        if (!announce(box, slack, positions))
            return false;
        fetch();
        return true;
    }

    bool covers(const base::Vec3f& x) const { return m_candidates.covers(x); }
    /// The least support of what was collected last, in units of the surface; 0 for none.
    float localSupport() const { return m_surface->supportScale() * m_candidates.localSupport(); }

    Evaluationf evaluate(const base::Vec3f& x, Need need, const OrientationHint& hint = {}) {
        Evaluationf out;
        evaluate(x, need, hint, out);
        return out;
    }
    /// The same in place.
    void evaluate(const base::Vec3f& x, Need need, const OrientationHint& hint, Evaluationf& out);
    Evaluationd evaluate(const base::Vec3d& x, Need need, const OrientationHint& hint = {});

    void gather(const base::Vec3f& x, ClusterList& out) const;
    void gather(const base::Vec3d& x, ClusterList& out) const;
    /// All that may have weight as far as `around` from x.
    void gather(const base::Vec3f& x, float around, ClusterList& out) const;

  private:
    /// The general case.
    Evaluationf assemble(const base::Vec3f& x, Need need, const OrientationHint& hint, ClusterSpan clusters) const;
    /// In float for summed normals; the other frames go through the reference.
    Evaluationf hessian(const base::Vec3f& x, const OrientationHint& hint, ClusterSpan clusters) const;

    const Surface* m_surface;
    SummedNormals m_plain;
    Steps m_steps;
    Candidates m_candidates;
    float m_slack = 0; ///< how far around a position to collect; 0 before anything is known
};

} // namespace surface
