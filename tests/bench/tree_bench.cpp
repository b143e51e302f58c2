// The tree: a thousand edits at brushes in a row, difference, support and nearest queries; nanoflann beside them on the
// same points. Building and a single edit are workloads of the table (workloads_bench.cpp).
//
// Edit benchmarks report the median and the worst of all edits in milliseconds as counters.
#include "app/bench/naive/naive_cloud.h"
#include "core/base/random.h"
#include "core/tree/surfel_tree.h"

#include <benchmark/benchmark.h>
#include <chrono>

namespace {

constexpr std::size_t million = 1000000;

/// Samples of a bumpy closed surface of about unit radius with about 20 in support.
surfel::Surfel sample(base::Random& random, const base::Vec3d& direction) {
    surfel::Surfel s;
    const base::Vec3d& u = direction;
    s.position =
        base::cast<float>(u * (1 + 0.1 * std::sin(5 * u.x) * std::sin(4 * u.y + u.z) + 1e-5 * random.normal()));
    s.normal = base::cast<float>(u);
    s.support = std::sqrt(20.0f * 4.0f / static_cast<float>(million));
    return s;
}

const surfel::SurfelList& cloud() {
    static const surfel::SurfelList list = [] {
        base::Random random(1);
        surfel::SurfelList made;
        for (std::size_t i = 0; i < million; ++i)
            made.items.push_back(sample(random, random.unitVector()));
        return made;
    }();
    return list;
}

const tree::SurfelTree& builtTree() {
    static const tree::SurfelTree built = tree::SurfelTree::build(cloud());
    return built;
}

bench::NaivePoints plainPoints() {
    bench::NaivePoints points;
    for (const surfel::Surfel& s : cloud().items)
        points.at.push_back(s.position);
    return points;
}

/// Times of many edits.
class Times {
  public:
    template <class Fn>
    void measure(const Fn& fn) {
        const auto start = std::chrono::steady_clock::now();
        fn();
        m_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    void report(benchmark::State& state) {
        std::sort(m_ms.begin(), m_ms.end());
        state.counters["median_ms"] = m_ms[m_ms.size() / 2];
        state.counters["p99_ms"] = m_ms[m_ms.size() * 99 / 100];
        state.counters["worst_ms"] = m_ms.back();
    }

  private:
    std::vector<double> m_ms;
};

/// Removes the 1000 surfels nearest to a place on the surface and inserts 1000 others there.
tree::Edit brushEdit(const tree::SurfelTree& version, base::Random& random) {
    const base::Vec3d u = random.unitVector();
    const base::Vec3f centre = sample(random, u).position;
    std::vector<tree::Neighbour> near;
    version.nearest(centre, 1000, near);
    std::sort(near.begin(), near.end(),
              [](const tree::Neighbour& a, const tree::Neighbour& b) { return a.blockNumber < b.blockNumber; });
    tree::Edit edit;
    float radiusSq = 0;
    for (const tree::Neighbour& n : near) {
        if (edit.blocks.empty() || edit.blocks.back().block != n.blockNumber)
            edit.blocks.push_back({n.blockNumber, {}, {}});
        edit.blocks.back().removed.set(static_cast<std::size_t>(n.slot));
        radiusSq = std::max(radiusSq, n.distanceSq);
    }
    const base::Vec3d e1 = base::perpendicular(u), e2 = base::cross(u, e1);
    for (int i = 0; i < 1000; ++i) {
        const double r = std::sqrt(radiusSq * random.uniform()), angle = random.uniform(0, 6.283185307179586);
        const base::Vec3d p = u + e1 * (r * std::cos(angle)) + e2 * (r * std::sin(angle));
        edit.inserted.items.push_back(sample(random, base::normalized(p)));
    }
    return edit;
}

const tree::SurfelTree& editedTree() {
    static const tree::SurfelTree edited = [] {
        base::Random random(7);
        tree::SurfelTree version = builtTree();
        for (int i = 0; i < 1000; ++i)
            version = version.apply(brushEdit(version, random));
        return version;
    }();
    return edited;
}

void treeApplyAtBrush(benchmark::State& state) {
    base::Random random(7);
    Times times;
    tree::SurfelTree version = builtTree();
    for (auto _ : state) {
        const tree::Edit edit = brushEdit(version, random);
        tree::SurfelTree next;
        times.measure([&] { next = version.apply(edit); });
        version = next;
    }
    times.report(state);
    state.counters["bytes_per_surfel"] = static_cast<double>(version.bytes()) / static_cast<double>(version.size());
}

void treeApplyNanoflannDynamic(benchmark::State& state) {
    base::Random random(7);
    Times times;
    bench::NaivePoints points = plainPoints();
    points.at.reserve(2 * million + 1000);
    bench::NaiveDynamicIndex index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(bench::naiveLeaf),
                                   2 * million + 1000);
    for (auto _ : state) {
        const tree::Edit edit = brushEdit(builtTree(), random);
        const std::size_t first = points.at.size();
        times.measure([&] {
            for (std::size_t i = 0; i < 1000; ++i)
                index.removePoint(random.below(million));
            for (const surfel::Surfel& s : edit.inserted.items)
                points.at.push_back(s.position);
            index.addPoints(first, first + 999);
        });
    }
    times.report(state);
}

/// 50 000 surfels moved, none inserted or removed.
tree::SurfelTree movedVersion(std::size_t& moved) {
    const tree::SurfelTree& version = builtTree();
    tree::Edit edit;
    const float radius = 0.45f;
    moved = 0;
    version.forBlocksInBall({0, 0, 1}, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const surfel::MutableBlockPtr changed = block.clone();
        for (int slot = 0; slot < block.size(); ++slot)
            changed->setPosition(slot, block.position(slot) * 1.001f);
        changed->seal();
        moved += static_cast<std::size_t>(block.size());
        edit.blocks.push_back({number, changed, {}});
    });
    return version.apply(edit);
}

