// The discs that one ray meets, cluster by cluster in any order: what comes out depends on the discs alone. For kernels
// that are compiled once per instruction set.
#if defined(POINTCLAY_DISC_SEARCH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_DISC_SEARCH_H
#undef POINTCLAY_DISC_SEARCH_H
#else
#define POINTCLAY_DISC_SEARCH_H
#endif

#include "core/surface/rays/disc_kernel.h"
#include "core/surface/rays/disc_lanes.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Of the support, along the ray: how far behind a nearest disc that faces along the ray another matters.
constexpr float window = 0.7f;

class DiscSearch {
  public:
    /// `wide`: as far behind a nearest disc as any of the model may ask for, not as its own support does.
    void start(const base::Rayf& ray, const DiscRange& range, bool wide = false) {
        m_ray = ray;
        m_least = range.tMin;
        m_most = range.tMax;
        m_widest = wide ? range.maxSupport : 0;
        m_hit = {};
        m_cluster = nullptr;
    }
    /// Clusters that begin behind it need not be opened.
    float most() const { return m_most; }
    float least() const { return m_least; }

    void open(const float* c) {
        const D d;
        for (int first = 0; first < lanes; first += static_cast<int>(hn::Lanes(d)))
            meet(c, Discs::load(d, c, first));
    }
    /// Some discs of the cluster c.
    HWY_INLINE void meet(const float* c, const Discs& discs) {
        const D d;
        const Crossings found = cross(d, discs, m_ray);
        if (!hn::AllFalse(d, hn::Or(found.crossed, found.brushed)))
            note(c, discs, found);
    }

    /// Whether a search that was not wide has found all that one would: what was the nearest disc for a while may have
    /// ended it sooner than the nearest of all asks for. Before `finish`.
    bool complete() const {
        return !m_cluster || m_hit.cosine < 0 || m_hit.facing <= m_most || m_widest > 0 ||
               !(m_most < m_hit.nearest + window * m_hit.support);
    }

    DiscHit finish() {
        if (m_cluster)
            blend();
        // of no account where something is crossed before
        if (!(m_hit.brushFirst < m_hit.nearest))
            m_hit.brushFirst = DiscHit::none;
        if (m_hit.crossed())
            m_hit.brushLast = -DiscHit::none, m_hit.brushSupport = 0;
        if (!(m_hit.facing <= m_hit.nearest + window * m_hit.support))
            m_hit.facing = DiscHit::none;
        return m_hit;
    }

  private:
    HWY_INLINE void note(const float* c, const Discs& discs, const Crossings& found) {
        const D d;
        const V t = found.t(), none = hn::Set(d, DiscHit::none);
        const M ahead = hn::And(hn::Ge(t, hn::Set(d, m_least)), hn::Le(t, hn::Set(d, m_most)));
        const M crossed = hn::And(found.crossed, ahead), brushed = hn::And(found.brushed, ahead);
        if (HWY_UNLIKELY(!hn::AllFalse(d, brushed)))
            noteBrushed(d, brushed, t, discs.h);
        if (hn::AllFalse(d, crossed))
            return;
        const V any = hn::IfThenElse(crossed, t, none), least = hn::MinOfLanes(d, any);
        const float nearest = hn::GetLane(least);
        const M along = hn::And(crossed, hn::Ge(found.slope, hn::Zero(d)));
        float facing = nearest;
        if (HWY_UNLIKELY(!hn::AllFalse(d, along)))
            facing = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(along, none, any)));
        m_hit.facing = std::min(m_hit.facing, facing);
        if (comesBefore(nearest, c)) {
            const auto i = static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Eq(any, least)));
            noteNearest(nearest, lane(d, found.slope, i), lane(d, discs.h, i), c);
        }
    }

    /// Of crossings at one t, that of the cluster with the smaller bytes counts.
    bool comesBefore(float t, const float* c) const {
        if (t != m_hit.nearest)
            return t < m_hit.nearest;
        return m_cluster && c != m_cluster &&
               std::memcmp(c, m_cluster, sizeof(float) * (surfel::Support + 1) * lanes) < 0;
    }

    void noteBrushed(D d, M brushed, V t, V support) {
        const V none = hn::Set(d, DiscHit::none);
        const float from = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(brushed, t, none)));
        const float to = hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElse(brushed, t, hn::Neg(none))));
        const float most = hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElseZero(brushed, support)));
        m_hit.brushFirst = std::min(m_hit.brushFirst, from);
        m_hit.brushLast = std::max(m_hit.brushLast, to);
        m_hit.brushSupport = std::max(m_hit.brushSupport, most);
    }

    void noteNearest(float t, float slope, float support, const float* cluster) {
        m_hit.nearest = t;
        m_hit.cosine = slope;
        m_hit.support = support;
        m_cluster = cluster;
        m_most = std::min(m_most, t + (slope < 0 ? 0.0f : window * std::max(support, m_widest)));
    }

    static float lane(D d, V v, std::size_t i) {
        HWY_ALIGN float values[lanes];
        hn::Store(v, d, values);
        return values[i];
    }

    /// Crossings of the cluster's discs that face like the nearest, most weight to the discs crossed near their centre:
    /// closer to the surface than the nearest disc by an order.
    void blend() {
        const D d;
        const int width = static_cast<int>(hn::Lanes(d));
        const V most = hn::Set(d, 0.5f * m_hit.support);
        HWY_ALIGN float weights[lanes], offsets[lanes];
        for (int first = 0; first < lanes; first += width) {
            const Discs discs = Discs::load(d, m_cluster, first);
            const Crossings found = cross(d, discs, m_ray);
            const V t = found.t(), weight = weightOf(d, discs, found, t),
                    offset = hn::Sub(t, hn::Set(d, m_hit.nearest));
            const M alike = hn::Gt(hn::Mul(found.slope, hn::Set(d, m_hit.cosine)), hn::Zero(d));
            const M used = hn::And(hn::And(found.crossed, alike), hn::Lt(hn::Abs(offset), most));
            hn::Store(hn::IfThenElseZero(used, weight), d, weights + first);
            hn::Store(hn::IfThenElseZero(used, hn::Mul(weight, offset)), d, offsets + first);
        }
        const float total = sumOf(weights);
        m_hit.guess = total > 0 ? m_hit.nearest + sumOf(offsets) / total : m_hit.nearest;
    }

    base::Rayf m_ray;
    float m_least = 0, m_most = 0, m_widest = 0;
    const float* m_cluster = nullptr; ///< of the nearest disc
    DiscHit m_hit;
};

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
