// A relief of waves a few spacings long: what wears off first where a surface is sampled anew.
#pragma once

#include "core/base/random.h"
#include "core/surface/projection/project.h"
#include "process/even_shapes.h"

namespace test {

/// z = a sin(2 pi x / L) with a = L / 20.
struct Relief {
    static constexpr double spacing = 0.02;
    double wave, height = 0.05 * wave, k = 2 * std::numbers::pi / wave;

    explicit Relief(double spacings) : wave(spacings * spacing) {}

    /// rows x rows surfels around the origin.
    surface::Surface surface(int rows) const {
        surfel::SurfelList points = planePoints(rows, spacing);
        for (surfel::Surfel& each : points.items) {
            const double x = double(each.position.x), slope = height * k * std::cos(k * x);
            each.position.z = static_cast<float>(height * std::sin(k * x));
            each.normal = base::cast<float>(normalized(base::Vec3d{-slope, 0, 1}));
        }
        return surfaceOf(points);
    }
    /// The part of its height that a surface has within `half` of the origin.
    double leftIn(const surface::Surface& surface, double half) const {
        double sum = 0, all = 0;
        base::Random random(1);
        for (int i = 0; i < 4000; ++i) {
            const double x = random.uniform(-half, half), y = random.uniform(-half, half);
            const base::Vec3d from{x, y, height * std::sin(k * x)};
            const auto foot = surface::project(surface, base::cast<float>(from), {});
            if (!foot.ok())
                continue;
            const double sine = std::sin(k * double(foot.foot.x));
            sum += double(foot.foot.z) * sine, all += sine * sine;
        }
        return sum / all / height;
    }
};

} // namespace test
