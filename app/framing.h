// The camera that shows a whole model as large as it can.
#pragma once

#include "core/render/camera.h"
#include "core/tree/surfel_tree.h"

namespace app {

/// The same view direction and angle, moved so that the points and their discs (but for outliers: framed_box.h) fill
/// the image up to a small margin, with as much room to the left as to the right and above as below; with parallel rays
/// the height is chosen too. Exact for the points, where Camera::framing fits their box. Cost: some passes over them.
render::Camera closeUp(const render::Camera& camera, const tree::SurfelTree& model);
/// The same direction and height of parallel rays, what is seen of the model in the middle of the image and all of it
/// before the eye. REQUIRES: camera.parallel().
render::Camera centred(const render::Camera& camera, const tree::SurfelTree& model);
/// The camera carried around its target by a turn about an axis.
render::Camera turnedAbout(const render::Camera& camera, const base::Vec3d& axis, double angleRad);

} // namespace app