void treeDiffAfterDab(benchmark::State& state) {
    std::size_t moved = 0;
    const tree::SurfelTree next = movedVersion(moved);
    std::size_t blocks = 0;
    for (auto _ : state)
        blocks = tree::diff(builtTree(), next).added.size();
    state.counters["surfels"] = static_cast<double>(moved);
    state.counters["blocks"] = static_cast<double>(blocks);
    state.counters["undo_bytes_per_surfel"] =
        static_cast<double>(tree::unsharedBytes(builtTree(), next)) / static_cast<double>(moved);
}

/// Positions near the surface, in random order.
std::vector<base::Vec3f> queryPositions() {
    base::Random random(3);
    std::vector<base::Vec3f> out;
    for (int i = 0; i < 100000; ++i)
        out.push_back(sample(random, random.unitVector()).position);
    return out;
}

/// Nodes and blocks whose lanes a support query looks at.
void countVisits(const tree::Node& node, const base::Vec3f& x, std::size_t& nodes, std::size_t& blocks) {
    ++nodes;
    for (unsigned mask = node.supporting(x) & node.childMask(); mask != 0; mask &= mask - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(mask));
        if (node.level == 1)
            ++blocks;
        else
            countVisits(*node.nodes[i], x, nodes, blocks);
    }
}

void supportQueries(benchmark::State& state, const tree::SurfelTree& version) {
    const std::vector<base::Vec3f> positions = queryPositions();
    std::size_t clusters = 0, nodes = 0, blocks = 0;
    for (auto _ : state)
        for (const base::Vec3f& x : positions)
            version.forClustersInSupport(x, [&](const surfel::SurfelBlock&, int) { ++clusters; });
    for (const base::Vec3f& x : positions)
        countVisits(*version.root(), x, nodes, blocks);
    const auto count = static_cast<double>(positions.size());
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
    state.counters["clusters"] = static_cast<double>(clusters) / count / static_cast<double>(state.iterations());
    state.counters["nodes"] = static_cast<double>(nodes) / count;
    state.counters["blocks"] = static_cast<double>(blocks) / count;
}

void treeSupportFresh(benchmark::State& state) {
    supportQueries(state, builtTree());
}
void treeSupportEdited(benchmark::State& state) {
    supportQueries(state, editedTree());
}

void treeSupportNanoflann(benchmark::State& state) {
    const bench::NaivePoints points = plainPoints();
    const bench::NaiveStaticIndex index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(bench::naiveLeaf));
    const std::vector<base::Vec3f> positions = queryPositions();
    const float support = cloud().items[0].support;
    std::vector<std::pair<std::uint32_t, float>> found;
    for (auto _ : state)
        for (const base::Vec3f& x : positions)
            benchmark::DoNotOptimize(index.radiusSearch(&x.x, support * support, found, {32, 0, false}));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
}

void treeNearest(benchmark::State& state) {
    std::vector<tree::Neighbour> found;
    const std::vector<base::Vec3f> positions = queryPositions();
    for (auto _ : state)
        for (const base::Vec3f& x : positions)
            builtTree().nearest(x, 18, found);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
}

void treeNearestNanoflann(benchmark::State& state) {
    const bench::NaivePoints points = plainPoints();
    const bench::NaiveStaticIndex index(3, points, nanoflann::KDTreeSingleIndexAdaptorParams(bench::naiveLeaf));
    const std::vector<base::Vec3f> positions = queryPositions();
    std::uint32_t indices[18];
    float distances[18];
    for (auto _ : state)
        for (const base::Vec3f& x : positions)
            benchmark::DoNotOptimize(index.knnSearch(&x.x, 18, indices, distances));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(positions.size()));
}

BENCHMARK(treeApplyAtBrush)->Iterations(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(treeApplyNanoflannDynamic)->Iterations(1000)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(treeDiffAfterDab)->Unit(benchmark::kMicrosecond);
BENCHMARK(treeSupportFresh)->Unit(benchmark::kMillisecond);
BENCHMARK(treeSupportEdited)->Unit(benchmark::kMillisecond);
BENCHMARK(treeSupportNanoflann)->Unit(benchmark::kMillisecond);
BENCHMARK(treeNearest)->Unit(benchmark::kMillisecond);
BENCHMARK(treeNearestNanoflann)->Unit(benchmark::kMillisecond);

} // namespace
