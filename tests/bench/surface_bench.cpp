// Evaluations, projections and rays per second on a bumpy sphere of a million surfels, about 20 in support, each beside
// the naive way in the same run: nanoflann radius search and plain double loops with Eigen, the same formulas.
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <Eigen/Dense>
#include <nanoflann.hpp>

using base::Vec3d, base::Vec3f;
using surface::Need, surface::Projector, surface::Surface;

namespace {

constexpr std::size_t surfelCount = 1000000;
constexpr double pi = 3.14159265358979323846;

/// r(u) = 1 + a (sin kx + sin ky + sin kz) in the direction u.
double bump(const Vec3d& u) {
    return 1 + 0.01 * (std::sin(11 * u.x) + std::sin(11 * u.y) + std::sin(11 * u.z));
}

/// grad (|p| - r(p / |p|)).
Vec3d normalOf(const Vec3d& p) {
    const double rho = length(p);
    const Vec3d u = p / rho;
    const Vec3d slope{0.11 * std::cos(11 * u.x), 0.11 * std::cos(11 * u.y), 0.11 * std::cos(11 * u.z)};
    return base::normalized(u - (slope - u * dot(slope, u)) / rho);
}

struct Scene {
    Surface surface;
    std::vector<Vec3f> coherent, scattered;
    std::vector<base::Rayf> camera;
    double support;
};

surfel::SurfelList bumpySphere(double support) {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    list.layout = layout;
    base::Random random(1);
    for (std::size_t i = 0; i < surfelCount; ++i) {
        const double z = 1 - (2 * double(i) + 1) / double(surfelCount), r = std::sqrt(1 - z * z);
        const double angle = double(i) * pi * (3 - std::sqrt(5.0));
        const Vec3d u{r * std::cos(angle), r * std::sin(angle), z};
        const Vec3d p = u * bump(u) + Vec3d{random.normal(), random.normal(), random.normal()} * 2e-6;
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = base::cast<float>(normalOf(p));
        s.support = static_cast<float>(support);
        list.items.push_back(s);
    }
    return list;
}

Scene makeScene() {
    base::setThreadCount(1);
    Scene scene;
    scene.support = std::sqrt(4 * pi / double(surfelCount)) * std::sqrt(20 / pi);
    scene.surface = {tree::SurfelTree::build(bumpySphere(scene.support)), {}};
    base::Random random(2);
    const auto inOrder = scene.surface.tree().surfels();
    for (std::size_t i = 0; i < inOrder.size(); i += 4)
        scene.coherent.push_back(inOrder.items[i].position +
                                 base::cast<float>(random.unitVector() * (0.3 * scene.support)));
    scene.scattered = scene.coherent;
    for (std::size_t i = scene.scattered.size() - 1; i > 0; --i)
        std::swap(scene.scattered[i], scene.scattered[random.below(i + 1)]);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            scene.camera.push_back(
                {{0, 0, 4}, base::normalized(Vec3f{(float(x) - 127.5f) / 450, (float(y) - 127.5f) / 450, -1})});
    return scene;
}

const Scene& scene() {
    static const Scene made = makeScene();
    return made;
}

/// The naive way: nanoflann's radius search over the surfels in tree order and Eigen in double.
class Naive {
  public:
    Naive() : m_points(scene().surface.tree().surfels()), m_index(3, *this, {16}) {}

    std::size_t kdtree_get_point_count() const { return m_points.size(); }
    float kdtree_get_pt(std::size_t i, std::size_t k) const { return m_points.items[i].position[k]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
        return false;
    }

