// The camera that shows a whole model as large as it can.
#pragma once

#include "core/tree/surfel_tree.h"
#include "ui/render/camera.h"

namespace app {

/// The same view direction and angle, moved so that the points fill the image up to a small margin. Exact for the
/// points, where Camera::framing fits their box.
render::Camera closeUp(const render::Camera& camera, const tree::SurfelTree& model);

} // namespace app
