#include "app/bench/naive/naive_cloud.h"

#include "core/base/box.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bench {

using base::Vec3f;

/// Two zero bits between each of the lowest 21.
static std::uint64_t spread(std::uint64_t v) {
    v &= 0x1fffff;
    v = (v | v << 32) & 0x1f00000000ffff;
    v = (v | v << 16) & 0x1f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    return (v | v << 2) & 0x1249249249249249;
}

std::vector<std::uint32_t> mortonOrder(std::span<const surfel::Surfel> surfels) {
    base::Box3f box;
    for (const surfel::Surfel& s : surfels)
        box.extend(s.position);
    const Vec3f size = box.size();
    const float scale = 2097151 / std::max({size.x, size.y, size.z, 1e-30f});
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(surfels.size());
    for (std::uint32_t i = 0; i < keys.size(); ++i) {
        const Vec3f q = (surfels[i].position - box.lo) * scale;
        const auto code = [](float v) { return spread(static_cast<std::uint64_t>(v)); };
        keys[i] = {code(q.x) | code(q.y) << 1 | code(q.z) << 2, i};
    }
    std::ranges::sort(keys);
    std::vector<std::uint32_t> out(keys.size());
    std::ranges::transform(keys, out.begin(), [](const auto& key) { return key.second; });
    return out;
}

NaiveCloud::NaiveCloud(std::span<const surfel::Surfel> surfels) {
    std::map<int, Bucket> byExponent;
    for (const std::uint32_t i : mortonOrder(surfels)) {
        Bucket& bucket = byExponent[std::ilogb(surfels[i].support)];
        bucket.reach = std::max(bucket.reach, surfels[i].support);
        bucket.surfels.push_back(surfels[i]);
        bucket.points.at.push_back(surfels[i].position);
    }
    for (auto& [exponent, bucket] : byExponent)
        m_buckets.push_back(std::move(bucket));
    for (Bucket& bucket : m_buckets)
        bucket.index =
            std::make_unique<NaiveStaticIndex>(3, bucket.points, nanoflann::KDTreeSingleIndexAdaptorParams(naiveLeaf));
}

std::size_t NaiveCloud::size() const {
    std::size_t out = 0;
    for (const Bucket& bucket : m_buckets)
        out += bucket.surfels.size();
    return out;
}

} // namespace bench
