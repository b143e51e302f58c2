// A camera as the splatters use it: float32 view coordinates x right, y down, z forward, with the eye at zero, and
// image places as the slopes x/z and y/z of their rays. There is no near or far plane.
#pragma once

#include "ui/render/camera.h"

namespace render {

struct ViewFrame {
    base::Vec3f right, down, forward; ///< unit axes in model coordinates
    base::Vec3f eye;                  ///< rounded to float, so that p - eye is exact for near p
    base::Vec3f rest;                 ///< what the rounding lost, in view coordinates
    float focalPx = 1, step = 1;      ///< pixels per unit slope, and its inverse
    float x0 = 0, y0 = 0;             ///< slopes of the centre of the upper left pixel
    int width = 0, height = 0;

    explicit ViewFrame(const Camera& camera)
        : right(base::cast<float>(camera.right())), down(base::cast<float>(-camera.upright())),
          forward(base::cast<float>(camera.forward())), eye(base::cast<float>(camera.eye)),
          focalPx(static_cast<float>(camera.focalPx())), step(static_cast<float>(1 / camera.focalPx())),
          x0((0.5f - 0.5f * static_cast<float>(camera.width)) * step),
          y0((0.5f - 0.5f * static_cast<float>(camera.height)) * step), width(camera.width), height(camera.height) {
        const base::Vec3d lost = camera.eye - base::cast<double>(eye);
        rest = {static_cast<float>(dot(lost, camera.right())), static_cast<float>(-dot(lost, camera.upright())),
                static_cast<float>(dot(lost, camera.forward()))};
    }

    base::Vec3f turn(const base::Vec3f& v) const { return {dot(v, right), dot(v, down), dot(v, forward)}; }
    base::Vec3f toView(const base::Vec3f& p) const { return turn(p - eye) - rest; }
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
