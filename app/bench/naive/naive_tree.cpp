#include "app/bench/naive/naive_tree.h"

#include "app/bench/naive/naive_cloud.h"

namespace bench {

static NaivePoints pointsOf(std::span<const surfel::Surfel> surfels) {
    NaivePoints out;
    for (const surfel::Surfel& s : surfels)
        out.at.push_back(s.position);
    return out;
}

std::size_t naiveBuild(std::span<const surfel::Surfel> surfels) {
    return NaiveCloud(surfels).size();
}

struct NaiveEdits::State {
    NaivePoints points;
    NaiveDynamicIndex index;
    std::vector<std::vector<base::Vec3f>> coming; ///< per brush
    std::vector<std::vector<std::uint32_t>> going;
    std::size_t at = 0;

    State(std::span<const surfel::Surfel> surfels, std::span<const BrushEdit> edits)
        : points(pointsOf(surfels)),
          index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(naiveLeaf), 64 * points.at.size()) {
        const NaiveStaticIndex search(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(naiveLeaf));
        for (const BrushEdit& edit : edits) {
            coming.push_back(pointsOf(edit.edit.inserted.items).at);
            going.emplace_back();
            for (const base::Vec3f& p : edit.removed) {
                float distanceSq = 0;
                search.knnSearch(&p.x, 1, &going.back().emplace_back(), &distanceSq);
            }
        }
    }
};

NaiveEdits::NaiveEdits(std::span<const surfel::Surfel> surfels, std::span<const BrushEdit> edits)
    : m_state(std::make_unique<State>(surfels, edits)) {}
NaiveEdits::~NaiveEdits() = default;

void NaiveEdits::next() {
    State& s = *m_state;
    std::vector<std::uint32_t>& going = s.going[s.at];
    for (const std::uint32_t i : going)
        s.index.removePoint(i);
    const auto first = static_cast<std::uint32_t>(s.points.at.size());
    going.clear();
    for (const base::Vec3f& p : s.coming[s.at]) {
        going.push_back(static_cast<std::uint32_t>(s.points.at.size()));
        s.points.at.push_back(p);
    }
    s.index.addPoints(first, static_cast<std::uint32_t>(s.points.at.size() - 1));
    s.at = (s.at + 1) % s.going.size();
}

std::vector<float> NaiveEdits::nearest(const base::Vec3f& x, std::size_t k) const {
    std::vector<std::size_t> found(k);
    std::vector<float> out(k);
    nanoflann::KNNResultSet<float> result(k);
    result.init(found.data(), out.data());
    m_state->index.findNeighbors(result, &x.x, {});
    out.resize(result.size());
    return out;
}

} // namespace bench
