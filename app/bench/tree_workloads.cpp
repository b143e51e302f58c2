// Building the tree and editing it at a brush (BUDGETS P4, P7).
#include "app/bench/brush_edit.h"
#include "app/bench/naive_points.h"
#include "app/bench/workload.h"

namespace bench {

namespace {

constexpr std::size_t brushes = 32;

Run building(Scene& scene) {
    return [&list = scene.unsorted()] {
        keep(tree::SurfelTree::build(list));
        return list.size();
    };
}

Run naiveBuilding(Scene& scene) {
    return [points = std::make_shared<NaivePoints>(scene.unsorted().items)] {
        const NaiveStaticIndex index(3, *points, {naiveLeaf});
        keep(index);
        return points->at.size();
    };
}

std::vector<BrushEdit> brushEdits(Scene& scene) {
    std::vector<BrushEdit> out;
    for (const surfel::Surfel& place : scene.places(brushes))
        out.push_back(brushEdit(scene.surface().tree(), place, out.size()));
    return out;
}

/// Every edit is one of the untouched version, which is the case of a stroke's first dab.
Run editing(Scene& scene) {
    return [&tree = scene.surface().tree(), edits = brushEdits(scene), k = std::size_t(0)]() mutable {
        keep(tree.apply(edits[k++ % brushes].edit));
        return std::size_t(1);
    };
}

/// The dynamic adaptor, which changes in place: what an edit inserts, the next one at the same brush removes.
Run naiveEditing(Scene& scene) {
    struct State {
        NaivePoints points;
        NaiveDynamicIndex index;
        std::vector<BrushEdit> edits;
        std::vector<std::vector<std::uint32_t>> going; ///< per brush
        State(Scene& from)
            : points(from.unsorted().items), index(3, points, {naiveLeaf}, 64 * points.at.size()),
              edits(brushEdits(from)) {
            const NaiveStaticIndex search(3, points, {naiveLeaf});
            for (const BrushEdit& edit : edits) {
                going.emplace_back();
                for (const base::Vec3f& p : edit.removed) {
                    float distanceSq = 0;
                    search.knnSearch(&p.x, 1, &going.back().emplace_back(), &distanceSq);
                }
            }
        }
    };
    return [state = std::make_shared<State>(scene), k = std::size_t(0)]() mutable {
        std::vector<std::uint32_t>& going = state->going[k % brushes];
        for (const std::uint32_t i : going)
            state->index.removePoint(i);
        const auto first = static_cast<std::uint32_t>(state->points.at.size());
        going.clear();
        for (const surfel::Surfel& s : state->edits[k % brushes].edit.inserted.items) {
            going.push_back(static_cast<std::uint32_t>(state->points.at.size()));
            state->points.at.push_back(s.position);
        }
        state->index.addPoints(first, static_cast<std::uint32_t>(state->points.at.size() - 1));
        ++k;
        return std::size_t(1);
    };
}

/// After many edits one after the other, each at one of a few places.
surface::Surface edited(Scene& scene) {
    tree::SurfelTree version = scene.surface().tree();
    const std::vector<surfel::Surfel> places = scene.places(brushes);
    const std::size_t edits = std::min<std::size_t>(1000, version.size() / 10);
    for (std::size_t k = 0; k < edits; ++k)
        version = version.apply(brushEdit(version, places[k % brushes], k).edit);
    return {version, scene.surface().definition()};
}

/// Around the brushes' places, those of one after those of another.
Run evaluating(Scene& scene, surface::Surface surface) {
    const std::size_t perPlace = std::min<std::size_t>(512, scene.size() / brushes);
    struct State {
        surface::Surface surface;
        std::vector<base::Vec3f> at;
        std::vector<surface::Evaluationf> out;
    };
    auto state = std::make_shared<State>();
    state->surface = std::move(surface);
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& place : scene.places(brushes)) {
        scene.surface().tree().nearest(place.position, perPlace, near);
        std::ranges::sort(near, {}, [](const tree::Neighbour& n) { return std::pair(n.blockNumber, n.slot); });
        for (const tree::Neighbour& n : near)
            state->at.push_back(n.block->position(n.slot));
    }
    state->out.resize(state->at.size());
    return [state] {
        state->surface.evaluate(state->at, surface::Need::Value, state->out);
        keep(state->out);
        return state->at.size();
    };
}
Run evaluatingEdited(Scene& scene) {
    return evaluating(scene, edited(scene));
}
Run evaluatingUnedited(Scene& scene) {
    return evaluating(scene, scene.surface());
}

} // namespace

std::vector<Workload> treeWorkloads() {
    return {
        {"build", "surfel", "a tree from surfels in no order", "nanoflann, static index", building, naiveBuilding},
        {"edit", "edit", "1000 surfels removed and 1000 inserted at a brush", "nanoflann, dynamic index", editing,
         naiveEditing, true},
        {"evaluate-edited", "position", "evaluation in a batch where 1000 edits were done at brushes",
         "the same before the edits", evaluatingEdited, evaluatingUnedited},
    };
}

} // namespace bench
