// What splats cover, held against what rays hit.
#pragma once

#include "core/render/cast/raycast_image.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/splat_scale.h"
#include "render/render_models.h"

#include <numbers>
#include <span>

namespace test {

/// Pixels of pictures.
struct MaskGap {
    std::size_t hit = 0;    ///< by rays
    std::size_t holes = 0;  ///< splats show the background where a ray and those of the eight pixels about it hit
    std::size_t strays = 0; ///< splats show something where a ray and those of the eight pixels about it pass

    double holesPercent() const { return 100 * double(holes) / double(std::max<std::size_t>(1, hit)); }
    double straysPercent() const { return 100 * double(strays) / double(std::max<std::size_t>(1, hit)); }
    MaskGap& operator+=(const MaskGap& o) {
        hit += o.hit, holes += o.holes, strays += o.strays;
        return *this;
    }
};

inline MaskGap maskGap(const render::Image& rays, const render::Image& splats) {
    MaskGap out;
    const auto hits = [&](int x, int y) {
        x = std::clamp(x, 0, rays.width - 1), y = std::clamp(y, 0, rays.height - 1);
        return std::isfinite(rays.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(rays.width) +
                                        static_cast<std::size_t>(x)]);
    };
    for (int y = 0; y < rays.height; ++y)
        for (int x = 0; x < rays.width; ++x) {
            int around = 0;
            for (int k = 0; k < 9; ++k)
                around += hits(x + k % 3 - 1, y + k / 3 - 1) ? 1 : 0;
            const std::size_t at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(rays.width) + static_cast<std::size_t>(x);
            const bool shown = std::isfinite(splats.depth[at]);
            out.hit += hits(x, y) ? 1 : 0;
            out.holes += around == 9 && !shown ? 1 : 0;
            out.strays += around == 0 && shown ? 1 : 0;
        }
    return out;
}

/// What rays show.
inline render::Image raysOf(const surface::Surface& surface, const render::Camera& camera,
                            const render::RenderOptions& options) {
    render::Image out;
    out.resize(camera.width, camera.height);
    render::RayCounts counts;
    render::rayCast(surface, camera, options, out, counts);
    return out;
}

/// Views of the whole model from the corners of an icosahedron.
inline std::vector<render::Camera> allAround(const base::Box3f& box, int width, int height) {
    std::vector<render::Camera> out;
    for (int i = 0; i < 12; ++i) {
        const double a = i & 1 ? 1 : -1, b = (i & 2 ? 1 : -1) * std::numbers::phi;
        const base::Vec3d from = i < 4 ? base::Vec3d{0, a, b} : i < 8 ? base::Vec3d{a, b, 0} : base::Vec3d{b, 0, a};
        render::Camera camera;
        camera.width = width, camera.height = height;
        camera.target = base::cast<double>(box.centre());
        camera.eye = camera.target + from * double(box.diagonal());
        camera.up = i < 4 ? base::Vec3d{0, 1, 0} : i < 8 ? base::Vec3d{1, 0, 0} : base::Vec3d{0, 0, 1};
        out.push_back(camera.framing(box));
    }
    return out;
}

/// As a picture at rest is drawn.
inline render::RenderOptions atRest(const surface::Surface& surface) {
    render::RenderOptions out;
    out.definition = surface.definition();
    out.splatScale = render::splatScaleOf(surface.tree());
    return out;
}

/// Of splats and rays, over some views.
inline MaskGap maskGap(const surface::Surface& surface, const render::RenderOptions& options,
                       std::span<const render::Camera> views) {
    render::CpuSplatter splatter;
    MaskGap out;
    for (const render::Camera& camera : views)
        out += maskGap(raysOf(surface, camera, options), drawn(splatter, surface.tree(), camera, options));
    return out;
}

} // namespace test
