// One dab of every tool at an exact place, without resampling: the tool and the new version (BUDGETS P5, P6).
#include "bench/naive_points.h"
#include "bench/plain_dab.h"
#include "bench/workload.h"

#include <Eigen/Dense>

namespace bench {

using base::Vec3f;

namespace {

/// BUDGETS' brush: 50k surfels of a million; of small models a twentieth.
constexpr std::size_t mostUnderBrush = 50000;
constexpr std::size_t places = 16;
/// Naive displacement at the middle, in radii.
constexpr float depth = 0.05f;

struct Brush {
    surfel::Surfel at;
    float radius = 0;
    std::size_t under = 0; ///< surfels within the radius
};

std::vector<Brush> brushes(Scene& scene) {
    const tree::SurfelTree& tree = scene.surface().tree();
    const std::size_t under = std::max<std::size_t>(1, std::min(mostUnderBrush, tree.size() / 20));
    std::vector<Brush> out;
    std::vector<tree::Neighbour> found;
    for (const surfel::Surfel& at : scene.places(places)) {
        tree.nearest(at.position, under, found);
        out.push_back({at, std::max(std::sqrt(found.back().distanceSq), 0.01f * at.support), found.size()});
    }
    return out;
}

Run dabbing(Scene& scene, const sculpt::ToolRow& row) {
    struct Each {
        sculpt::Dab dab;
        std::size_t under;
    };
    std::vector<Each> dabs;
    for (const Brush& brush : brushes(scene))
        dabs.push_back({plainDab(row, brush.at, brush.radius), brush.under});
    return [&surface = scene.surface(), &row, dabs = std::move(dabs), k = std::size_t(0)]() mutable {
        const Each& each = dabs[k++ % dabs.size()];
        keep(surface.tree().apply(row.apply(surface, each.dab)));
        return each.under;
    };
}

/// Moved positions and turned normals of what a radius search finds, into arrays.
Run naiveDabbing(Scene& scene) {
    struct State {
        std::vector<surfel::Surfel> surfels;
        NaivePoints points;
        NaiveStaticIndex index;
        std::vector<Brush> places;
        NaiveFound found;
        std::vector<surfel::Surfel> out;
        explicit State(Scene& from)
            : surfels(from.surface().tree().surfels().items), points(surfels), index(3, points, {naiveLeaf}),
              places(brushes(from)) {}
    };
    return [state = std::make_shared<State>(scene), k = std::size_t(0)]() mutable {
        const Brush& brush = state->places[k++ % state->places.size()];
        naiveSearch(state->index, brush.at.position, brush.radius, state->found);
        const auto eigenOf = [](const Vec3f& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
        const auto vectorOf = [](const Eigen::Vector3d& v) {
            return base::cast<float>(base::Vec3d{v.x(), v.y(), v.z()});
        };
        const Eigen::Vector3d centre = eigenOf(brush.at.position), up = eigenOf(brush.at.normal);
        const double radius = static_cast<double>(brush.radius), full = 0.5 * static_cast<double>(depth) * radius;
        state->out.clear();
        for (const auto& [i, distanceSq] : state->found) {
            surfel::Surfel s = state->surfels[i];
            const Eigen::Vector3d q = eigenOf(s.position) - centre, n = eigenOf(s.normal);
            const double r = std::min(1.0, q.norm() / radius), w = 1 + r * r * (2 * r - 3);
            const Eigen::Vector3d slope = q * (6 * (r - 1) * full / (radius * radius));
            s.position = vectorOf(eigenOf(s.position) + up * (full * w));
            s.normal = vectorOf((n * (1 + slope.dot(up)) - slope * up.dot(n)).normalized());
            state->out.push_back(s);
        }
        keep(state->out);
        return brush.under;
    };
}

} // namespace

std::vector<Workload> dabWorkloads() {
    std::vector<Workload> out;
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        out.push_back({std::string("dab-") + row.id, "surfel under the brush",
                       std::string("one dab of ") + row.label + " and the new version, 50k surfels under the brush",
                       "nanoflann radius search, a displacement in Eigen double",
                       [&row](Scene& scene) { return dabbing(scene, row); }, naiveDabbing});
    return out;
}

} // namespace bench
