// The naive store: surfels in arrays sorted along a Morton curve, and k-d trees by nanoflann over them. Supports are
// bucketed by powers of two, a tree for each, so that a search reaches as far as the supports of its bucket and not as
// far as the largest of the model.
//
// Internal to the naive files, which are built for this machine alone (rooms.cmake).
#pragma once

#include "core/surfel/surfel.h"

#include <memory>
#include <nanoflann.hpp>

namespace bench {

struct NaivePoints {
    std::vector<base::Vec3f> at;

    std::size_t kdtree_get_point_count() const { return at.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return at[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using NaiveMetric = nanoflann::L2_Simple_Adaptor<float, NaivePoints>;
using NaiveStaticIndex = nanoflann::KDTreeSingleIndexAdaptor<NaiveMetric, NaivePoints, 3, std::uint32_t>;
using NaiveDynamicIndex = nanoflann::KDTreeSingleIndexDynamicAdaptor<NaiveMetric, NaivePoints, 3, std::uint32_t>;
/// The fastest of 10, 16 and 32 for these clouds.
constexpr std::size_t naiveLeaf = 16;
using NaiveFound = std::vector<std::pair<std::uint32_t, float>>;

/// What is within `radius` of x, in no order.
inline void naiveSearch(const NaiveStaticIndex& index, const base::Vec3f& x, float radius, NaiveFound& found) {
    found.clear();
    index.radiusSearch(&x.x, radius * radius, found, {0, 0, false});
}

/// Numbers of the points along a Morton curve.
std::vector<std::uint32_t> mortonOrder(std::span<const surfel::Surfel> surfels);

class NaiveCloud {
  public:
    /// Surfels whose supports lie between `reach` / 2 and `reach`.
    struct Bucket {
        float reach = 0; ///< largest support
        std::vector<surfel::Surfel> surfels;
        NaivePoints points;
        std::unique_ptr<NaiveStaticIndex> index;
    };

    explicit NaiveCloud(std::span<const surfel::Surfel> surfels);

    std::span<const Bucket> buckets() const { return m_buckets; }
    std::size_t size() const;
    /// fn(surfel) for those that x may be in the support of, supports multiplied by `scale`. One thread.
    template <class Fn>
    void forSupports(const base::Vec3f& x, float scale, const Fn& fn) const {
        for (const Bucket& bucket : m_buckets) {
            naiveSearch(*bucket.index, x, 1.00001f * scale * bucket.reach, m_found);
            for (const auto& [i, distanceSq] : m_found)
                fn(bucket.surfels[i]);
        }
    }
    /// fn(surfel, squared distance) for those closer than `radius`. One thread.
    template <class Fn>
    void forBall(const base::Vec3f& x, float radius, const Fn& fn) const {
        for (const Bucket& bucket : m_buckets) {
            naiveSearch(*bucket.index, x, radius, m_found);
            for (const auto& [i, distanceSq] : m_found)
                fn(bucket.surfels[i], distanceSq);
        }
    }

  private:
    std::vector<Bucket> m_buckets; ///< never moved: the trees refer to them
    mutable NaiveFound m_found;
};

} // namespace bench
