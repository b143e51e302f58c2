// One dab of every tool at an exact place: the tool and the new version; of some with brushes of all sizes, and with
// all that it touched resampled. In a stroke a dab resamples less, or nothing.
#include "app/bench/naive/naive_brush.h"
#include "app/bench/plain_dab.h"
#include "app/bench/workload.h"
#include "core/sculpt/sampling.h"
#include "core/sculpt/stroke/stroke.h"
#include "core/session/document.h"

namespace bench {

using base::Vec3f;

namespace {

constexpr std::size_t places = 16;

/// Surfels under the brush, at most half of the model. The first has no word in its name.
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

/// The tools that have a naive way.
using NaiveDabbing = void (*)(const NaiveSurface&, const NaiveDab&, std::vector<surfel::Surfel>&);
NaiveDabbing naiveWayOf(std::string_view tool) {
    return tool == "draw" ? naiveDraw : tool == "smooth" ? naiveSmooth : nullptr;
}

Run naiveDabbing(Scene& scene, NaiveDabbing dab, std::size_t under) {
    if (!NaiveSurface::speaks(scene.surface()))
        return {};
    return [&naive = scene.naive(), dab, places = brushes(scene, under), out = std::vector<surfel::Surfel>(),
            k = std::size_t(0)]() mutable {
        const Brush& brush = places[k++ % places.size()];
        dab(naive, {brush.at.position, base::normalized(brush.at.normal, {0, 0, 1}), brush.radius}, out);
        keep(out);
        return brush.under;
    };
}

Workload dabWorkload(const sculpt::ToolRow& row, const BrushSize& size, bool resampled) {
    Workload out;
    out.name = std::string("dab-") + row.id + size.word + (resampled ? "-resampled" : "");
    out.item = "surfel under the brush";
    out.tip = std::string("one dab of ") + row.label + " and the new version" + (resampled ? ", resampled, " : ", ") +
              std::to_string(size.under / 1000) + "k surfels under the brush";
    out.ours = [&row, size, resampled](Scene& scene) { return dabbing(scene, row, size.under, resampled); };
    if (const NaiveDabbing naive = naiveWayOf(row.id); naive && !resampled) {
        out.baseline = "nanoflann radius search, Eigen double, into arrays; the index is not updated";
        out.naive = [naive, size](Scene& scene) { return naiveDabbing(scene, naive, size.under); };
    }
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
        if (!row.needs.layer)
            out.push_back(dabWorkload(row, brushSizes[0], false));
    for (const char* id : thorough)
        for (const BrushSize& size : brushSizes)
            for (const bool resampled : {false, true})
                if (resampled || &size != brushSizes)
                    out.push_back(dabWorkload(sculpt::tool(id), size, resampled));
    Workload undo{"undo", "undo or redo", "a stroke with 50k surfels under the brush, undone or redone",
                  "",     undoing,        nullptr};
    undo.awaited = true;
    out.push_back(undo);
    return out;
}

} // namespace bench
