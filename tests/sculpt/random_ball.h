// A ball that nobody made for sculpting: random relief, random places, from coarse to fine, noise.
#pragma once

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "sculpt/shapes.h"

#include <array>

namespace test {

/// The unit sphere with waves of these heights in all; `count` random points, five times as fine on one side as on the
/// other, each up to `noise` beside its place. Normals are exact, supports estimated.
inline surface::Surface randomBall(base::Random& random, std::size_t count, double relief, double noise) {
    using base::Vec3d;
    struct Wave {
        Vec3d along;
        double frequency, phase;
    };
    std::array<Wave, 6> waves;
    for (Wave& each : waves)
        each = {random.unitVector(), random.uniform(3, 9), random.uniform(0, 6.28)};
    const auto at = [&](const Vec3d& u) {
        double radius = 1;
        for (const Wave& each : waves)
            radius += relief / double(waves.size()) * std::sin(each.frequency * dot(each.along, u) + each.phase);
        return u * radius;
    };
    const Vec3d fine = random.unitVector();
    surfel::SurfelList out;
    out.layout = orientedLayout();
    while (out.size() < count) {
        const Vec3d u = random.unitVector();
        if (random.uniform() > std::exp(1.6 * (dot(u, fine) - 1)))
            continue;
        const Vec3d a = base::cast<double>(base::perpendicular(base::cast<float>(u))), b = cross(u, a);
        constexpr double e = 1e-4;
        const Vec3d n = cross(at(normalized(u + a * e)) - at(normalized(u - a * e)),
                              at(normalized(u + b * e)) - at(normalized(u - b * e)));
        surfel::Surfel s;
        s.position = base::cast<float>(at(u) + random.unitVector() * (noise * random.uniform()));
        s.normal = base::cast<float>(normalized(dot(n, u) < 0 ? n * -1.0 : n));
        out.append(s, {});
    }
    return process::prepare(out, {});
}

} // namespace test
