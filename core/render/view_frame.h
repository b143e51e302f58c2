// A camera as the splatters use it: float32 view coordinates x right, y down, z forward, with the eye at zero, and
// image places as the slopes x/z and y/z of their rays. There is no near or far plane.
//
// Where rays are parallel, image places are x and y themselves, in model units. Everything that is linear across the
// image in the one projection is so in the other, with another measure of nearness w: a plane has
//
//     w = 1/z (perspective),  w = -z (parallel)       linear in the image place; larger is nearer
//
// and splats are drawn by the same loop over w.
#pragma once

#include "core/render/camera.h"

namespace render {

/// A clip plane in view coordinates: kept is normal . p >= offset. At image place (x, y) that reads
/// normal.x x + normal.y y + constant >= factor w.
struct ViewClip {
    base::Vec3f axis;   ///< the normal in model coordinates
    base::Vec3f normal; ///< in view coordinates
    float offset = 0, constant = 0, factor = 0;
};

struct ViewFrame {
    base::Vec3f right, down, forward; ///< unit axes in model coordinates
    base::Vec3f eye;                  ///< rounded to float, so that p - eye is exact for near p
    base::Vec3f rest;                 ///< what the rounding lost, in view coordinates
    float focalPx = 1, step = 1;      ///< pixels per unit of the image place, and its inverse
    float x0 = 0, y0 = 0;             ///< image place of the centre of the upper left pixel
    int width = 0, height = 0;
    bool parallel = false;
    std::array<ViewClip, ClipPlanes::most> clips;
    int clipCount = 0;

    explicit ViewFrame(const Camera& camera)
        : right(base::cast<float>(camera.right())), down(base::cast<float>(-camera.upright())),
          forward(base::cast<float>(camera.forward())), eye(base::cast<float>(camera.eye)),
          focalPx(static_cast<float>(camera.focalPx())), step(static_cast<float>(1 / camera.focalPx())),
          x0((0.5f - 0.5f * static_cast<float>(camera.width)) * step),
          y0((0.5f - 0.5f * static_cast<float>(camera.height)) * step), width(camera.width), height(camera.height),
          parallel(camera.parallel()) {
        const base::Vec3d lost = camera.eye - base::cast<double>(eye);
        rest = {static_cast<float>(dot(lost, camera.right())), static_cast<float>(-dot(lost, camera.upright())),
                static_cast<float>(dot(lost, camera.forward()))};
        for (const base::Plane& plane : camera.clips.all()) {
            ViewClip& clip = clips[static_cast<std::size_t>(clipCount++)];
            clip.axis = base::cast<float>(plane.normal);
            clip.normal = turn(clip.axis);
            clip.offset = static_cast<float>(-plane.distance(camera.eye));
            clip.constant = parallel ? -clip.offset : clip.normal.z;
            clip.factor = parallel ? clip.normal.z : clip.offset;
        }
    }

    base::Vec3f turn(const base::Vec3f& v) const { return {dot(v, right), dot(v, down), dot(v, forward)}; }
    base::Vec3f toView(const base::Vec3f& p) const { return turn(p - eye) - rest; }
    /// Model units that a pixel covers at a depth.
    float pixelSize(float z) const { return parallel ? step : step * z; }
    /// w of a depth.
    float nearness(float z) const { return parallel ? -z : 1 / z; }
    /// Slopes of the ray itself, for shading: 0 where rays are parallel.
    float raySlopeX(int column) const { return parallel ? 0 : slopeX(column); }
    float raySlopeY(int row) const { return parallel ? 0 : slopeY(row); }
    float slopeX(int column) const { return x0 + static_cast<float>(column) * step; }
    float slopeY(int row) const { return y0 + static_cast<float>(row) * step; }
};

/// Where a box, or a ball of splats around it, can be seen.
struct ScreenBounds {
    bool visible = false;
    int left = 0, top = 0, right = -1, bottom = -1; ///< pixels, inclusive, clipped to the image
    float nearest = 0;                              ///< lower bound of the depth along `forward`; may be negative
    bool operator==(const ScreenBounds&) const = default;
};

/// Conservative bounds of everything within `reach` of the box.
ScreenBounds screenBounds(const ViewFrame& view, const base::Box3f& box, float reach);

} // namespace render
