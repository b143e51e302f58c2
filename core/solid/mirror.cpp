#include "core/solid/mirror.h"

#include "core/base/error.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/resampling/resample.h"
#include "core/surfel/shape.h"

namespace solid {

using base::Vec3d;

namespace {

/// Surfels nearer to the plane than this part of their spacing come to lie on it: they would stand too close to their
/// own images.
constexpr double snapped = 0.35;

surfel::SurfelList doubled(const surfel::SurfelList& half, const base::Plane& plane) {
    surfel::SurfelList out;
    out.layout = half.layout;
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < half.size(); ++i) {
        surfel::Surfel s = half.items[i];
        const Vec3d p = base::cast<double>(s.position), n = base::cast<double>(s.normal);
        const double height = plane.distance(p);
        const double spacing = static_cast<double>(s.support) * surface::spacingOfUnit;
        if (height < snapped * spacing) {
            const Vec3d flat = normalized(n - plane.normal * dot(plane.normal, n));
            if (flat == Vec3d{}) // it faces along the plane's normal: its image faces against it
                continue;
            s.position = base::cast<float>(p - plane.normal * height);
            s.normal = base::cast<float>(n == Vec3d{} ? n : flat);
            words.assign(half.extraOf(i).begin(), half.extraOf(i).end());
            surfel::becomeBall(*half.layout, s, words); // an ellipse aslant is not its own image
            out.append(s, words);
            continue;
        }
        out.append(s, half.extraOf(i));
        s.position = base::cast<float>(p - plane.normal * (2 * height));
        s.normal = base::cast<float>(n - plane.normal * (2 * dot(plane.normal, n)));
        out.append(s, half.extraOf(i));
        surfel::mapShapes(out, out.size() - 1, [&](const base::Vec3f& b) {
            const Vec3d was = base::cast<double>(b);
            return base::cast<float>(was - plane.normal * (2 * dot(plane.normal, was)));
        });
    }
    return out;
}

/// The surfels above the plane, or on it as far as rounding can tell.
surfel::SurfelList above(const tree::SurfelTree& tree, const base::Plane& plane) {
    const surfel::SurfelList all = tree.surfels();
    surfel::SurfelList out;
    out.layout = all.layout;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (plane.distance(base::cast<double>(all.items[i].position)) >
            -1e-3 * static_cast<double>(all.items[i].support))
            out.append(all.items[i], all.extraOf(i));
    return out;
}

tree::Selection beside(const tree::SurfelTree& tree, const base::Plane& plane) {
    tree::Selection out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::SelectedBlock selected{number, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            selected.slots[static_cast<std::size_t>(slot)] =
                std::abs(plane.distance(base::cast<double>(block.position(slot)))) <
                static_cast<double>(block.support(slot));
        if (selected.slots.any())
            out.push_back(selected);
    });
    return out;
}

} // namespace

surface::Surface mirrored(const surface::Surface& model, const base::Plane& plane, const base::Progress& progress,
                          const std::function<surfel::SurfelList(surfel::SurfelList half)>& settled) {
    progress.step(0, "Mirroring");
    surfel::SurfelList half = above(model.tree(), plane);
    if (half.size() < 4)
        throw base::Error("nothing lies on that side of the plane", "mirror", "move the plane, or keep the other side");
    surface::SurfaceDefinition definition = model.definition();
    surface::Surface whole(tree::SurfelTree::build(doubled(half, plane)), definition);
    progress.step(0.5, "Welding");
    const tree::Selection seam = beside(whole.tree(), plane);
    if (!seam.empty()) { // the way the halves meet is evened out, then made symmetric again
        process::ResampleOptions options;
        for (const tree::SelectedBlock& selected : seam)
            options.spacing = std::max(options.spacing, whole.tree().block(selected.block)->maxSupport());
        const auto ratio = static_cast<float>(surface::spacingOfUnit);
        options.spacing *= ratio;
        options.targetOf = [ratio](const surfel::SurfelBlock& block, int slot) { return block.support(slot) * ratio; };
        const tree::SurfelTree even = whole.tree().apply(process::resample(whole, seam, options));
        half = above(even, plane);
    }
    if (settled)
        half = settled(std::move(half));
    if (settled || !seam.empty())
        whole = {tree::SurfelTree::build(doubled(half, plane)), definition};
    if (definition.boundary == surface::Boundary::Auto)
        whole = process::withOwnLimit(whole.tree(), definition);
    progress.step(1, "Welding");
    return whole;
}

} // namespace solid
