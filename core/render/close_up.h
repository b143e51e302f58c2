// The camera that shows balls as large as it can, with as much room to the left as to the right and above as below:
// templates over a walk through the balls, so that points with their discs and the corners of boxes are framed alike
// and nothing is copied. What the camera turns about is another thing than what it aims at: the middle of what is seen
// is not seen in the middle of the picture.
//
// A walk is called as forBalls(fn), and calls fn(centre, radius) for each. Cost: some walks.
#pragma once

#include "core/render/camera.h"

#include <cmath>
#include <limits>

namespace render {

namespace framing {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// Where from the outermost balls are seen at the same slope to either side: Newton's steps on high + low, which falls
/// as e grows, kept between the ends of what is known.
template <class ForBalls>
double middleSeen(const ForBalls& forBalls, const base::Vec3d& axis, const base::Vec3d& forward, double e, double d) {
    constexpr int most = 12;
    constexpr double enough = 1e-3; // of the slopes
    double left = -infinity, right = infinity;
    for (int step = 0; step < most; ++step) {
        Outermost seen{e, d};
        forBalls([&](const base::Vec3d& p, double r) { seen.extend(dot(p, axis), dot(p, forward), r); });
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

    template <class ForBalls>
    Extents(const Camera& camera, const ForBalls& forBalls) {
        const base::Vec3d aside = camera.right(), up = camera.upright();
        forBalls([&](const base::Vec3d& p, double r) {
            left = std::min(left, dot(p, aside) - r), right = std::max(right, dot(p, aside) + r);
            low = std::min(low, dot(p, up) - r), high = std::max(high, dot(p, up) + r);
        });
    }
    /// Of an image that holds all of it in a part of its height and width; 0: a point.
    double height(const Camera& camera, double filled) const {
        return std::max(high - low, (right - left) * camera.height / camera.width) / filled;
    }
    /// From the target to what is seen in the middle.
    base::Vec3d aside(const Camera& camera) const {
        return camera.right() * (0.5 * (left + right) - dot(camera.target, camera.right())) +
               camera.upright() * (0.5 * (low + high) - dot(camera.target, camera.upright()));
    }
};

} // namespace framing

/// In perspective: the camera moved, its direction and angle kept. The balls reach a part `filled` of the half image;
/// the target comes to lie as deep as `centre`. REQUIRES: perspective, balls that are not all one point.
template <class ForBalls>
Camera closeUpOf(const Camera& camera, const ForBalls& forBalls, const base::Vec3d& centre, double filled) {
    const base::Vec3d forward = camera.forward(), right = camera.right(), up = camera.upright();
    framing::Reach x{filled * 0.5 * camera.width / camera.focalPx()},
        y{filled * 0.5 * camera.height / camera.focalPx()};
    forBalls([&](const base::Vec3d& p, double r) {
        x.extend(dot(p, right), dot(p, forward), r);
        y.extend(dot(p, up), dot(p, forward), r);
    });
    const double middle = dot(centre, forward), depth = std::min(x.depth(), y.depth());
    Camera out = camera;
    // One of the two decides about the depth; the other has room to be in the middle.
    out.eye = right * framing::middleSeen(forBalls, right, forward, x.side(), depth) +
              up * framing::middleSeen(forBalls, up, forward, y.side(), depth) + forward * depth;
    out.target = out.eye + forward * (middle - depth);
    return out;
}

} // namespace render
