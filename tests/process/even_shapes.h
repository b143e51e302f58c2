// Exact, evenly sampled shapes, and what one wants to know about what became of them.
#pragma once

#include "core/process/estimation/spacing.h"
#include "core/process/resampling/resample.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace test {

inline surfel::AttributeLayoutPtr orientedLayout() {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    return layout;
}

inline surfel::Surfel surfelAt(const base::Vec3d& p, const base::Vec3d& n, double spacing) {
    surfel::Surfel s;
    s.position = base::cast<float>(p);
    s.normal = base::cast<float>(n);
    s.support = static_cast<float>(spacing * std::sqrt(38 / std::numbers::pi));
    return s;
}

/// Spacing of `count` surfels on the unit sphere.
inline double sphereSpacing(std::size_t count) {
    return std::sqrt(4 * std::numbers::pi / static_cast<double>(count));
}

/// Fibonacci points on the unit sphere: even everywhere.
inline surfel::SurfelList spherePoints(std::size_t count) {
    surfel::SurfelList out;
    out.layout = orientedLayout();
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double angle = static_cast<double>(i) * std::numbers::pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
        const base::Vec3d p{r * std::cos(angle), r * std::sin(angle), z};
        out.append(surfelAt(p, p, sphereSpacing(count)), {});
    }
    return out;
}

/// A hexagonal layout of spacing s in the plane z = 0, `rows` x `rows` points around the origin, normals up.
inline surfel::SurfelList planePoints(int rows, double s) {
    surfel::SurfelList out;
    out.layout = orientedLayout();
    const double d = s / 0.93;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < rows; ++j)
            out.append(
                surfelAt({(j - rows / 2 + 0.5 * (i & 1)) * d, (i - rows / 2) * d * std::sqrt(0.75), 0}, {0, 0, 1}, s),
                {});
    return out;
}

inline surface::Surface surfaceOf(const surfel::SurfelList& points) {
    return {tree::SurfelTree::build(points), {}};
}

inline process::Summary spacingOver(const surface::Surface& surface, double s) {
    process::Summary m = process::summarise(process::spacings(surface.tree().surfels().items));
    const float scale = static_cast<float>(1 / s);
    return {m.min * scale, m.median * scale, m.max * scale};
}

/// The same measured within each sheet: 0.93 x mean distance of the 6 nearest that face as the surfel does. Where a
/// fold closes (summed normals below 0.6 of the weights) there is no saying what a sheet is, and nothing counts.
template <class Among>
process::Summary spacingOfSheets(const surface::Surface& surface, double s, const Among& among) {
    std::vector<float> out;
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& at : surface.tree().surfels().items) {
        if (!among(at) || surface.evaluate(at.position, surface::Need::Value).agreement < 0.6f)
            continue;
        surface.tree().nearest(at.position, 40, near);
        double sum = 0;
        int found = 0;
        for (std::size_t k = 0; k < near.size() && found < 6; ++k)
            if (near[k].distanceSq > 0 && dot(near[k].block->normal(near[k].slot), at.normal) > 0.17f)
                sum += std::sqrt(double(near[k].distanceSq)), ++found;
        out.push_back(static_cast<float>(found == 6 ? 0.93 * sum / 6 / s : 1e9));
    }
    return process::summarise(std::move(out));
}

inline process::Summary spacingOfSheets(const surface::Surface& surface, double s) {
    return spacingOfSheets(surface, s, [](const surfel::Surfel&) { return true; });
}

/// Moves surfels by fn(surfel) without changing the tree's shape more than it must.
template <class Fn>
surface::Surface changed(const surface::Surface& surface, const Fn& fn) {
    tree::Edit edit;
    edit.inserted.layout = surface.tree().layout();
    surface.tree().forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const surfel::MutableBlockPtr copy = block.clone();
        for (int slot = 0; slot < block.size(); ++slot) {
            surfel::Surfel s = block.surfel(slot);
            fn(s);
            copy->set(slot, s);
        }
        copy->seal();
        edit.blocks.push_back({number, copy, {}});
    });
    return {surface.tree().apply(edit), surface.definition()};
}

inline double meanRadius(const surface::Surface& surface) {
    double sum = 0;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        sum += length(base::cast<double>(s.position));
    return sum / double(surface.tree().size());
}

inline std::string hashOf(const surface::Surface& surface) {
    return surface.tree().contentHash().text();
}

/// Surfels of `a` that `b` has not, bit for bit.
inline std::vector<surfel::Surfel> without(const surface::Surface& a, const surface::Surface& b) {
    const auto less = [](const surfel::Surfel& p, const surfel::Surfel& q) {
        return std::tie(p.position.x, p.position.y, p.position.z, p.normal.x, p.normal.y, p.normal.z, p.support,
                        p.colour, p.mask) < std::tie(q.position.x, q.position.y, q.position.z, q.normal.x, q.normal.y,
                                                     q.normal.z, q.support, q.colour, q.mask);
    };
    std::vector<surfel::Surfel> x = a.tree().surfels().items, y = b.tree().surfels().items, out;
    std::sort(x.begin(), x.end(), less);
    std::sort(y.begin(), y.end(), less);
    std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(out), less);
    return out;
}

} // namespace test
