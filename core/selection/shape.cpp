#include "core/selection/shape.h"

#include "core/base/error.h"
#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/selection/slope.h"
#include "core/surface/curvature.h"
#include "core/surface/projection/project.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <atomic>

namespace selection {

using base::Mat3d, base::Vec3d, base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Part of a support that rounding may move a surfel by.
constexpr double roundingPart = 0.01;
/// Supports follow the area by at most this factor either way: beyond, the surface folds.
constexpr double mostStretch = 16;

/// Blocks of a version and how much of a change their surfels get.
struct Weighed {
    Weighed(const surface::Surface& surface, Limit under)
        : blocks(blocksOf(surface.tree())), limit(under),
          channel(channelOf(*surface.tree().layout(), Field::Selection)),
          hidden(channelOf(*surface.tree().layout(), Field::Hidden)), masks(surface.tree().layout()->masks) {}

    double free(const SurfelBlock& block, int slot) const {
        if (valueAt(block, hidden, slot) >= half)
            return 0;
        return masks ? 1 - std::clamp(static_cast<double>(block.mask(slot)), 0.0, 1.0) : 1;
    }
    double at(const SurfelBlock& block, int slot) const {
        return weightUnder(limit, block, channel, slot) * free(block, slot);
    }
    /// Of `at`, where it varies.
    Vec3d slope(const tree::SurfelTree& tree, const SurfelBlock& block, int slot) const {
        const double w = weightUnder(limit, block, channel, slot), m = free(block, slot);
        Vec3d out;
        if (limit == Limit::Selection && w > 0 && w < 1)
            out += slopeAt(tree, channel, block, slot) * m;
        if (masks && m > 0 && m < 1)
            out -= slopeAt(tree, surfel::Mask, block, slot) * w;
        return out;
    }

    std::vector<const SurfelBlock*> blocks;
    Limit limit;
    int channel, hidden;
    bool masks;
};

/// fn(block, slots, copy) for all blocks with surfels to change; the copies make the new version.
template <class Fn>
surface::Surface changedBlocks(const surface::Surface& surface, const Weighed& weighed, const base::Progress& progress,
                               const char* what, const Fn& fn) {
    const std::size_t count = weighed.blocks.size(), slab = 256;
    std::vector<surfel::BlockPtr> changed(count);
    for (std::size_t from = 0; from < count; from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(count), what);
        base::parallelFor(std::min(slab, count - from), 4, [&](std::size_t i) {
            const SurfelBlock& block = *weighed.blocks[from + i];
            std::vector<int> slots;
            for (int slot = 0; slot < block.size(); ++slot)
                if (weighed.at(block, slot) > 0)
                    slots.push_back(slot);
            if (slots.empty())
                return;
            surfel::MutableBlockPtr copy = block.clone();
            fn(block, slots, *copy);
            copy->seal();
            changed[from + i] = copy;
        });
    }
    tree::Edit edit;
    for (std::size_t b = 0; b < count; ++b)
        if (changed[b])
            edit.blocks.push_back({static_cast<std::uint32_t>(b), std::move(changed[b]), {}});
    return {surface.tree().apply(edit), surface.definition()};
}

std::vector<Vec3f> placesOf(const SurfelBlock& block, const std::vector<int>& slots) {
    std::vector<Vec3f> out;
    for (const int slot : slots)
        out.push_back(block.position(slot));
    return out;
}

} // namespace

surface::Surface smoothed(const surface::Surface& surface, double scale, double amount, Limit limit,
                          const base::Progress& progress) {
    const Weighed weighed(surface, limit);
    const surface::Surface wide = surface.withSupportScale(static_cast<float>(scale));
    surface::ProjectOptions options;
    options.checkBoundary = false;
    return changedBlocks(
        surface, weighed, progress, amount > 0 ? "Smoothing" : "Sharpening",
        [&](const SurfelBlock& block, const std::vector<int>& slots, SurfelBlock& copy) {
            const std::vector<Vec3f> x = placesOf(block, slots);
            std::vector<surface::Projection<float>> feet(x.size());
            surface::project(wide, x, options, feet);
            for (std::size_t i = 0; i < x.size(); ++i) {
                const int slot = slots[i];
                const Vec3f step = feet[i].foot - x[i], n = block.normal(slot);
                if (!feet[i].ok() || !(length(step) < block.support(slot))) // no foot, or that of another sheet
                    continue;
                const auto part = static_cast<float>(amount * weighed.at(block, slot));
                const Vec3f g = normalized(feet[i].at.gradient, n), m = dot(g, n) < 0 ? -g : g;
                copy.setPosition(slot, x[i] + step * part);
                if (lengthSq(n) > 0)
                    copy.setNormal(slot, base::cast<float>(normalized(base::cast<double>(n + (m - n) * part),
                                                                      base::cast<double>(n))));
            }
        });
}

