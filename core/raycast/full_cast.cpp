#include "core/raycast/full_cast.h"

#include "core/raycast/cast_pixels.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"

#include <chrono>

namespace raycast {

/// Rays go through the intersection in square tiles; this many rows of tiles between two looks at the progress.
constexpr int tileSize = 16, tileRowsPerStep = 4;

void blendAttributes(const surface::Surface& surface, const base::Vec3f& x, Sample& out) {
    surface::AttributeSum sum(*surfel::AttributeLayout::none());
    const auto add = [&](const surfel::SurfelBlock& block, int slot, float theta) { sum.add(block, slot, theta); };
    surface::forWeights(surface, x, add);
    if (!sum.any())
        return;
    out.colour = sum.colour() | surfel::rgba(0, 0, 0); // opaque
    out.mask = sum.mask();
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

static void castRows(const cells::AnySurface& surface, const ImageRays& view, int firstRow, int rows,
                     std::vector<Sample>& out) {
    const std::vector<Pixel> pixels = tileOrder(view.width, firstRow, rows);
    castEach(surface, view, pixels, [&](std::size_t i) -> Sample& {
        return out[static_cast<std::size_t>(pixels[i].row) * static_cast<std::size_t>(view.width) +
                   static_cast<std::size_t>(pixels[i].column)];
    });
}

std::vector<Sample> fullCast(const cells::AnySurface& surface, const ImageRays& rays, CastCounts& counts,
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
