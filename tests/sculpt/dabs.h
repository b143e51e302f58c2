// Dabs by hand, and models that give every tool something to do.
#pragma once

#include "core/base/random.h"
#include "core/sculpt/tool.h"
#include "sculpt/shapes.h"

namespace test {

/// Looking down at `centre` on a surface that faces upwards.
inline sculpt::Dab dabOf(const sculpt::ToolRow& row, const base::Vec3f& centre, float radius, float strength) {
    sculpt::Dab dab;
    dab.centre = dab.areaCentre = dab.anchor = centre;
    dab.normal = dab.areaNormal = dab.anchorNormal = {0, 0, 1};
    dab.view = {0, 0, -1};
    dab.radius = radius;
    dab.strength = strength;
    for (const sculpt::ToolParameter& parameter : row.parameters)
        dab.parameters[parameter.id] = parameter.fallback;
    return dab;
}

inline surface::Surface applied(const sculpt::ToolRow& row, const surface::Surface& s, const sculpt::Dab& dab) {
    return {s.tree().apply(row.apply(s, dab)), s.definition()};
}

/// The unit sphere with low relief, unevenly sampled, in random colours: every tool can change it.
inline surfel::SurfelList livelyPoints(std::size_t count, base::Random& random) {
    surfel::SurfelList out = spherePoints(count);
    auto layout = std::make_shared<surfel::AttributeLayout>(*out.layout);
    layout->colours = true;
    out.layout = layout;
    // |p| = 1 + a sin kx sin ky sin kz, a level set whose gradient is the normal.
    constexpr double a = 0.01, k = 5;
    for (surfel::Surfel& s : out.items) {
        const base::Vec3d jitter = random.unitVector() * (0.2 * sphereSpacing(count));
        const base::Vec3d u = normalized(base::cast<double>(s.position) + jitter);
        const base::Vec3d sines{std::sin(k * u.x), std::sin(k * u.y), std::sin(k * u.z)},
            cosines{std::cos(k * u.x), std::cos(k * u.y), std::cos(k * u.z)};
        const base::Vec3d slope =
            base::Vec3d{cosines.x * sines.y * sines.z, sines.x * cosines.y * sines.z, sines.x * sines.y * cosines.z} *
            (a * k);
        const base::Vec3d flat = slope - u * dot(u, slope);
        const double r = 1 + a * sines.x * sines.y * sines.z;
        s.position = base::cast<float>(u * r);
        s.normal = base::cast<float>(normalized(u - flat / r));
        s.colour = static_cast<surfel::Colour>(random.below(1u << 24)) | 0xff000000u;
    }
    return out;
}

} // namespace test
