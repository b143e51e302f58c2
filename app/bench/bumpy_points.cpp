// r(u) = 1 + 0.01 (sin 11x + sin 11y + sin 11z) in the direction u, sampled along a Fibonacci spiral.
#include "app/bench/scene.h"
#include "core/base/random.h"

#include <numbers>

namespace bench {

using base::Vec3d;
using std::numbers::pi;

constexpr double neighbours = 20, height = 0.01, frequency = 11;

static double radiusAlong(const Vec3d& u) {
    return 1 + height * (std::sin(frequency * u.x) + std::sin(frequency * u.y) + std::sin(frequency * u.z));
}

/// grad (|p| - r(p / |p|)), normalised.
static Vec3d normalAt(const Vec3d& p) {
    const double rho = length(p);
    const Vec3d u = p / rho;
    const Vec3d slope =
        Vec3d{std::cos(frequency * u.x), std::cos(frequency * u.y), std::cos(frequency * u.z)} * (height * frequency);
    return base::normalized(u - (slope - u * dot(slope, u)) / rho);
}

surfel::SurfelList bumpyPoints(const SceneOptions& options, const base::Progress& progress) {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = layout->colours = true;
    list.layout = layout;
    list.items.resize(options.points);
    const auto count = static_cast<double>(options.points);
    const double spacing = std::sqrt(4 * pi / count), noise = options.noisePercent / 100;
    base::Random random(1);
    for (std::size_t i = 0; i < options.points; ++i) {
        if (i % 65536 == 0)
            progress.step(static_cast<double>(i) / count, "Making points");
        const double z = 1 - (2 * static_cast<double>(i) + 1) / count, r = std::sqrt(1 - z * z);
        const double angle = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
        const Vec3d u{r * std::cos(angle), r * std::sin(angle), z};
        Vec3d p = u * radiusAlong(u);
        surfel::Surfel& s = list.items[i];
        s.normal = base::cast<float>(normalAt(p));
        if (noise > 0)
            p += Vec3d{random.normal(), random.normal(), random.normal()} * noise;
        s.position = base::cast<float>(p);
        s.colour = surfel::rgba(static_cast<unsigned>(127 + 120 * u.x), static_cast<unsigned>(127 + 120 * u.y), 200);
        s.support = static_cast<float>(spacing * std::sqrt(neighbours / pi));
    }
    return list;
}

} // namespace bench
