#include "core/mesh/faces/face_draws.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/mesh/faces/inner_places.h"

#include <algorithm>
#include <numeric>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

constexpr std::uint64_t seed = 0x706f696e74ULL;
constexpr std::size_t drawsForShare = 20'000;

Vec3d placeOf(const FacePoint& point, const FaceTopology& topology, std::span<const Vec3f> positions) {
    const Triangle& t = topology.triangles[point.triangle];
    const Vec3d p = base::cast<double>(positions[t[0]]);
    return p + (base::cast<double>(positions[t[1]]) - p) * static_cast<double>(point.b) +
           (base::cast<double>(positions[t[2]]) - p) * static_cast<double>(point.c);
}

FacePoint FacePart::within(float ofSecond, float ofThird) const {
    const float a = 1 - ofSecond - ofThird;
    const float u = std::clamp(a * b[0] + ofSecond * b[1] + ofThird * b[2], 0.0f, 1.0f);
    const float v = std::clamp(a * c[0] + ofSecond * c[1] + ofThird * c[2], 0.0f, 1.0f - u);
    return {triangle, u, v};
}

FaceDraws::FaceDraws(const FaceTopology& topology) : m_sums(topology.areas) {
    std::inclusive_scan(m_sums.begin(), m_sums.end(), m_sums.begin());
}

FaceDraws::FaceDraws(std::span<const FacePart> parts) : m_parts(parts), m_sums(parts.size()) {
    std::transform_inclusive_scan(parts.begin(), parts.end(), m_sums.begin(), std::plus<>{},
                                  [](const FacePart& part) { return part.weight; });
}

FaceDraws::Draw FaceDraws::at(std::size_t i, std::size_t n) const {
    base::Random random(base::mix(seed ^ i));
    const double share = m_sums.back() / static_cast<double>(n);
    const double at = (static_cast<double>(i) + random.uniform()) * share;
    std::size_t t = static_cast<std::size_t>(std::upper_bound(m_sums.begin(), m_sums.end(), at) - m_sums.begin());
    while (t >= m_sums.size() || (t > 0 && m_sums[t] == m_sums[t - 1])) // rounding, triangles without area
        --t;
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1)
        u = 1 - u, v = 1 - v;
    const auto part = static_cast<std::uint32_t>(t);
    const auto b = static_cast<float>(u), c = static_cast<float>(v);
    return {m_parts.empty() ? FacePoint{part, b, c} : m_parts[part].within(b, c), part};
}

double FaceDraws::outerShare(const FaceTopology& topology, std::span<const Vec3f> positions,
                             const InnerPlaces* inside) const {
    if (!inside || inside->outerShare() == 1)
        return 1;
    std::vector<std::uint8_t> outer(drawsForShare);
    base::parallelFor(drawsForShare, 256, [&](std::size_t i) {
        const FacePoint point = at(i, drawsForShare).point;
        outer[i] = inside->has(placeOf(point, topology, positions), point.triangle) ? 0 : 1;
    });
    return static_cast<double>(std::max(std::size_t{1}, std::accumulate(outer.begin(), outer.end(), std::size_t{0}))) /
           static_cast<double>(drawsForShare);
}

} // namespace mesh
