#include "core/solid/loops/patch_surfels.h"

#include "core/base/parallel.h"
#include "core/process/resampling/resample.h"
#include "core/solid/loops/shape_patch.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>

namespace solid {

using base::Vec3d;
using base::Vec3f;

int halvingsFor(double area, double spacing) {
    constexpr double most = 8000;
    return std::max(0, static_cast<int>(std::ceil(std::log(area / (spacing * spacing) / most) / std::log(4.0))));
}

namespace {

/// What surfels carry at the loop's points.
struct Carried {
    std::vector<std::vector<double>> numbers; ///< support and channels of the colour
    std::vector<std::uint32_t> words;         ///< layout->words() each
};

Carried carriedAt(const surface::Surface& surface, const Loop& loop) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    Carried out{{}, std::vector<std::uint32_t>(loop.size() * layout.words(), 0)};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        surface::AttributeSum sum(layout);
        surface::forWeights(
            surface, base::cast<float>(loop.points[i].position),
            [&](const surfel::SurfelBlock& block, int slot, float theta) { sum.add(block, slot, theta); });
        const surfel::Colour colour = sum.any() ? sum.colour() : surfel::white;
        std::vector<double> numbers{loop.points[i].support};
        for (unsigned shift = 0; shift < 32; shift += 8)
            numbers.push_back(static_cast<double>(colour >> shift & 255u));
        out.numbers.push_back(std::move(numbers));
        if (sum.any() && layout.words() > 0)
            sum.further({out.words.data() + i * layout.words(), layout.words()});
    }
    return out;
}

/// At the places of a cap the loop's colours by 1 / d^4, and which of its points is nearest.
struct Blended {
    surfel::Colour colour = 0;
    std::size_t nearest = 0;

    Blended(const Loop& loop, const Carried& carried, const Vec3d& x) {
        double sums[4] = {}, weights = 0, least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const double sq = distanceSq(loop.points[i].position, x), weight = 1 / (sq * sq + 1e-300);
            if (sq < least)
                least = sq, nearest = i;
            weights += weight;
            for (std::size_t k = 0; k < 4; ++k)
                sums[k] += weight * carried.numbers[i][k + 1];
        }
        for (std::size_t k = 0; k < 4; ++k)
            colour |= static_cast<unsigned>(std::clamp(std::lround(sums[k] / weights), 0L, 255L)) << 8 * k;
    }
};

/// Stands there already a surfel that faces the same way?
bool taken(const tree::SurfelTree& tree, const Vec3d& p, const Vec3d& normal, double within, bool oriented) {
    const Vec3f x = base::cast<float>(p);
    std::vector<tree::Neighbour> near;
    tree.nearest(x, 4, near, static_cast<float>(within));
    return std::any_of(near.begin(), near.end(), [&](const tree::Neighbour& each) {
        const double agreement = dot(base::cast<double>(each.block->normal(each.slot)), normal);
        return !oriented || agreement > 0.17; // one sheet: process/README 4.1
    });
}

/// Of each vertex after `halvings` one of those before it that it lies beside.
std::vector<std::uint32_t> sources(Patch patch, int halvings) {
    std::vector<std::uint32_t> out(patch.positions.size());
    for (std::uint32_t v = 0; v < out.size(); ++v)
        out[v] = v;
    for (int level = 0; level < halvings; ++level) {
        const std::vector<mesh::Triangle> coarse = patch.triangles;
        std::vector<Vec3d> unused(patch.positions.size());
        halveEdges(patch, unused, 1);
        out.resize(patch.positions.size(), 0);
        for (std::size_t t = 0; t < coarse.size(); ++t) // the triangle in the middle comes last of four
            for (std::size_t k = 0; k < 3; ++k)
                out[patch.triangles[4 * t + 3][k]] = out[coarse[t][k]];
    }
    return out;
}

} // namespace

PatchSurfels::PatchSurfels(const surface::Surface& surface) : m_surface(surface) {
    m_out.layout = surface.tree().layout();
    m_oriented = m_out.layout->normals && m_out.layout->oriented;
}

std::size_t PatchSurfels::add(const Loop& loop, const Patch& patch, int halvings, const Patch& fine,
                              std::span<const Vec3d> normals) {
    const Carried carried = carriedAt(m_surface, loop);
    const std::vector<std::vector<double>> numbers = spreadOver(patch, carried.numbers);
    const std::vector<std::uint32_t> nearest = nearestOfLoop(patch), from = sources(patch, halvings);
    const std::size_t words = m_out.layout->words(), before = m_out.size();
    for (std::size_t v = 0; v < fine.positions.size(); ++v) {
        if (taken(m_surface.tree(), fine.positions[v], normals[v], 0.65 * fine.spacings[v], m_oriented))
            continue;
        const std::vector<double>& number = numbers[from[v]];
        surfel::Surfel s;
        s.position = base::cast<float>(fine.positions[v]);
        s.normal = base::cast<float>(m_out.layout->normals ? normals[v] : Vec3d{});
        s.support = static_cast<float>(number[0]);
        s.colour = 0;
        for (unsigned k = 0; k < 4; ++k)
            s.colour |= static_cast<unsigned>(std::clamp(std::lround(number[k + 1]), 0L, 255L)) << 8 * k;
        m_out.append(s, {carried.words.data() + nearest[from[v]] * words, words});
    }
    return m_out.size() - before;
}

void PatchSurfels::addCap(const PlaneCap& cap, bool turned) {
    const Carried carried = carriedAt(m_surface, cap.loop);
    const std::size_t words = m_out.layout->words(), count = cap.patch.positions.size();
    const Vec3d normal = cap.pose.turn * Vec3d{0, 0, turned ? -1.0 : 1.0};
    std::vector<surfel::Surfel> made(count);
    std::vector<std::size_t> nearest(count);
    // each of them looks at all of the loop: that is most of the work where it is long
    base::parallelFor(count, 64, [&](std::size_t v) {
        const Blended blended(cap.loop, carried, cap.patch.positions[v]);
        made[v].position = base::cast<float>(cap.patch.positions[v]);
        made[v].normal = base::cast<float>(normal);
        made[v].support = process::supportOf(m_surface.definition(), static_cast<float>(cap.patch.spacings[v]));
        made[v].colour = blended.colour;
        nearest[v] = blended.nearest;
    });
    for (std::size_t v = 0; v < count; ++v)
        m_out.append(made[v], {carried.words.data() + nearest[v] * words, words});
}

surface::Surface withSurfels(const surface::Surface& surface, const surfel::SurfelList& more) {
    if (more.size() == 0)
        return surface;
    tree::Edit edit;
    edit.inserted = more;
    return {surface.tree().apply(edit), surface.definition()};
}

} // namespace solid