    struct Plane {
        Eigen::Vector3d centroid, normal;
        double value = 0;
        bool valid = false;
    };
    Plane evaluate(const Eigen::Vector3d& x) {
        const float query[3] = {float(x.x()), float(x.y()), float(x.z())};
        const double h = scene().support;
        m_found.clear();
        const nanoflann::SearchParams unsorted(0, 0, false);
        m_index.radiusSearch(query, float(h * h), m_found, unsorted);
        double w = 0, heights = 0;
        Eigen::Vector3d c = Eigen::Vector3d::Zero(), n = Eigen::Vector3d::Zero();
        for (const auto& [i, distanceSq] : m_found) {
            const auto& s = m_points.items[i];
            const Eigen::Vector3d p(s.position.x, s.position.y, s.position.z), ni(s.normal.x, s.normal.y, s.normal.z);
            const double t = std::max(0.0, 1 - (x - p).norm() / h), theta = t * t * t * t * (5 - 4 * t);
            w += theta, c += theta * p, n += theta * ni, heights += theta * ni.dot(x - p);
        }
        if (!(w > 0))
            return {};
        c /= w;
        n.normalize();
        return {c, n, 0.5 * n.dot(x - c) + 0.5 * heights / w, true};
    }

  private:
    surfel::SurfelList m_points;
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Naive>, Naive, 3, std::uint32_t> m_index;
    std::vector<std::pair<std::uint32_t, float>> m_found;
};

Naive& naive() {
    static Naive made;
    return made;
}

Eigen::Vector3d eigenOf(const Vec3f& v) {
    return {v.x, v.y, v.z};
}

constexpr std::size_t batchSize = 16384;

const std::vector<Vec3f>& queries(bool scattered) {
    return scattered ? scene().scattered : scene().coherent;
}

std::span<const Vec3f> batchOf(const std::vector<Vec3f>& all, std::size_t& at) {
    if (at + batchSize > all.size())
        at = 0;
    at += batchSize;
    return {all.data() + at - batchSize, batchSize};
}

void evaluateBatch(benchmark::State& state, bool scattered, Need need) {
    const auto& all = queries(scattered);
    std::vector<surface::Evaluationf> out(batchSize);
    std::size_t at = 0;
    for (auto _ : state)
        scene().surface.evaluate(batchOf(all, at), need, out);
    state.SetItemsProcessed(state.iterations() * std::int64_t(batchSize));
}

void evaluateSingle(benchmark::State& state, bool scattered, Need need) {
    const auto& all = queries(scattered);
    std::size_t at = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(scene().surface.evaluate(all[at], need));
        at = at + 1 < all.size() ? at + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
}

void evaluateReference(benchmark::State& state) {
    const auto& all = queries(false);
    std::size_t at = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(scene().surface.evaluateReference(base::cast<double>(all[at]), Need::Value));
        at = at + 1 < all.size() ? at + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
}

void evaluateSelf(benchmark::State& state) {
    std::vector<Vec3f> x;
    for (const auto& s : scene().surface.tree().surfels().items)
        x.push_back(s.position);
    std::vector<surface::Evaluationf> out(x.size());
    for (auto _ : state)
        scene().surface.evaluate(x, Need::Value, out);
    state.SetItemsProcessed(state.iterations() * std::int64_t(x.size()));
}

void evaluateNaive(benchmark::State& state, bool scattered) {
    const auto& all = queries(scattered);
    Naive& way = naive();
    std::size_t at = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(way.evaluate(eigenOf(all[at])).value);
        at = at + 1 < all.size() ? at + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
}

void projectBatch(benchmark::State& state, Projector projector, bool scattered) {
    const auto& all = queries(scattered);
    std::vector<surface::Projection<float>> out(batchSize);
    surface::ProjectOptions options;
    options.projector = projector;
    options.tolerance = 1e-5;
    options.need = Need::Value;
    std::size_t at = 0;
    for (auto _ : state)
        project(scene().surface, batchOf(all, at), options, out);
    state.SetItemsProcessed(state.iterations() * std::int64_t(batchSize));
}

/// Basic or almost orthogonal to 1e-5 h.
void projectNaive(benchmark::State& state, bool almost) {
    const auto& all = queries(false);
    Naive& way = naive();
    std::size_t at = 0;
    for (auto _ : state) {
        const Eigen::Vector3d x0 = eigenOf(all[at]);
        Eigen::Vector3d y = x0;
        for (int i = 0; i < 30; ++i) {
            const auto plane = way.evaluate(y);
            if (!plane.valid)
                break;
            const Eigen::Vector3d& b = almost ? x0 : y;
            const Eigen::Vector3d next = b - plane.normal * (plane.value + plane.normal.dot(b - y));
            const double step = (next - y).norm();
            y = next;
            if (step <= 1e-5 * scene().support)
                break;
        }
        benchmark::DoNotOptimize(y);
        at = at + 1 < all.size() ? at + 1 : 0;
    }
    state.SetItemsProcessed(state.iterations());
}

void cameraRays(benchmark::State& state, bool robust) {
    const auto& rays = scene().camera;
    std::vector<surface::RayHit<float>> out(rays.size());
    surface::IntersectOptions options;
    options.robust = robust;
    std::size_t hits = 0;
    for (auto _ : state) {
        intersect(scene().surface, rays, options, out);
        hits += std::size_t(std::count_if(out.begin(), out.end(), [](const auto& hit) { return hit.hit; }));
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(out.size()));
    state.counters["hits"] = double(hits) / double(state.iterations() * std::int64_t(out.size()));
}

/// Marching from the bounding sphere by 0.85 |f|, or h/2 without support, then bisection by planes.
void cameraRaysNaive(benchmark::State& state) {
    const auto& rays = scene().camera;
    Naive& way = naive();
    const double h = scene().support;
    std::size_t at = 0, hits = 0;
    for (auto _ : state) {
        const Eigen::Vector3d o = eigenOf(rays[at].origin), d = eigenOf(rays[at].direction);
        const double b = o.dot(d), inside = b * b - o.squaredNorm() + 1.04 * 1.04;
        if (inside > 0)
            for (double t = -b - std::sqrt(inside), end = -b + std::sqrt(inside); t < end;) {
                const auto plane = way.evaluate(o + t * d);
                if (!plane.valid) {
                    t += h / 2;
                    continue;
                }
                const double slope = plane.normal.dot(d);
                if (std::abs(plane.value) < 1e-5 * h) {
                    ++hits;
                    break;
                }
                t += slope < -0.05 && std::abs(plane.value) < 0.3 * h ? -plane.value / slope
                                                                      : std::max(0.85 * std::abs(plane.value), h / 14);
            }
        at = (at + 40503) % rays.size();
    }
    state.SetItemsProcessed(state.iterations());
    state.counters["hits"] = double(hits) / double(state.iterations());
}

} // namespace