surface::Surface raised(const surface::Surface& surface, const std::function<Height(const Vec3d&)>& height, Limit limit,
                        const base::Progress& progress) {
    if (!surface.tree().layout()->oriented)
        throw base::Error("the normals have no sides, which tell outwards from inwards", {}, "orient them first");
    const Weighed weighed(surface, limit);
    std::atomic<bool> kept = true;
    const int shape = surfel::shapeChannel(*surface.tree().layout());
    surface::Surface out = changedBlocks(
        surface, weighed, progress, "Raising the surface",
        [&](const SurfelBlock& block, const std::vector<int>& slots, SurfelBlock& copy) {
            const std::vector<Vec3f> x = placesOf(block, slots);
            std::vector<surface::Curvature> bent(x.size());
            surface::curvature(surface, x, bent);
            for (std::size_t i = 0; i < x.size(); ++i) {
                const int slot = slots[i];
                const Vec3d p = base::cast<double>(x[i]), n = base::cast<double>(block.normal(slot));
                const double w = weighed.at(block, slot);
                const Height up = height(p);
                const Vec3d next = p + n * (w * up.value);
                if (!(length(next) * 0x1p-24 <= roundingPart * static_cast<double>(block.support(slot))))
                    kept = false;
                copy.setPosition(slot, base::cast<float>(next));
                Mat3d f = Mat3d::identity(); // of x + w height n: grad n is the shape operator
                if (const surface::Curvature& c = bent[i]; c.ok()) {
                    const double side = (dot(c.normal, n) < 0 ? -w : w) * up.value;
                    f += base::outer(c.direction1, c.direction1) * (side * c.k1);
                    f += base::outer(c.direction2, c.direction2) * (side * c.k2);
                }
                f += base::outer(n, up.slope * w + weighed.slope(surface.tree(), block, slot) * up.value);
                const Vec3d m = base::cofactor(f) * n;
                if (!(dot(m, n) > 0)) // folded: the old normal is as good as any
                    continue;
                copy.setNormal(slot, base::cast<float>(normalized(m)));
                const double stretch = std::clamp(length(m), 1 / mostStretch, mostStretch);
                const float old = block.support(slot);
                float& support = copy.channel(slot / surfel::clusterSize, surfel::Support)[slot % surfel::clusterSize];
                support = static_cast<float>(static_cast<double>(old) * std::sqrt(stretch));
                if (const base::Vec3f b = surfel::shapeOf(block, slot, shape); lengthSq(b) > 0) {
                    const surfel::Ellipse to = surfel::deformed({old, b}, block.normal(slot), f, copy.normal(slot));
                    support = std::clamp(to.radius, support / 2, support * 2);
                    surfel::setShape(copy, slot, shape, to.shape);
                }
            }
        });
    if (!kept)
        throw base::Error("the points would lie so far from the model's origin that they could not keep their places",
                          {}, "raise it by less");
    return out;
}

Height noiseAt(const Vec3d& x, double size, std::uint64_t seed) {
    const Vec3d u = x / size;
    if (!(length(u) < 1e15)) // beyond what a double tells apart
        return {};
    double cell[3], t[3], fade[3], rise[3];
    for (std::size_t k = 0; k < 3; ++k) {
        cell[k] = std::floor(u[k]);
        const double s = t[k] = u[k] - cell[k];
        fade[k] = s * s * s * (s * (6 * s - 15) + 10);
        rise[k] = 30 * s * s * (s - 1) * (s - 1);
    }
    Height out;
    for (int corner = 0; corner < 8; ++corner) {
        std::uint64_t hash = base::mix(seed);
        Vec3d from;
        double w[3], dw[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const bool high = corner >> k & 1;
            hash = base::mix(hash ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[k]) + (high ? 1 : 0)));
            from[k] = t[k] - (high ? 1 : 0);
            w[k] = high ? fade[k] : 1 - fade[k];
            dw[k] = high ? rise[k] : -rise[k];
        }
        const Vec3d direction = base::Random(hash).unitVector();
        const double value = dot(direction, from), weight = w[0] * w[1] * w[2];
        out.value += weight * value;
        out.slope += direction * weight + Vec3d{dw[0] * w[1] * w[2], w[0] * dw[1] * w[2], w[0] * w[1] * dw[2]} * value;
    }
    out.slope = out.slope / size;
    return out;
}

} // namespace selection
