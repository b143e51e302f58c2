// One dab of every tool at an exact place: the tool and the new version; of some with brushes of all sizes, and with
// all that it touched resampled (BUDGETS P5, P6). In a stroke a dab resamples less, or nothing.
#include "app/bench/naive_points.h"
#include "app/bench/naive_surface.h"
#include "app/bench/plain_dab.h"
#include "app/bench/workload.h"
#include "core/sculpt/sampling.h"
#include "core/sculpt/stroke.h"
#include "core/session/document.h"

#include <Eigen/Dense>

namespace bench {

using base::Vec3f;

namespace {

constexpr std::size_t places = 16;
/// Naive displacement at the middle, in radii.
constexpr float depth = 0.05f;

/// Surfels under the brush, at most half of the model. The first is BUDGETS' brush, which has no word in its name.
struct BrushSize {
    std::size_t under;
    const char* word;
};
constexpr BrushSize brushSizes[] = {{50000, ""}, {10000, "-10k"}, {1000, "-1k"}};
/// Tools measured at all sizes, with and without resampling.
constexpr const char* thorough[] = {"draw", "smooth", "grab", "clay"};

struct Brush {
    surfel::Surfel at;
    float radius = 0;
    std::size_t under = 0; ///< surfels within the radius
};

std::vector<Brush> brushes(Scene& scene, std::size_t most) {
    const tree::SurfelTree& tree = scene.surface().tree();
    const std::size_t under = std::max<std::size_t>(1, std::min(most, tree.size() / 2));
    std::vector<Brush> out;
    std::vector<tree::Neighbour> found;
    for (const surfel::Surfel& at : scene.places(places)) {
        tree.nearest(at.position, under, found);
        out.push_back({at, std::max(std::sqrt(found.back().distanceSq), 0.01f * at.support), found.size()});
    }
    return out;
}

Run dabbing(Scene& scene, const sculpt::ToolRow& row, std::size_t under, bool resampled) {
    struct Each {
        sculpt::Dab dab;
        std::size_t under;
        sculpt::Sampling sampling;
    };
    std::vector<Each> dabs;
    for (const Brush& brush : brushes(scene, under)) {
        dabs.push_back({plainDab(row, brush.at, brush.radius), brush.under, {}});
        if (resampled)
            dabs.back().sampling.start(scene.surface(), brush.at.position);
    }
    return [&surface = scene.surface(), &row, dabs = std::move(dabs), k = std::size_t(0)]() mutable {
        const Each& each = dabs[k++ % dabs.size()];
        const tree::Edit edit = row.apply(surface, each.dab);
        surface::Surface next(surface.tree().apply(edit), surface.definition());
        if (sculpt::Sampling sampling = each.sampling; sampling.started()) {
            sampling.note(surface.tree(), edit, each.dab);
            if (sampling.pending())
                next = sampling.resample(next);
        }
        keep(next);
        return each.under;
    };
}

Eigen::Vector3d eigenOf(const Vec3f& v) {
    return Eigen::Vector3d(v.x, v.y, v.z);
}
Vec3f vectorOf(const Eigen::Vector3d& v) {
    return base::cast<float>(base::Vec3d{v.x(), v.y(), v.z()});
}

/// Plain arrays, a radius search for what is under the brush.
struct NaiveBrush {
    std::vector<surfel::Surfel> surfels;
    NaivePoints points;
    NaiveStaticIndex index;
    std::vector<Brush> places;
    NaiveFound found;
    std::vector<surfel::Surfel> out;
    std::size_t k = 0;

