// What pictures show of a document: its visible models, in the coordinates of the active one.
#pragma once

#include "core/session/document.h"

namespace app {

struct SceneView {
    std::vector<surface::Surface> models; ///< at least one; the active one first where it is visible
    tree::SurfelTree whole;               ///< all of them, for framing
};

/// Of curves, the tubes around them. A document whose models are all hidden shows the active one.
SceneView sceneView(const session::Document& document, const base::Progress& progress = {});

} // namespace app