BENCHMARK_CAPTURE(evaluateBatch, coherent, false, Need::Value);
BENCHMARK_CAPTURE(evaluateSingle, coherent, false, Need::Value);
BENCHMARK_CAPTURE(evaluateNaive, coherent, false);
BENCHMARK_CAPTURE(evaluateBatch, coherent gradient, false, Need::Gradient);
BENCHMARK_CAPTURE(evaluateSingle, coherent gradient, false, Need::Gradient);
BENCHMARK(evaluateReference);
BENCHMARK_CAPTURE(evaluateBatch, scattered, true, Need::Value);
BENCHMARK_CAPTURE(evaluateSingle, scattered, true, Need::Value);
BENCHMARK_CAPTURE(evaluateNaive, scattered, true);
BENCHMARK(evaluateSelf)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(projectBatch, basic, Projector::Basic, false);
BENCHMARK_CAPTURE(projectNaive, basic, false);
BENCHMARK_CAPTURE(projectBatch, almost, Projector::Almost, false);
BENCHMARK_CAPTURE(projectNaive, almost, true);
BENCHMARK_CAPTURE(projectBatch, orthogonal, Projector::Orthogonal, false);
BENCHMARK_CAPTURE(projectBatch, orthogonal scattered, Projector::Orthogonal, true);
BENCHMARK_CAPTURE(cameraRays, iterated, false);
BENCHMARK_CAPTURE(cameraRays, robust, true);
BENCHMARK(cameraRaysNaive);
