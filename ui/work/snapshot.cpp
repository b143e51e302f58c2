#include "ui/work/snapshot.h"

#include "core/process/curve_tube.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/render/splats/splat_scale.h"
#include "core/selection/hidden.h"

namespace ui {

static void tellScene(const session::Scene& scene, session::ShownScene& shown, Snapshot& out) {
    const session::SceneModel& active = scene.models[scene.active];
    for (const session::SceneModel& each : scene.models)
        out.scene.push_back({each.name, each.surface.tree().size(), each.visible, each.locked});
    out.active = scene.active;
    out.model = active.id;
    out.stand = {active.pose.rotation, active.pose(active.origin())};
    if (active.surface.definition().connectivity) { // discs of a complex are cut by its cells, which others lack
        out.whole = out.surface.tree();
        return;
    }
    out.beside = shown.beside(scene);
    out.whole = shown.whole(active.visible ? out.surface.tree() : tree::SurfelTree());
}

Snapshot snapshotOf(const session::Document& document, session::ShownScene& shown) {
    Snapshot out;
    out.surface = process::shownAs(selection::shownOf(document.surface()));
    out.surfels = document.surface().tree().size();
    tellScene(document.scene(), shown, out);
    out.path = document.path();
    out.origin = document.provenance().origin;
    out.up = document.up();
    out.layers = document.layers();
    out.modified = document.modified();
    out.canUndo = document.canUndo();
    out.canRedo = document.canRedo();
    if (out.canUndo)
        out.undoLabel = document.undoLabel();
    if (out.canRedo)
        out.redoLabel = document.redoLabel();
    out.past = document.pastLabels();
    out.future = document.futureLabels();
    out.modelBytes = document.surface().tree().bytes();
    out.historyBytes = document.historyBytes();
    out.spacing = process::typicalSpacing(document.surface().tree());
    out.splatScale = render::splatScaleOf(out.surface.tree());
    return out;
}

bool isEntire(const Snapshot& snapshot) {
    return snapshot.beside.empty() && snapshot.surfels == snapshot.surface.tree().size();
}

} // namespace ui
