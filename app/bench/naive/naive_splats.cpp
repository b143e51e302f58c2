#include "app/bench/naive/naive_splats.h"

#include <algorithm>
#include <cmath>

namespace bench {

void naiveSplats(std::span<const surfel::Surfel> surfels, float radiusOfSupport, const render::Camera& camera,
                 render::Image& image) {
    image.resize(camera.width, camera.height);
    const base::Vec3d light = -camera.forward();
    for (const surfel::Surfel& s : surfels) {
        const base::Vec3d p = camera.project(base::cast<double>(s.position));
        if (p.z <= 0)
            continue;
        const double half = static_cast<double>(radiusOfSupport * s.support) * camera.focalPx() / p.z;
        const int x0 = std::max(0, static_cast<int>(p.x - half)), y0 = std::max(0, static_cast<int>(p.y - half));
        const int x1 = std::min(camera.width - 1, static_cast<int>(p.x + half)),
                  y1 = std::min(camera.height - 1, static_cast<int>(p.y + half));
        const double lit = std::abs(dot(base::cast<double>(s.normal), light));
        const auto grey = static_cast<unsigned>(255 * std::min(1.0, lit));
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x) {
                const auto i =
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(x);
                if (static_cast<float>(p.z) >= image.depth[i])
                    continue;
                image.depth[i] = static_cast<float>(p.z);
                image.colour[i] = surfel::rgba(grey, grey, grey);
            }
    }
}

} // namespace bench
