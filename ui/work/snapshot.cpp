#include "ui/work/snapshot.h"

#include "core/process/curve_tube.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/render/splats/splat_scale.h"

namespace ui {

Snapshot snapshotOf(const session::Document& document) {
    Snapshot out;
    out.surface = process::shownAs(document.surface());
    out.surfels = document.surface().tree().size();
    out.path = document.provenance().path;
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

} // namespace ui
