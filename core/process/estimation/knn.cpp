#include "core/process/estimation/knn.h"

#include "core/base/box.h"
#include "core/base/morton.h"
#include "core/base/radix_sort.h"

#include <nanoflann.hpp>

namespace process {

namespace {

struct Key {
    std::uint64_t code;
    std::uint32_t point;
};

/// The last cell along an axis.
constexpr double most = (1 << base::mortonBits) - 1;

std::vector<Key> mortonKeys(std::span<const surfel::Surfel> points) {
    base::Box3f box;
    for (const auto& p : points)
        box.extend(p.position);
    const base::Vec3f size = box.size();
    const double edge = std::max({size.x, size.y, size.z}), scale = edge > 0 ? most / edge : 0;
    std::vector<Key> keys(points.size());
    base::parallelFor(points.size(), 8192, [&](std::size_t i) {
        const base::Vec3d q = base::cast<double>(points[i].position - box.lo) * scale;
        const auto whole = [](double v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0, most)); };
        keys[i] = {base::mortonCode(whole(q.x), whole(q.y), whole(q.z)), static_cast<std::uint32_t>(i)};
    });
    return keys;
}

/// Within one cell of the curve: by position, so that coincident points stand together.
void sortCells(std::vector<Key>& keys, std::span<const surfel::Surfel> points) {
    const auto before = [&](const Key& a, const Key& b) {
        const base::Vec3f &p = points[a.point].position, &q = points[b.point].position;
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : a.point < b.point;
    };
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
        while (end < keys.size() && keys[end].code == keys[begin].code)
            ++end;
        if (end - begin > 1)
            std::sort(keys.begin() + static_cast<std::ptrdiff_t>(begin),
                      keys.begin() + static_cast<std::ptrdiff_t>(end), before);
    }
}

struct Positions {
    std::span<const base::Vec3f> p;
    std::size_t kdtree_get_point_count() const { return p.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t axis) const { return (&p[i].x)[axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Positions, float, std::uint32_t>,
                                                 Positions, 3, std::uint32_t>;

} // namespace

struct Cloud::Index {
    Positions positions;
    Tree tree;
    explicit Index(std::span<const base::Vec3f> p)
        : positions{p}, tree(3, positions, nanoflann::KDTreeSingleIndexAdaptorParams(12)) {}
};

Cloud::Cloud(std::span<const surfel::Surfel> points, const base::Progress& progress) {
    progress.step(0, "Sorting points");
    std::vector<Key> keys = mortonKeys(points);
    base::radixSort(keys, 3 * base::mortonBits, [](const Key& key) { return key.code; });
    sortCells(keys, points);
    m_places.resize(points.size());
    m_positions.reserve(points.size());
    for (const Key& key : keys) {
        const base::Vec3f& p = points[key.point].position;
        if (m_positions.empty() || m_positions.back() != p)
            m_positions.push_back(p);
        m_places[key.point] = static_cast<std::uint32_t>(m_positions.size() - 1);
    }
    progress.step(0.5, "Indexing points");
    m_index = std::make_unique<Index>(m_positions);
}

Cloud::~Cloud() = default;

void Cloud::nearest(std::size_t i, std::size_t k, Neighbours& out) const {
    k = std::min(k, size() - 1);
    out.index.resize(k + 1);
    out.distanceSq.resize(k + 1);
    nanoflann::KNNResultSet<float, std::uint32_t, std::size_t> result(k + 1);
    result.init(out.index.data(), out.distanceSq.data());
    const float query[3] = {m_positions[i].x, m_positions[i].y, m_positions[i].z};
    m_index->tree.findNeighbors(result, query, nanoflann::SearchParams());
    // The position itself, or what stands last where underflow made others as near as itself.
    const auto self = std::find(out.index.begin(), out.index.end() - 1, static_cast<std::uint32_t>(i));
    out.distanceSq.erase(out.distanceSq.begin() + (self - out.index.begin()));
    out.index.erase(self);
}

float Cloud::reach(const base::Vec3f& x, std::size_t k) const {
    std::vector<std::uint32_t> index(std::min(k, size()));
    std::vector<float> distanceSq(index.size());
    nanoflann::KNNResultSet<float, std::uint32_t, std::size_t> result(index.size());
    result.init(index.data(), distanceSq.data());
    const float query[3] = {x.x, x.y, x.z};
    m_index->tree.findNeighbors(result, query, nanoflann::SearchParams());
    return std::sqrt(distanceSq.back());
}

} // namespace process