    NaiveBrush(Scene& from, std::size_t under)
        : surfels(from.surface().tree().surfels().items), points(surfels), index(3, points, {naiveLeaf}),
          places(brushes(from, under)) {}
    /// Finds what is under the next brush.
    const Brush& next() {
        const Brush& brush = places[k++ % places.size()];
        naiveSearch(index, brush.at.position, brush.radius, found);
        out.clear();
        return brush;
    }
    /// The smooth falloff.
    static double weight(double r) { return 1 + r * r * (2 * r - 3); }
};

/// Moved positions and turned normals of what a radius search finds, into arrays.
Run naiveDabbing(Scene& scene, std::size_t under) {
    return [state = std::make_shared<NaiveBrush>(scene, under)] {
        const Brush& brush = state->next();
        const Eigen::Vector3d centre = eigenOf(brush.at.position), up = eigenOf(brush.at.normal);
        const double radius = static_cast<double>(brush.radius), full = 0.5 * static_cast<double>(depth) * radius;
        for (const auto& [i, distanceSq] : state->found) {
            surfel::Surfel s = state->surfels[i];
            const Eigen::Vector3d q = eigenOf(s.position) - centre, n = eigenOf(s.normal);
            const double r = std::min(1.0, q.norm() / radius), w = NaiveBrush::weight(r);
            const Eigen::Vector3d slope = q * (6 * (r - 1) * full / (radius * radius));
            s.position = vectorOf(eigenOf(s.position) + up * (full * w));
            s.normal = vectorOf((n * (1 + slope.dot(up)) - slope * up.dot(n)).normalized());
            state->out.push_back(s);
        }
        keep(state->out);
        return brush.under;
    };
}

/// Each to the surface that its neighbours make, which a radius search finds for it.
Run naiveSmoothing(Scene& scene, std::size_t under) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    return [&naive = scene.naive(), state = std::make_shared<NaiveBrush>(scene, under)] {
        const Brush& brush = state->next();
        for (const auto& [i, distanceSq] : state->found) {
            surfel::Surfel s = state->surfels[i];
            const NaiveEvaluation e = naive.evaluate(base::cast<double>(s.position), surface::Need::Gradient);
            const double r = std::sqrt(static_cast<double>(distanceSq)) / static_cast<double>(brush.radius);
            const double share = 0.5 * NaiveBrush::weight(std::min(1.0, r)), slopeSq = lengthSq(e.gradient);
            if (e.valid && slopeSq > 0.01) {
                s.position += base::cast<float>(e.gradient * (-share * e.value / slopeSq));
                const base::Vec3d n = base::cast<double>(s.normal) * (1 - share) + normalized(e.gradient) * share;
                s.normal = base::cast<float>(normalized(n));
            }
            state->out.push_back(s);
        }
        keep(state->out);
        return brush.under;
    };
}

Workload dabWorkload(const sculpt::ToolRow& row, const BrushSize& size, bool resampled) {
    const bool smooths = row.id == std::string_view("smooth");
    Workload out;
    out.name = std::string("dab-") + row.id + size.word + (resampled ? "-resampled" : "");
    out.item = "surfel under the brush";
    out.tip = std::string("one dab of ") + row.label + " and the new version" + (resampled ? ", resampled, " : ", ") +
              std::to_string(size.under / 1000) + "k surfels under the brush";
    out.baseline = smooths ? "nanoflann radius search for each, Eigen double"
                           : "nanoflann radius search, a displacement in Eigen double";
    out.ours = [&row, size, resampled](Scene& scene) { return dabbing(scene, row, size.under, resampled); };
    out.naive = [size, smooths](Scene& scene) {
        return smooths ? naiveSmoothing(scene, size.under) : naiveDabbing(scene, size.under);
    };
    out.awaited = true;
    return out;
}

/// A stroke taken back and done again: what a document does when somebody asks for it, drawing apart.
Run undoing(Scene& scene) {
    sculpt::StrokeSettings settings;
    const Brush brush = brushes(scene, brushSizes[0].under).front();
    settings.radius = brush.radius;
    sculpt::Stroke stroke(scene.surface(), settings);
    const Vec3f up = base::normalized(brush.at.normal, {0, 0, 1}), along = base::perpendicular(up);
    for (const float by : {0.0f, 0.5f})
        stroke.add({{brush.at.position + (up * 2.0f + along * by) * brush.radius, -up}, 1, 0});
    stroke.finish();
    auto document = std::make_shared<session::Document>();
    document->reset(scene.surface(), {});
    document->commit(stroke.surface(), "Stroke");
    return [document] {
        document->undo();
        document->redo();
        keep(document->surface());
        return std::size_t(2);
    };
}

} // namespace

std::vector<Workload> dabWorkloads() {
    std::vector<Workload> out;
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        out.push_back(dabWorkload(row, brushSizes[0], false));
    for (const char* id : thorough)
        for (const BrushSize& size : brushSizes)
            for (const bool resampled : {false, true})
                if (resampled || &size != brushSizes)
                    out.push_back(dabWorkload(sculpt::tool(id), size, resampled));
    Workload undo{"undo", "undo or redo", "a stroke with 50k surfels under the brush, taken back or done again",
                  "",     undoing,        nullptr};
    undo.awaited = true;
    out.push_back(undo);
    return out;
}

} // namespace bench
