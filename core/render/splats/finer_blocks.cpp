#include "core/render/splats/finer_blocks.h"

#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "core/render/splats/boundary_cuts.h"
#include "core/surface/projection/project.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// A disc in the middle and six about it cover all of the disc they stand for but for a fiftieth of its radius.
constexpr int discsFor = 7;
constexpr float finerRadius = 0.6f, ringRadius = 0.75f;
/// A foot farther off than this part of the radius is on another sheet.
constexpr float nearFoot = 1;
/// A disc stands out as far as this part of its neighbours lie below it: one normal gone wrong tells nothing.
constexpr std::size_t tellingPart = 4;
/// And a block as far as this many of its discs do.
constexpr std::size_t tellingDiscs = 4;
constexpr std::size_t leastNeighbours = 4;

/// How far a disc stands out where its surface bends as it does towards a neighbour: d^2 / 2 rho, for d what it reaches
/// in that direction.
float standOutOver(const Vec3f& way, const Vec3f& normal, const Vec3f& shape, float radius) {
    return std::abs(dot(way, normal)) * radius * radius / surfel::shapedSq(way, shape);
}

float standOutOf(const SurfelBlock& block, float radiusOfSupport, int shape) {
    std::vector<float> discs, around;
    for (int i = 0; i < block.size(); ++i) {
        const Vec3f p = block.position(i), n = block.normal(i), b = surfel::shapeOf(block, i, shape);
        const float radius = radiusOfSupport * block.support(i);
        around.clear();
        for (int j = 0; j < block.size(); ++j) {
            const Vec3f way = block.position(j) - p;
            const float apart = lengthSq(way);
            if (apart > 0.25f * radius * radius && apart < 2.25f * radius * radius)
                around.push_back(standOutOver(way, n, b, radius));
        }
        if (around.size() < leastNeighbours)
            continue;
        const auto telling = around.begin() + static_cast<std::ptrdiff_t>(around.size() / tellingPart);
        std::nth_element(around.begin(), telling, around.end(), std::greater<>());
        discs.push_back(std::min(*telling, radius));
    }
    if (discs.size() < tellingDiscs)
        return 0;
    std::nth_element(discs.begin(), discs.begin() + (tellingDiscs - 1), discs.end(), std::greater<>());
    return discs[tellingDiscs - 1];
}

/// What is drawn: a disc, or an ellipse.
struct Disc {
    surfel::Surfel surfel;
    Vec3f shape;
};

/// The finer discs of one in its own plane, the six about it at a part of its radius.
std::array<Disc, discsFor> spread(const Disc& of, float radius, float ring) {
    std::array<Disc, discsFor> out;
    const Vec3f n = of.surfel.normal;
    const Vec3f u = discAxis(n), v = cross(n, u);
    const Vec3f along = normalized(of.shape - n * dot(of.shape, n), Vec3f{});
    const float narrower = 1 - 1 / surfel::aspectOf(of.shape);
    for (int k = 0; k < discsFor; ++k) {
        Disc& each = out[static_cast<std::size_t>(k)] = of;
        each.surfel.support *= finerRadius;
        if (k == 0)
            continue;
        const float angle = static_cast<float>(k) * (std::numbers::pi_v<float> / 3);
        const Vec3f way = (u * std::cos(angle) + v * std::sin(angle)) * (ring * radius);
        each.surfel.position += way - along * (dot(along, way) * narrower);
    }
    return out;
}

/// Brings a disc to its foot. False where there is none near by: the surface has ended before, or is another sheet.
bool settle(surfel::Surfel& disc, const surface::Projection<float>& foot, float radius) {
    if (!foot.ok() || distance(foot.foot, disc.position) > nearFoot * radius)
        return false;
    const Vec3f n = normalized(foot.at.gradient, disc.normal);
    disc.position = foot.foot;
    disc.normal = dot(n, disc.normal) < 0 ? -n : n;
    return true;
}

/// All finer discs of a block, surfel by surfel. Where the surface has no foot it is looked for half as far away; a
/// surfel that has none at all stays as it is.
std::vector<Disc> finerOf(const surface::Surface& surface, const SurfelBlock& block, float radiusOfSupport) {
    constexpr surface::ProjectOptions options{.projector = surface::Projector::Almost};
    const int shape = surfel::shapeChannel(*surface.tree().layout());
    const auto discOf = [&](int i) { return Disc{block.surfel(i), surfel::shapeOf(block, i, shape)}; };
    const auto radiusOf = [&](int i) { return radiusOfSupport * block.support(i); };
    std::vector<Vec3f> places;
    for (int i = 0; i < block.size(); ++i)
        for (const Disc& each : spread(discOf(i), radiusOf(i), ringRadius))
            places.push_back(each.surfel.position);
    std::vector<surface::Projection<float>> feet(places.size());
    surface::project(surface, places, options, feet);
    std::vector<Disc> out;
    for (int i = 0; i < block.size(); ++i) {
        const float radius = radiusOf(i);
        const auto far = spread(discOf(i), radius, ringRadius), half = spread(discOf(i), radius, ringRadius / 2);
        const std::size_t before = out.size();
        for (std::size_t k = 0; k < discsFor; ++k) {
            Disc disc = far[k];
            bool settled = settle(disc.surfel, feet[static_cast<std::size_t>(i) * discsFor + k], radius);
            if (!settled && k > 0) {
                disc = half[k];
                settled = settle(disc.surfel, surface::project(surface, disc.surfel.position, options), radius);
            }
            if (settled)
                out.push_back(disc);
        }
        if (out.size() == before)
            out.push_back(discOf(i));
    }
    return out;
}

