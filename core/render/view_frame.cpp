#include "core/render/view_frame.h"

#include <algorithm>

namespace render {

using base::Vec3f;

static float extentAlong(const Vec3f& axis, const Vec3f& half) {
    return std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
}

/// Pixels whose centres have slopes in centre +- half, clipped to [0, count); the filter reaches a pixel further.
static void pixelRange(float centre, float half, float first, float focalPx, int count, int& low, int& high) {
    const float a = (centre - half - first) * focalPx - 1, b = (centre + half - first) * focalPx + 1;
    low = static_cast<int>(std::ceil(std::clamp(a, 0.0f, static_cast<float>(count))));
    high = static_cast<int>(std::floor(std::clamp(b, -1.0f, static_cast<float>(count - 1))));
}

/// Is all within `reach` of the box cut away by one plane? Fragments stay within that and a few pixels of the filter.
static bool cutAway(const ViewFrame& view, const Vec3f& centre, const Vec3f& half, float reach, float farthest) {
    constexpr float filterPixels = 5;
    const float more = reach + filterPixels * view.pixelSize(std::max(farthest, 0.0f));
    for (int k = 0; k < view.clipCount; ++k) {
        const ViewClip& clip = view.clips[static_cast<std::size_t>(k)];
        if (dot(clip.normal, centre) + extentAlong(clip.axis, half) + more < clip.offset)
            return true;
    }
    return false;
}

ScreenBounds screenBounds(const ViewFrame& view, const base::Box3f& box, float reach) {
    const Vec3f centre = view.toView(box.centre()), half = (box.hi - box.lo) * 0.5f;
    const float ez = extentAlong(view.forward, half) + reach;
    ScreenBounds out;
    out.nearest = centre.z - ez;
    if (centre.z + ez <= 0 || cutAway(view, centre, half, reach, centre.z + ez))
        return out;
    const float ex = extentAlong(view.right, half) + reach, ey = extentAlong(view.down, half) + reach;
    if (view.parallel) {
        pixelRange(centre.x, ex, view.x0, view.focalPx, view.width, out.left, out.right);
        pixelRange(centre.y, ey, view.y0, view.focalPx, view.height, out.top, out.bottom);
        out.visible = out.left <= out.right && out.top <= out.bottom;
        return out;
    }
    // Where the box meets the plane of the eye its image has no bounds.
    if (out.nearest <= 1e-3f * ez) {
        out.right = view.width - 1, out.bottom = view.height - 1;
        out.visible = true;
        return out;
    }
    const float inverse = 1 / centre.z, x = centre.x * inverse, y = centre.y * inverse;
    // |(cx + a) / (cz + c) - cx / cz| <= (|a| + |x| |c|) / (cz - |c|)
    pixelRange(x, (ex + std::abs(x) * ez) / out.nearest, view.x0, view.focalPx, view.width, out.left, out.right);
    pixelRange(y, (ey + std::abs(y) * ez) / out.nearest, view.y0, view.focalPx, view.height, out.top, out.bottom);
    out.visible = out.left <= out.right && out.top <= out.bottom;
    return out;
}

} // namespace render
