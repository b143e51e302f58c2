#include "app/framing.h"

#include "core/render/framed_box.h"

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

/// With parallel rays, depth does not matter: the middle of the extents, and the height that holds them.
static render::Camera closeUpParallel(const render::Camera& camera, const tree::SurfelTree& model,
                                      const base::Box3f& shown) {
    constexpr double most = std::numeric_limits<double>::infinity();
    const Vec3d right = camera.right(), up = camera.upright();
    double left = most, lowest = most, rightmost = -most, highest = -most;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            if (!shown.contains(block.position(slot)))
                continue;
            const Vec3d p = base::cast<double>(block.position(slot));
            left = std::min(left, dot(p, right)), rightmost = std::max(rightmost, dot(p, right));
            lowest = std::min(lowest, dot(p, up)), highest = std::max(highest, dot(p, up));
        }
    });
    render::Camera out = centred(camera, model);
    const double height = std::max(highest - lowest, (rightmost - left) * camera.height / camera.width) / filled;
    if (!(height > 0)) // one point: any height shows it
        return out;
    out.orthoHeight = height;
    const Vec3d aside = right * (0.5 * (left + rightmost) - dot(out.target, right)) +
                        up * (0.5 * (lowest + highest) - dot(out.target, up));
    out.target += aside;
    out.eye += aside;
    return out.before(model.bounds());
}

render::Camera centred(const render::Camera& camera, const tree::SurfelTree& model) {
    if (model.empty())
        return camera;
    render::Camera out = camera;
    out.target = base::cast<double>(render::framedBox(model).centre());
    out.eye += out.target - camera.target;
    return out.before(model.bounds());
}

/// Rodrigues' formula.
static Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

render::Camera turnedAbout(const render::Camera& camera, const Vec3d& axis, double angleRad) {
    render::Camera out = camera;
    out.eye = camera.target + turned(camera.eye - camera.target, axis, angleRad);
    out.up = turned(camera.up, axis, angleRad);
    return out;
}

render::Camera closeUp(const render::Camera& camera, const tree::SurfelTree& model) {
    const base::Box3f shown = render::framedBox(model);
    if (camera.parallel())
        return closeUpParallel(camera, model, shown);
    const Vec3d forward = camera.forward(), right = camera.right(), up = camera.upright();
    Reach x{filled * 0.5 * camera.width / camera.focalPx()}, y{filled * 0.5 * camera.height / camera.focalPx()};
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            if (!shown.contains(block.position(slot)))
                continue;
            const Vec3d p = base::cast<double>(block.position(slot));
            x.extend(dot(p, right), dot(p, forward));
            y.extend(dot(p, up), dot(p, forward));
        }
    });
    const double middle = dot(base::cast<double>(shown.centre()), forward);
    const double depth = std::min(x.depth(), y.depth());
    if (model.empty() || !(depth < middle)) // one point: any distance shows it
        return camera;
    render::Camera out = camera;
    out.eye = right * x.side() + up * y.side() + forward * depth;
    out.target = out.eye + forward * (middle - depth);
    return out;
}

} // namespace app