/// With the layout of the model's blocks where supports have shapes, else without further attributes.
surfel::BlockPtr blockOf(std::span<const Disc> discs, const surfel::AttributeLayout& layout) {
    const int shape = surfel::shapeChannel(layout);
    const surfel::MutableBlockPtr out =
        SurfelBlock::create(static_cast<int>(discs.size()), shape > 0 ? layout.words() : 0);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        out->set(static_cast<int>(i), discs[i].surfel);
        if (shape > 0)
            surfel::setShape(*out, static_cast<int>(i), shape, discs[i].shape);
    }
    out->seal();
    return out;
}

} // namespace

bool FinerBlocks::any(const tree::SurfelTree& model, const RenderOptions& options) {
    const surfel::AttributeLayout& layout = *model.layout();
    return options.definition.manifold == surface::Manifold::Surface && options.detailPx <= 1 && !options.colours &&
           layout.normals && !cells::LabelLayout::of(layout) && !layout.find("patch");
}

void FinerBlocks::use(const surface::SurfaceDefinition& definition, float radiusOfSupport) {
    if (definition == m_definition && radiusOfSupport == m_radiusOfSupport)
        return;
    for (auto& [block, kept] : m_kept)
        drop(kept);
    m_kept.clear();
    m_definition = definition;
    m_radiusOfSupport = radiusOfSupport;
}

std::vector<float> FinerBlocks::standOut(std::span<const SurfelBlock* const> blocks) {
    std::vector<const SurfelBlock*> fresh;
    for (const SurfelBlock* block : blocks)
        if (!m_kept.contains(block))
            fresh.push_back(block);
    std::vector<float> found(fresh.size());
    const int shape = m_model.layout() ? surfel::shapeChannel(*m_model.layout()) : 0;
    base::parallelFor(fresh.size(), 4,
                      [&](std::size_t i) { found[i] = standOutOf(*fresh[i], m_radiusOfSupport, shape); });
    for (std::size_t i = 0; i < fresh.size(); ++i)
        m_kept.try_emplace(fresh[i], Kept{surfel::BlockPtr(fresh[i]), found[i], {}});
    std::vector<float> out;
    for (const SurfelBlock* block : blocks)
        out.push_back(m_kept.at(block).standOut);
    return out;
}

void FinerBlocks::prepare(std::span<const SurfelBlock* const> blocks) {
    std::vector<Kept*> fresh;
    for (const SurfelBlock* block : blocks)
        if (Kept& kept = m_kept.at(block); kept.parts.empty())
            fresh.push_back(&kept);
    if (fresh.empty())
        return;
    const surface::Surface surface(m_model, m_definition);
    std::optional<BoundarySubject> bounded;
    if (std::isfinite(m_definition.boundaryLimit))
        bounded.emplace(m_model, m_definition, m_radiusOfSupport);
    base::parallelFor(fresh.size(), 1, [&](std::size_t b) {
        const SurfelBlock& block = *fresh[b]->block;
        const std::vector<Disc> kept = finerOf(surface, block, m_radiusOfSupport);
        std::optional<BoundaryCuts> boundary;
        if (bounded)
            boundary.emplace(*bounded);
        for (std::size_t first = 0; first < kept.size(); first += surfel::blockCapacity) {
            const auto size = std::min<std::size_t>(surfel::blockCapacity, kept.size() - first);
            Part part{blockOf(std::span(kept).subspan(first, size), *m_model.layout()), nullptr};
            CutCodes codes{};
            if (boundary && boundary->cut(*part.block, codes))
                part.cuts = std::make_unique<CutCodes>(codes);
            fresh[b]->parts.push_back(std::move(part));
        }
    });
}

void FinerBlocks::drop(Kept& kept) {
    for (Part& part : kept.parts)
        m_dropped.push_back(std::move(part.block));
    kept.parts.clear();
}

std::vector<const SurfelBlock*> FinerBlocks::follow(const tree::SurfelTree& to) {
    std::vector<const SurfelBlock*> changed;
    const tree::SurfelTree from = std::exchange(m_model, to);
    if (from == to || m_kept.empty())
        return changed;
    const tree::Diff diff = tree::diff(from, to);
    for (const surfel::BlockPtr& block : diff.removed)
        if (const auto found = m_kept.find(block.get()); found != m_kept.end()) {
            drop(found->second);
            m_kept.erase(found);
        }
    forBlocksBeside(diff, to, m_radiusOfSupport, [&](const SurfelBlock& each) {
        const auto found = m_kept.find(&each);
        if (found == m_kept.end() || found->second.parts.empty())
            return;
        drop(found->second);
        changed.push_back(&each);
    });
    return changed;
}

} // namespace render
