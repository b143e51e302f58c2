#include "app/framing.h"

#include <limits>

namespace app {

using base::Vec3d;

/// Part of the half image that points reach.
constexpr double filled = 0.9;

/// How far points reach to either side of the planes through the eye that bound the view: with slope s and places
/// (a, z), the eye (e, d) sees all where |a - e| <= s (z - d) for each.
namespace {
struct Reach {
    double slope;
    double above = -std::numeric_limits<double>::infinity(), below = above;

    void extend(double a, double z) {
        above = std::max(above, a - slope * z);
        below = std::max(below, -a - slope * z);
    }
    double depth() const { return -(above + below) / (2 * slope); } ///< largest d
    double side() const { return (above - below) / 2; }             ///< e in the middle of what is allowed
};
} // namespace

render::Camera closeUp(const render::Camera& camera, const tree::SurfelTree& model) {
    const Vec3d forward = camera.forward(), right = camera.right(), up = camera.upright();
    Reach x{filled * 0.5 * camera.width / camera.focalPx()}, y{filled * 0.5 * camera.height / camera.focalPx()};
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot));
            x.extend(dot(p, right), dot(p, forward));
            y.extend(dot(p, up), dot(p, forward));
        }
    });
    const double middle = dot(base::cast<double>(model.bounds().centre()), forward);
    const double depth = std::min(x.depth(), y.depth());
    if (model.empty() || !(depth < middle)) // one point: any distance shows it
        return camera;
    render::Camera out = camera;
    out.eye = right * x.side() + up * y.side() + forward * depth;
    out.target = out.eye + forward * (middle - depth);
    return out;
}

} // namespace app
