// Picking surfels out of clusters, for the kernels whose lanes are the surfels of one cluster and which visit those
// around them one by one. Included once per instruction set, from within a file that Highway compiles several times.
#if defined(POINTCLAY_KERNEL_PICK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_KERNEL_PICK_H
#undef POINTCLAY_KERNEL_PICK_H
#else
#define POINTCLAY_KERNEL_PICK_H
#endif

#include "core/base/box.h"
#include "core/surface/evaluation/clusters.h"
#include "core/surface/evaluation/kernels/kernel_lanes.h"
#include "core/surface/evaluation/pick_scratch.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {

/// The surfels picked, one row for each of their channels.
template <std::size_t rows>
struct Picked {
    const float* row[rows];
    std::size_t count = 0;
};

/// Calls pick(channels, append) for the lanes of all clusters in their order; append(keep, value...) takes over the
/// lanes of `keep`, a value for each row. `scratch` has room for `rows` rows.
template <std::size_t rows, class Pick>
HWY_INLINE Picked<rows> pickFrom(ClusterSpan clusters, float* scratch, const Pick& pick) {
    const D d;
    const std::size_t stride = pickStride(clusters.size());
    Picked<rows> out;
    for (std::size_t k = 0; k < rows; ++k)
        out.row[k] = scratch + k * stride;
    for (const float* cluster : clusters)
        for (std::size_t first = 0; first < lanes; first += hn::Lanes(d))
            pick(cluster + first, [&](M keep, auto... values) {
                static_assert(sizeof...(values) == rows);
                const Packing packing(keep);
                float* to = scratch + out.count;
                ((hn::StoreU(packing.pack(values), d, to), to += stride), ...);
                out.count += hn::CountTrue(d, keep);
            });
    return out;
}

/// A box against places in lanes.
class BoxLanes {
  public:
    HWY_INLINE explicit BoxLanes(const base::Box3f& box)
        : m_lo{constant(box.lo.x), constant(box.lo.y), constant(box.lo.z)}, m_hi{constant(box.hi.x), constant(box.hi.y),
                                                                                 constant(box.hi.z)} {}
    HWY_INLINE V distanceSq(const V3& p) const {
        const V3 away{beyond(m_lo.x, m_hi.x, p.x), beyond(m_lo.y, m_hi.y, p.y), beyond(m_lo.z, m_hi.z, p.z)};
        return dot(away, away);
    }

  private:
    static HWY_INLINE V beyond(V lo, V hi, V p) {
        return hn::Max(hn::Max(hn::Sub(lo, p), hn::Sub(p, hi)), hn::Zero(D()));
    }
    V3 m_lo, m_hi;
};

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
