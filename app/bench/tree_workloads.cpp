// Building the tree and editing it at a brush.
#include "app/bench/naive/naive_tree.h"
#include "app/bench/workload.h"

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

constexpr std::size_t brushes = 32;

/// Tells what the tree takes, surfels and all.
Run building(Scene& scene) {
    const auto remark = [&tree = scene.surface().tree()] {
        char text[64];
        std::snprintf(text, sizeof text, "%.1f B a surfel",
                      static_cast<double>(tree.bytes()) / static_cast<double>(std::max<std::size_t>(1, tree.size())));
        return std::string(text);
    };
    const auto build = [&list = scene.unsorted()] {
        keep(tree::SurfelTree::build(list));
        return list.size();
    };
    return {build, remark};
}

Run naiveBuilding(Scene& scene) {
    return [&list = scene.unsorted()] { return naiveBuild(list.items); };
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

Run naiveEditing(Scene& scene) {
    return [edits = std::make_shared<NaiveEdits>(scene.unsorted().items, brushEdits(scene))] {
        edits->next();
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
        {"build", "surfel", "a tree from surfels in no particular order",
         "sorted along a Morton curve, nanoflann, static index", building, naiveBuilding},
        {"edit", "edit", "1000 surfels removed and 1000 inserted at a brush",
         "nanoflann, dynamic index changed in place", editing, naiveEditing, true},
        {"evaluate-edited", "position", "evaluation in a batch after 1000 edits under brushes",
         "ours: the same before the edits", evaluatingEdited, evaluatingUnedited},
    };
}

} // namespace bench
