#include "core/selection/affine.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/selection/slope.h"
#include "core/surfel/shape.h"

#include <atomic>

namespace selection {

using base::Mat3d, base::Vec3d;
using surfel::SurfelBlock;
using tree::SurfelTree;

bool Affine::isNothing() const {
    bool same = shift == Vec3d();
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            same &= linear[r][c] == (r == c ? 1 : 0);
    return same;
}

Affine Affine::stretching(const Vec3d& by) {
    return {{{{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}}}, {}};
}

Affine Affine::turning(const Vec3d& axis, double angleRad) { // Rodrigues' formula
    const Vec3d a = normalized(axis);
    const double c = std::cos(angleRad), s = std::sin(angleRad);
    Mat3d out = base::outer(a, a) * (1 - c) + Mat3d::identity() * c;
    out += Mat3d{{{0, -s * a.z, s * a.y}, {s * a.z, 0, -s * a.x}, {-s * a.y, s * a.x, 0}}};
    return {out, {}};
}

Affine Affine::mirroring(const base::Plane& plane) {
    return {Mat3d::identity() - base::outer(plane.normal, plane.normal) * 2.0, plane.normal * (2 * plane.offset)};
}

namespace {

/// Part of a support that rounding may move a surfel by.
constexpr double roundingPart = 0.01;

/// False where the surfel would lose its place or its support.
bool moveSurfel(SurfelBlock& block, int slot, const Affine& map, double weight, const Vec3d& slope, bool curve,
                int shape) {
    const Vec3d x = base::cast<double>(block.position(slot)), n = base::cast<double>(block.normal(slot));
    const Vec3d by = map(x) - x, next = x + by * weight;
    const Mat3d f = Mat3d::identity() + (map.linear - Mat3d::identity()) * weight + base::outer(by, slope);
    const Vec3d m = curve ? f * n : base::cofactor(f) * n; // of a curve, n is the tangent
    const double stretch = lengthSq(n) > 0 ? length(m) : std::cbrt(std::pow(base::determinant(f), 2));
    const double h = static_cast<double>(block.support(slot));
    double support = std::abs(stretch - 1) < 1e-6 ? h : h * (curve ? stretch : std::sqrt(stretch));
    block.setPosition(slot, base::cast<float>(next));
    if (length(m) > 0 && lengthSq(n) > 0 && m != n)
        block.setNormal(slot, base::cast<float>(normalized(!curve && base::determinant(f) < 0 ? -m : m)));
    if (const base::Vec3f b = surfel::shapeOf(block, slot, shape); lengthSq(b) > 0 && lengthSq(n) > 0) {
        const surfel::Ellipse moved =
            surfel::deformed({static_cast<float>(h), b}, base::cast<float>(n), f, block.normal(slot));
        support = double(moved.radius);
        surfel::setShape(block, slot, shape, moved.shape);
    }
    block.channel(slot / surfel::clusterSize, surfel::Support)[slot % surfel::clusterSize] =
        static_cast<float>(support);
    const double reach = std::max({std::abs(next.x), std::abs(next.y), std::abs(next.z)});
    return support >= 1e-30 && support < 1e15 && reach < 1e15 && reach * 0x1p-24 <= roundingPart * support;
}

void requireRegular(const Affine& map) {
    const Mat3d& a = map.linear;
    double most = 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            most = std::max(most, std::abs(a[r][c]));
    if (!(std::abs(base::determinant(a)) > 1e-9 * most * most * most) || !std::isfinite(most))
        throw base::Error("the model would be pressed flat", {}, "scale by numbers that are not zero");
}

void requirePlaces(bool kept) {
    if (!kept)
        throw base::Error("the points would lie so far from the model's origin that they could not keep their places",
                          {}, "move or scale by less");
}

} // namespace

surface::Surface transformed(const surface::Surface& surface, const Affine& map, Limit limit) {
    requireRegular(map);
    if (map.isNothing())
        return surface;
    const SurfelTree& tree = surface.tree();
    const int channel = channelOf(*tree.layout(), Field::Selection);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    std::vector<surfel::BlockPtr> changed(blocks.size());
    std::atomic<bool> kept = true;
    const bool curve = surface.definition().manifold == surface::Manifold::Curve;
    const int shape = surfel::shapeChannel(*tree.layout());
    base::parallelFor(blocks.size(), 8, [&](std::size_t b) {
        const SurfelBlock& block = *blocks[b];
        surfel::MutableBlockPtr copy;
        for (int slot = 0; slot < block.size(); ++slot) {
            const double weight = weightUnder(limit, block, channel, slot);
            if (weight == 0)
                continue;
            if (!copy)
                copy = block.clone();
            const Vec3d slope = weight < 1 ? slopeAt(tree, channel, block, slot) : Vec3d();
            if (!moveSurfel(*copy, slot, map, weight, slope, curve, shape))
                kept = false;
        }
        if (copy) {
            copy->seal();
            changed[b] = copy;
        }
    });
    requirePlaces(kept);
    tree::Edit edit;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (changed[b])
            edit.blocks.push_back({static_cast<std::uint32_t>(b), std::move(changed[b]), {}});
    surface::SurfaceDefinition definition = surface.definition();
    if (limit == Limit::Everything && definition.support > 0) // one radius for all: it is scaled as they are
        definition.support *= static_cast<float>(std::cbrt(std::abs(base::determinant(map.linear))));
    return {tree.apply(edit), definition};
}

surface::Surface duplicated(const surface::Surface& surface, const Affine& map) {
    requireRegular(map);
    if (map.isNothing())
        throw base::Error("the copy would lie upon what it is a copy of", {}, "say how far to move it");
    const SurfelTree& tree = surface.tree();
    const int channel = channelOf(*tree.layout(), Field::Selection);
    const tree::Selection part = selectedIn(tree);
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    std::vector<std::uint32_t> words(tree.layout()->words());
    bool kept = true;
    const bool curve = surface.definition().manifold == surface::Manifold::Curve;
    const int shape = surfel::shapeChannel(*tree.layout());
    for (const tree::SelectedBlock& each : part) {
        const surfel::MutableBlockPtr moved = blocks[each.block]->clone(), left = blocks[each.block]->clone();
        for (int slot = 0; slot < moved->size(); ++slot) {
            if (!each.slots[static_cast<std::size_t>(slot)])
                continue;
            kept &= moveSurfel(*moved, slot, map, 1, {}, curve, shape);
            moved->extra(slot, words);
            edit.inserted.append(moved->surfel(slot), words);
            left->channel(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize] = 0;
        }
        edit.blocks.push_back({each.block, left, {}});
    }
    requirePlaces(kept);
    return {tree.apply(edit), surface.definition()};
}

base::Box3f boxUnder(const SurfelTree& tree, Limit limit) {
    if (limit == Limit::Everything)
        return tree.bounds();
    const std::vector<const SurfelBlock*> blocks = blocksOf(tree);
    base::Box3f out;
    for (const tree::SelectedBlock& each : selectedIn(tree))
        for (int slot = 0; slot < blocks[each.block]->size(); ++slot)
            if (each.slots[static_cast<std::size_t>(slot)])
                out.extend(blocks[each.block]->position(slot));
    return out;
}

} // namespace selection
