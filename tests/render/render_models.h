// Models whose picture can be worked out, and comparisons of pictures.
#pragma once

#include "core/base/random.h"
#include "core/cells/labels.h"
#include "core/render/renderer.h"

#include <numbers>

namespace test {

/// Supports of 38 neighbours for a spacing: h = s sqrt(38 / pi).
constexpr float supportOfSpacing = 3.478f;

inline surfel::AttributeLayoutPtr orientedLayout(bool colours = false) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    layout->colours = layout->masks = colours;
    return layout;
}

/// A small picture whose border cuts tiles.
inline render::Camera cutTilesCamera() {
    render::Camera camera;
    camera.width = 321;
    camera.height = 243;
    return camera;
}

/// Hexagonal layout of spacing s on the plane through `centre` across `normal`, within `radius`.
inline surfel::SurfelList disc(const base::Vec3d& centre, const base::Vec3d& normal, double radius, double s) {
    surfel::SurfelList out;
    out.layout = orientedLayout();
    const base::Vec3d u = base::perpendicular(normal), v = cross(normal, u);
    const int n = static_cast<int>(radius / s) + 2;
    for (int row = -2 * n; row <= 2 * n; ++row)
        for (int column = -2 * n; column <= 2 * n; ++column) {
            const double a = (column + 0.5 * (row & 1)) * s, b = row * s * std::sqrt(0.75);
            if (a * a + b * b <= radius * radius)
                out.items.push_back({base::cast<float>(centre + u * a + v * b), base::cast<float>(normal),
                                     static_cast<float>(s) * supportOfSpacing, surfel::white, 0});
        }
    return out;
}

/// Spacing of n samples spread evenly over an area.
inline double evenSpacing(double area, std::size_t n) {
    return std::sqrt(area / static_cast<double>(n) * 2 / std::sqrt(3.0));
}

/// Fibonacci's spiral on a sphere: nearly even. Colours and masks vary smoothly.
inline surfel::SurfelList sphere(const base::Vec3d& centre, double radius, std::size_t n, bool colours = false) {
    surfel::SurfelList out;
    out.layout = orientedLayout(colours);
    const double s = evenSpacing(4 * std::numbers::pi * radius * radius, n);
    for (std::size_t i = 0; i < n; ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n), r = std::sqrt(1 - z * z);
        const double angle = 2.399963229728653 * static_cast<double>(i);
        const base::Vec3d d{r * std::cos(angle), r * std::sin(angle), z};
        const auto byte = [](double v) { return static_cast<unsigned>(127.5 + 127 * v); };
        out.items.push_back({base::cast<float>(centre + d * radius), base::cast<float>(d),
                             static_cast<float>(s) * supportOfSpacing,
                             colours ? surfel::rgba(byte(d.x), byte(d.y), byte(d.z)) : surfel::white,
                             colours ? static_cast<float>(0.5 + 0.5 * d.y) : 0.0f});
    }
    return out;
}

/// Random samples on a torus around the y axis, none closer than about half a spacing: as uneven as a good scan.
inline surfel::SurfelList torus(double ring, double tube, std::size_t n, std::uint64_t seed) {
    surfel::SurfelList out;
    out.layout = orientedLayout();
    base::Random random(seed);
    const double s = evenSpacing(4 * std::numbers::pi * std::numbers::pi * ring * tube, n);
    // A grid of the two angles with rows of equal spacing, shaken by a quarter of it.
    const auto rows = static_cast<int>(2 * std::numbers::pi * tube / (s * 0.866) + 0.5);
    for (int row = 0; row < rows; ++row) {
        const double v = 2 * std::numbers::pi * (row + 0.25 * random.uniform(-1, 1)) / rows;
        const auto columns = static_cast<int>(2 * std::numbers::pi * (ring + tube * std::cos(v)) / s + 0.5);
        for (int column = 0; column < columns; ++column) {
            const double u = 2 * std::numbers::pi * (column + 0.5 * (row & 1) + 0.25 * random.uniform(-1, 1)) / columns;
            const base::Vec3d d{std::cos(u) * std::cos(v), std::sin(v), std::sin(u) * std::cos(v)};
            const base::Vec3d middle{ring * std::cos(u), 0, ring * std::sin(u)};
            out.items.push_back({base::cast<float>(middle + d * tube), base::cast<float>(d),
                                 static_cast<float>(s) * supportOfSpacing, surfel::white, 0});
        }
    }
    return out;
}

inline tree::SurfelTree built(const surfel::SurfelList& list) {
    return tree::SurfelTree::build(list);
}

inline render::Image drawn(render::Renderer& renderer, const tree::SurfelTree& model, const render::Camera& camera,
                           const render::RenderOptions& options = {}) {
    render::Image out;
    renderer.render(model, camera, options, out);
    return out;
}

/// Mean and largest difference of a channel, in steps of 1/255; `apart` counts pixels that one covers alone.
struct Difference {
    double mean = 0, largest = 0;
    std::size_t apart = 0;
};

inline Difference difference(const render::Image& a, const render::Image& b) {
    Difference out;
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        double most = 0;
        for (int k = 0; k < 32; k += 8)
            most = std::max(most, std::abs(static_cast<double>(a.colour[i] >> k & 255u) -
                                           static_cast<double>(b.colour[i] >> k & 255u)));
        out.mean += most / static_cast<double>(a.colour.size());
        out.largest = std::max(out.largest, most);
        out.apart += std::isfinite(a.depth[i]) != std::isfinite(b.depth[i]) ? 1 : 0;
    }
    return out;
}

/// Distance along a unit ray to the sphere's front, or infinity.
inline double sphereDepth(const base::Rayd& ray, const base::Vec3d& centre, double radius) {
    const base::Vec3d v = ray.origin - centre;
    const double b = dot(v, ray.direction), root = b * b - lengthSq(v) + radius * radius;
    return root < 0 ? std::numeric_limits<double>::infinity() : -b - std::sqrt(root);
}

/// A face of a solid that looks away, and half a unit behind it one that looks to the eye at z > 0.
inline tree::SurfelTree backBeforeFront(bool labelled) {
    surfel::SurfelList list = disc({0, 0, 0}, {0, 0, -1}, 0.5, 0.02);
    const surfel::SurfelList front = disc({0, 0, -0.5}, {0, 0, 1}, 1, 0.02);
    list.items.insert(list.items.end(), front.items.begin(), front.items.end());
    if (labelled)
        cells::setLabels(list, std::vector<cells::Label>(list.size()));
    return built(list);
}

} // namespace test
