#include "core/raycast/full_cast.h"

#include "core/raycast/cast_pixels.h"

#include <chrono>

namespace raycast {

/// Rays go through the intersection in square tiles; this many rows of tiles between two looks at the progress.
constexpr int tileSize = 16, tileRowsPerStep = 4;

/// Wendland's C2 function, or the Gaussian cut at its reach (alg. 2.1), without normalisation.
static float weightAt(surface::Weight weight, float distanceSq, float support) {
    const float r2 = distanceSq / (support * support);
    if (r2 >= 1)
        return 0;
    if (weight == surface::Weight::Gaussian)
        return std::exp(-r2 * surface::gaussianReach * surface::gaussianReach);
    const float r = std::sqrt(r2), q = (1 - r) * (1 - r);
    return q * q * (4 * r + 1);
}

void blendAttributes(const surface::Surface& surface, const base::Vec3f& x, Sample& out) {
    float weight = 0, mask = 0;
    base::Vec3f colour;
    surface.tree().forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const float* px = block.channel(cluster, surfel::X);
        const float* py = block.channel(cluster, surfel::Y);
        const float* pz = block.channel(cluster, surfel::Z);
        const float* support = block.channel(cluster, surfel::Support);
        const float* masks = block.channel(cluster, surfel::Mask);
        const std::uint32_t* colours = block.words(cluster, surfel::ColourWord);
        for (int i = 0; i < surfel::clusterSize; ++i) {
            const float distanceSq = base::distanceSq(x, {px[i], py[i], pz[i]});
            const float w = weightAt(surface.definition().weight, distanceSq, support[i]);
            weight += w;
            mask += w * masks[i];
            for (std::size_t k = 0; k < 3; ++k)
                colour[k] += w * static_cast<float>(colours[i] >> (8 * k) & 255u);
        }
    });
    if (!(weight > 0))
        return;
    const auto channel = [&](std::size_t k) { return static_cast<unsigned>(colour[k] / weight + 0.5f); };
    out.colour = surfel::rgba(channel(0), channel(1), channel(2));
    out.mask = mask / weight;
}

/// Pixels of some rows in the order of their tiles.
static std::vector<Pixel> tileOrder(int width, int firstRow, int rows) {
    std::vector<Pixel> order;
    order.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
    for (int top = 0; top < rows; top += tileSize)
        for (int left = 0; left < width; left += tileSize)
            for (int y = top; y < std::min(rows, top + tileSize); ++y)
                for (int x = left; x < std::min(width, left + tileSize); ++x)
                    order.push_back({x, firstRow + y});
    return order;
}

static void castRows(const surface::Surface& surface, const ImageRays& view, int firstRow, int rows,
                     std::vector<Sample>& out) {
    const std::vector<Pixel> pixels = tileOrder(view.width, firstRow, rows);
    castEach(surface, view, pixels, [&](std::size_t i) -> Sample& {
        return out[static_cast<std::size_t>(pixels[i].row) * static_cast<std::size_t>(view.width) +
                   static_cast<std::size_t>(pixels[i].column)];
    });
}

std::vector<Sample> fullCast(const surface::Surface& surface, const ImageRays& rays, CastCounts& counts,
                             const base::Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<Sample> out(static_cast<std::size_t>(rays.width) * static_cast<std::size_t>(rays.height));
    constexpr int step = tileSize * tileRowsPerStep;
    for (int row = 0; row < rays.height; row += step) {
        progress.step(static_cast<double>(row) / rays.height, "casting rays");
        castRows(surface, rays, row, std::min(step, rays.height - row), out);
    }
    counts.rays = counts.pixels = out.size();
    counts.hits = counts.evaluations = 0;
    for (const Sample& sample : out) {
        counts.hits += sample.hit.hit ? 1 : 0;
        counts.evaluations += static_cast<std::size_t>(sample.hit.evaluations);
    }
    counts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
}

} // namespace raycast
