// Evaluations, projections and curvature.
#include "app/bench/batches.h"
#include "app/bench/naive/naive_surface.h"
#include "app/bench/workload.h"
#include "core/surface/curvature.h"
#include "core/surface/evaluation/self.h"
#include "core/surface/projection/project.h"

#include <atomic>
#include <numeric>

namespace bench {

using base::Vec3f;
using surface::Need;
using surface::Projector;

namespace {

constexpr std::size_t batchSize = 16384, naiveBatch = 1024;
constexpr std::size_t batchOfBlocks = 128; ///< about as many surfels
/// Of projections, in units of h.
constexpr double tolerance = 1e-5;
constexpr const char* naiveWay = "nanoflann radius search, Eigen double";

/// How positions follow each other.
enum class Order { Coherent, Scattered, Self };

std::vector<Vec3f> positions(Scene& scene, Order order) {
    std::vector<Vec3f> out;
    if (order == Order::Self)
        for (const surfel::Surfel& s : scene.surface().tree().surfels().items)
            out.push_back(s.position);
    else {
        const auto all = order == Order::Coherent ? scene.coherent() : scene.scattered();
        out.assign(all.begin(), all.end());
    }
    return out;
}

Run evaluation(Scene& scene, Order order, Need need) {
    struct State {
        std::vector<Vec3f> all;
        Batches<Vec3f> batches;
        std::vector<surface::Evaluationf> out;
        State(std::vector<Vec3f> x, std::size_t size) : all(std::move(x)), batches(all, size), out(batches.size()) {}
    };
    auto state = std::make_shared<State>(positions(scene, order), batchSize);
    return [&surface = scene.surface(), state, need] {
        surface.evaluate(state->batches.next(), need, state->out);
        keep(state->out);
        return state->out.size();
    };
}

/// One call for each position.
Run singleEvaluation(Scene& scene) {
    auto batches = std::make_shared<Batches<Vec3f>>(scene.coherent(), naiveBatch);
    return [&surface = scene.surface(), batches] {
        for (const Vec3f& x : batches->next())
            keep(surface.evaluate(x, Need::Value));
        return batches->size();
    };
}

Run selfEvaluation(Scene& scene, Need need) {
    struct State {
        std::vector<std::uint32_t> all;
        Batches<std::uint32_t> batches;
        static std::vector<std::uint32_t> numbers(std::size_t count) {
            std::vector<std::uint32_t> out(count);
            std::iota(out.begin(), out.end(), 0u);
            return out;
        }
        explicit State(std::size_t blocks) : all(numbers(blocks)), batches(all, batchOfBlocks) {}
    };
    auto state = std::make_shared<State>(scene.surface().tree().blockCount());
    return [&surface = scene.surface(), state, need] {
        std::atomic<std::size_t> count = 0;
        evaluateSelf(surface, state->batches.next(), need,
                     [&](std::uint32_t, const surfel::SurfelBlock& block, std::span<const surface::SelfLanes> at) {
                         keep(at);
                         count += static_cast<std::size_t>(block.size());
                     });
        return count.load();
    };
}

/// Calls `one` for some positions in a row.
template <class Fn>
Run naively(Scene& scene, Order order, const Fn& one) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    struct State {
        std::vector<Vec3f> all;
        Batches<Vec3f> batches;
        explicit State(std::vector<Vec3f> x) : all(std::move(x)), batches(all, naiveBatch) {}
    };
    auto state = std::make_shared<State>(positions(scene, order));
    return [&naive = scene.naive(), state, one] {
        for (const Vec3f& x : state->batches.next())
            one(naive, base::cast<double>(x));
        return state->batches.size();
    };
}

Workload evaluating(const char* name, const char* tip, Order order, Need need) {
    return {name,
            "position",
            tip,
            naiveWay,
            [=](Scene& scene) { return evaluation(scene, order, need); },
            [=](Scene& scene) {
                return naively(scene, order, [need](const NaiveSurface& naive, const base::Vec3d& x) {
                    keep(naive.evaluate(x, need));
                });
            }};
}

Workload evaluatingSingly(const char* name, const char* tip) {
    Workload out = evaluating(name, tip, Order::Coherent, Need::Value);
    out.ours = singleEvaluation;
    return out;
}

Workload evaluatingSelf(const char* name, const char* tip, Need need) {
    Workload out = evaluating(name, tip, Order::Self, need);
    out.ours = [need](Scene& scene) { return selfEvaluation(scene, need); };
    return out;
}

Workload projecting(const char* name, Projector projector, Order order = Order::Coherent) {
    const bool coherent = order == Order::Coherent;
    return {name,
            "position",
            coherent ? "foot point to 1e-5 h, positions along a space-filling curve" : "the same in random order",
            naiveWay,
            [=](Scene& scene) -> Run {
                auto batches =
                    std::make_shared<Batches<Vec3f>>(coherent ? scene.coherent() : scene.scattered(), batchSize);
                surface::ProjectOptions options;
                options.projector = projector;
                options.tolerance = tolerance;
                options.need = Need::Value;
                return [&surface = scene.surface(), batches, options,
                        out = std::vector<surface::Projection<float>>(batches->size())]() mutable {
                    project(surface, batches->next(), options, out);
                    keep(out);
                    return out.size();
                };
            },
            [=](Scene& scene) {
                return naively(scene, order, [projector](const NaiveSurface& naive, const base::Vec3d& x) {
                    base::Vec3d foot;
                    keep(naive.project(x, projector, tolerance, foot));
                });
            }};
}

Run curvatures(Scene& scene) {
    auto batches = std::make_shared<Batches<Vec3f>>(scene.coherent(), batchSize / 4);
    return [&surface = scene.surface(), batches, out = std::vector<surface::Curvature>(batches->size())]() mutable {
        surface::curvature(surface, batches->next(), out);
        keep(out);
        return out.size();
    };
}

Run naiveCurvatures(Scene& scene) {
    const auto scale = static_cast<double>(scene.surface().definition().curvatureScale());
    return naively(scene, Order::Coherent, [scale](const NaiveSurface& naive, const base::Vec3d& x) {
        const NaiveEvaluation at = naive.evaluate(x, Need::Hessian, scale);
        surface::Evaluationd e;
        e.status = at.valid ? surface::Status::Ok : surface::Status::Outside;
        e.gradient = at.gradient;
        e.hessian = at.hessian;
        keep(surface::curvatureOf(e));
    });
}

} // namespace

std::vector<Workload> surfaceWorkloads() {
    return {
        evaluating("evaluate", "value, centroid and normal, positions along a space-filling curve", Order::Coherent,
                   Need::Value),
        evaluatingSingly("evaluate-single", "the same, one call per position"),
        evaluating("evaluate-scattered", "the same in random order", Order::Scattered, Need::Value),
        evaluatingSelf("evaluate-self", "the same at the surfels themselves, in the tree's order", Need::Value),
        evaluatingSelf("evaluate-self-gradient", "with the gradient, at the surfels themselves", Need::Gradient),
        evaluating("evaluate-gradient", "with the gradient, positions along a space-filling curve", Order::Coherent,
                   Need::Gradient),
        projecting("project-basic", Projector::Basic),
        projecting("project-almost", Projector::Almost),
        projecting("project-orthogonal", Projector::Orthogonal),
        projecting("project-scattered", Projector::Orthogonal, Order::Scattered),
        {"curvature", "position", "principal curvatures and directions on supports of 6 spacings", naiveWay, curvatures,
         naiveCurvatures},
    };
}

} // namespace bench
