// Normals and orientation per second. The baseline is what one writes first: nanoflann over the points in
// the order they came, Eigen's solver in double, one thread.
#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/process/estimation/normals.h"
#include "core/process/estimation/prepare.h"
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/supports.h"
#include "core/process/samples/samples.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <Eigen/Eigenvalues>
#include <nanoflann.hpp>

namespace {

/// A knot in the order of a file that nobody sorted.
const surfel::SurfelList& cloud() {
    static const surfel::SurfelList list = [] {
        surfel::SurfelList out = process::sample("knot").make(300000, 1);
        base::Random random(1);
        for (std::size_t i = out.size(); i > 1; --i)
            std::swap(out.items[i - 1], out.items[random.below(i)]);
        return out;
    }();
    return list;
}

void count(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * cloud().size()));
    base::setThreadCount(0);
}

void normals(benchmark::State& state) {
    base::setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        surfel::SurfelList list = cloud();
        process::estimateNormals(list);
        benchmark::DoNotOptimize(list.items.data());
    }
    count(state);
}

void orientation(benchmark::State& state) {
    base::setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        surfel::SurfelList list = cloud();
        process::orientNormals(list);
        benchmark::DoNotOptimize(list.items.data());
    }
    count(state);
}

void supports(benchmark::State& state) {
    base::setThreadCount(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        surfel::SurfelList list = cloud();
        process::assignSupports(list, {});
        benchmark::DoNotOptimize(list.items.data());
    }
    count(state);
}

struct Points {
    const std::vector<surfel::Surfel>& items;
    std::size_t kdtree_get_point_count() const { return items.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return static_cast<double>(items[i].position[axis]); }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }
};

void normalsNaive(benchmark::State& state) {
    for (auto _ : state) {
        surfel::SurfelList list = cloud();
        const Points points{list.items};
        using Metric = nanoflann::L2_Simple_Adaptor<double, Points>;
        const nanoflann::KDTreeSingleIndexAdaptor<Metric, Points, 3> tree(3, points, {10});
        for (surfel::Surfel& s : list.items) {
            std::uint32_t index[19];
            double distanceSq[19];
            const Eigen::Vector3d x(s.position.x, s.position.y, s.position.z);
            const std::size_t n = tree.knnSearch(x.data(), 19, index, distanceSq);
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
            for (std::size_t k = 0; k < n; ++k) {
                const base::Vec3f p = list.items[index[k]].position;
                const Eigen::Vector3d q = Eigen::Vector3d(p.x, p.y, p.z) - x;
                mean += q;
                moments += q * q.transpose();
            }
            moments -= mean * mean.transpose() / static_cast<double>(n);
            const Eigen::Vector3d normal =
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
            s.normal = base::cast<float>(base::Vec3d{normal.x(), normal.y(), normal.z()});
        }
        benchmark::DoNotOptimize(list.items.data());
    }
    count(state);
}

BENCHMARK(normals)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(normalsNaive)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(orientation)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(supports)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
