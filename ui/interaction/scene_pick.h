// What lies under a pixel of a scene: rays meet the nearest of all models that are seen. Free function of its
// arguments, from any thread. Pixels are device pixels of the camera's image.
#pragma once

#include "ui/interaction/contact.h"
#include "ui/work/snapshot.h"

namespace ui {

/// One of both, or none.
struct Seen {
    std::optional<BrushContact> contact;        ///< with the active model
    const session::ShownModel* other = nullptr; ///< of the snapshot's: the model that is before it
};

Seen seenAt(const Snapshot& now, const render::Camera& camera, const QPointF& pixel);

} // namespace ui
