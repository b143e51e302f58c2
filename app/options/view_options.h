// The options of `render` that choose the view: camera, projection, what is cut away, and how many pictures around the
// model. In the file's coordinates.
#pragma once

#include "app/options/option_set.h"
#include "core/render/camera.h"
#include "core/tree/surfel_tree.h"

#include <memory>
#include <string>
#include <vector>

namespace app {

struct ViewOptions {
    std::string size = "1280x720", view, eye, target, up, ortho;
    double fovDeg = 0; ///< 0: the camera's own
    std::vector<std::string> clips;
    int turntable = 0; ///< pictures; 0: one, and no number in its name
};

/// Adds --size, --view, --eye, --target, --up, --fov, --ortho, --clip, --turntable, checked. The result is filled in
/// when the command is parsed.
std::shared_ptr<ViewOptions> addViewOptions(OptionSet command);

/// "nx,ny,nz,d" as the half of space n.x >= d, in coordinates relative to `origin`. REQUIRES: planeFault is empty.
base::Plane planeOf(const std::string& text, const base::Vec3d& origin);
/// Empty, or what is wrong with the text.
std::string planeFault(const std::string& text);

/// The asked cameras in coordinates relative to the origin, one for each picture, of a model that stands with `up`
/// upwards where the options do not say otherwise; what is left out is chosen to show the whole model. Throws
/// UsageError, and base::Error where a view of that name was not saved.
std::vector<render::Camera> camerasOf(const ViewOptions& options, const tree::SurfelTree& model,
                                      const base::Vec3d& origin, base::UpAxis up);
/// Which way is up for the ground: as the options say, else as the model stands.
base::Vec3d upwards(const ViewOptions& options, base::UpAxis up);

/// `path` for the k-th of n pictures: as it is for one, "NAME-007.png" for more, with as many digits as the last needs,
/// three at least.
std::string numberedPath(const std::string& path, int k, int n);

} // namespace app
