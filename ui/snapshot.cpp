#include "ui/snapshot.h"

#include "core/process/spacing_sample.h"
#include "ui/render/splat_scale.h"

namespace ui {

Snapshot snapshotOf(const session::Document& document) {
    Snapshot out;
    out.surface = document.surface();
    out.path = document.provenance().path;
    out.origin = document.provenance().origin;
    out.modified = document.modified();
    out.canUndo = document.canUndo();
    out.canRedo = document.canRedo();
    if (out.canUndo)
        out.undoLabel = document.undoLabel();
    if (out.canRedo)
        out.redoLabel = document.redoLabel();
    out.modelBytes = document.surface().tree().bytes();
    out.historyBytes = document.historyBytes();
    out.spacing = process::typicalSpacing(document.surface().tree());
    out.splatScale = render::splatScaleOf(document.surface().tree());
    return out;
}

} // namespace ui
