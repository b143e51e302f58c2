// Samples whose supports are ellipsoids, for the surface tests.
#pragma once

#include "core/surfel/shape.h"
#include "surface/shapes.h"

namespace shapes {

/// The same surfels with the shapes that `shapeOf` gives each.
inline surfel::SurfelList shaped(surfel::SurfelList list,
                                 const std::function<base::Vec3f(const surfel::Surfel&)>& shapeOf) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    const std::size_t words = layout->words();
    surfel::addShape(*layout);
    std::vector<std::uint32_t> extra;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t first = extra.size();
        extra.insert(extra.end(), list.extra.begin() + static_cast<std::ptrdiff_t>(i * words),
                     list.extra.begin() + static_cast<std::ptrdiff_t>((i + 1) * words));
        extra.resize(first + layout->words());
        surfel::putShape(std::span(extra).subspan(first), surfel::shapeWord(*layout), shapeOf(list.items[i]));
    }
    list.layout = layout;
    list.extra = std::move(extra);
    return list;
}

/// Balls, as ellipsoids.
inline surfel::SurfelList balls(const surfel::SurfelList& list) {
    return shaped(list, [](const surfel::Surfel&) { return base::Vec3f{}; });
}

/// Across the normals in random directions, semi-axes from 1 to `most` to 1; supports keep their area.
inline surfel::SurfelList ellipsoids(surfel::SurfelList list, double most, std::uint64_t seed) {
    base::Random random(seed);
    surfel::SurfelList out = shaped(std::move(list), [&](const surfel::Surfel& s) {
        const base::Vec3d n = base::cast<double>(s.normal), u = base::perpendicular(n), v = cross(n, u);
        const double angle = random.uniform(0, 2 * pi), aspect = random.uniform(1, most);
        return base::cast<float>((u * std::cos(angle) + v * std::sin(angle)) * std::sqrt(aspect * aspect - 1));
    });
    const std::size_t first = surfel::shapeWord(*out.layout);
    for (std::size_t i = 0; i < out.size(); ++i)
        out.items[i].support *= std::sqrt(surfel::aspectOf(surfel::shapeIn(out.extraOf(i), first)));
    return out;
}

} // namespace shapes
