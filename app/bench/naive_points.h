// Points as nanoflann reads them. Internal to the room: included by the few files that search naively.
#pragma once

#include "core/surfel/surfel.h"

#include <nanoflann.hpp>

namespace bench {

struct NaivePoints {
    std::vector<base::Vec3f> at;

    explicit NaivePoints(std::span<const surfel::Surfel> surfels) {
        at.reserve(surfels.size());
        for (const surfel::Surfel& s : surfels)
            at.push_back(s.position);
    }
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

} // namespace bench
