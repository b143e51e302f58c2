#include "app/framing.h"

#include "core/render/framed_box.h"
#include "core/render/splats/splat_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

using base::Vec3d;

/// Part of the half image that points reach, with the discs that are drawn about them.
constexpr double filled = 0.9;
/// A disc counts as no larger than this part of the model's diagonal: what stands alone has a wide support.
constexpr float widestDisc = 0.02f;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is framed, surfel by surfel: fn(position, radius of its disc).
template <class Fn>
void forShown(const tree::SurfelTree& model, const Fn& fn) {
    const base::Box3f shown = render::framedBox(model);
    const float widest = widestDisc * shown.diagonal();
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (shown.contains(block.position(slot)))
                fn(base::cast<double>(block.position(slot)),
                   static_cast<double>(std::min(widest, render::splatRadiusOfSupport * block.support(slot))));
    });
}

/// How far balls reach to either side of the planes through the eye that bound the view: with slope s and places
/// (a, z), the eye (e, d) sees all where |a - e| + r sqrt(1 + s^2) <= s (z - d) for each.
struct Reach {
    double slope;
    double above = -infinity, below = -infinity, secant = std::sqrt(1 + slope * slope);

    void extend(double a, double z, double r) {
        above = std::max(above, a - slope * z + secant * r);
        below = std::max(below, -a - slope * z + secant * r);
    }
    double depth() const { return -(above + below) / (2 * slope); } ///< largest d
    double side() const { return (above - below) / 2; }             ///< e in the middle of what is allowed at any d
};

/// The slopes at which an eye at e sees the outermost balls: (a + r - e) / (z - d) at their largest, likewise below.
struct Outermost {
    double e, d;
    double high = -infinity, low = infinity; ///< slopes
    double top = 0, topDepth = 1, bottom = 0, bottomDepth = 1;

    void extend(double a, double z, double r) {
        const double up = (a + r - e) / (z - d), down = (a - r - e) / (z - d);
        if (up > high)
            high = up, top = a + r, topDepth = z - d;
        if (down < low)
            low = down, bottom = a - r, bottomDepth = z - d;
    }
    /// Where both would be seen at the same slope, were they still the outermost.
    double balanced() const { return (top / topDepth + bottom / bottomDepth) / (1 / topDepth + 1 / bottomDepth); }
};

/// Where from the outermost points are seen at the same slope to either side: Newton's steps on high + low, which
/// falls as e grows, kept between the ends of what is known.
double middleSeen(const tree::SurfelTree& model, const Vec3d& axis, const Vec3d& forward, double e, double d) {
    constexpr int most = 12;
    constexpr double enough = 1e-3; // of the slopes
    double left = -infinity, right = infinity;
    for (int step = 0; step < most; ++step) {
        Outermost seen{e, d};
        forShown(model, [&](const Vec3d& p, double r) { seen.extend(dot(p, axis), dot(p, forward), r); });
        const double off = seen.high + seen.low;
        if (std::abs(off) <= enough * (seen.high - seen.low))
            break;
        (off > 0 ? left : right) = e;
        const double next = seen.balanced();
        e = next > left && next < right ? next : 0.5 * (left + right);
    }
    return e;
}

/// Of parallel rays: extents across them.
struct Extents {
    double left = infinity, right = -infinity, low = infinity, high = -infinity;

    Extents(const render::Camera& camera, const tree::SurfelTree& model) {
        const Vec3d aside = camera.right(), up = camera.upright();
        forShown(model, [&](const Vec3d& p, double r) {
            left = std::min(left, dot(p, aside) - r), right = std::max(right, dot(p, aside) + r);
            low = std::min(low, dot(p, up) - r), high = std::max(high, dot(p, up) + r);
        });
    }
};

/// The middle of the extents in the middle of the image, and all of the model before the eye.
render::Camera middled(const render::Camera& camera, const tree::SurfelTree& model, const Extents& extents) {
    render::Camera out = camera;
    const Vec3d aside = camera.right() * (0.5 * (extents.left + extents.right) - dot(camera.target, camera.right())) +
                        camera.upright() * (0.5 * (extents.low + extents.high) - dot(camera.target, camera.upright()));
    out.target += aside;
    out.eye += aside;
    return out.before(model.bounds());
}

} // namespace

/// With parallel rays, depth does not matter: the middle of the extents, and the height that holds them.
static render::Camera closeUpParallel(const render::Camera& camera, const tree::SurfelTree& model) {
    const Extents extents(camera, model);
    render::Camera out = camera;
    const double height =
        std::max(extents.high - extents.low, (extents.right - extents.left) * camera.height / camera.width) / filled;
    if (height > 0) // else one point: any height shows it
        out.orthoHeight = height;
    return middled(out, model, extents);
}

render::Camera centred(const render::Camera& camera, const tree::SurfelTree& model) {
    return model.empty() ? camera : middled(camera, model, Extents(camera, model));
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
    if (model.empty())
        return camera;
    if (camera.parallel())
        return closeUpParallel(camera, model);
    const Vec3d forward = camera.forward(), right = camera.right(), up = camera.upright();
    Reach x{filled * 0.5 * camera.width / camera.focalPx()}, y{filled * 0.5 * camera.height / camera.focalPx()};
    forShown(model, [&](const Vec3d& p, double r) {
        x.extend(dot(p, right), dot(p, forward), r);
        y.extend(dot(p, up), dot(p, forward), r);
    });
    const base::Box3f shown = render::framedBox(model);
    const Vec3d centre = base::cast<double>(shown.centre());
    render::Camera out = camera;
    if (!(shown.diagonal() > 0)) { // one point: any distance shows it
        out.target = centre;
        out.eye = centre + (camera.eye - camera.target);
        return out;
    }
    const double middle = dot(centre, forward), depth = std::min(x.depth(), y.depth());
    // One of the two decides about the depth; the other has room to be in the middle.
    out.eye = right * middleSeen(model, right, forward, x.side(), depth) +
              up * middleSeen(model, up, forward, y.side(), depth) + forward * depth;
    out.target = out.eye + forward * (middle - depth);
    return out;
}

} // namespace app
