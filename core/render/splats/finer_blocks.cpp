#include "core/render/splats/finer_blocks.h"

#include "core/base/parallel.h"
#include "core/render/splats/boundary_cuts.h"
#include "core/render/splats/finer_in_cells.h"
#include "core/render/splats/label_cuts.h"
#include "core/render/splats/off_surface.h"
#include "core/render/splats/sharp_cuts.h"
#include "core/render/splats/stand_out.h"
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

/// What is drawn: a disc, or an ellipse.
struct Disc {
    surfel::Surfel surfel;
    Vec3f shape;
    CutCode code = wholeDisc;
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

/// Makes finer discs, block by block. A worker of one thread.
class Finer {
  public:
    Finer(const surface::Surface& surface, const cells::CellSurface* cells, float radiusOfSupport)
        : m_surface(surface), m_radius(radiusOfSupport), m_shape(surfel::shapeChannel(*surface.tree().layout())),
          m_labels(cells ? &cells->labels() : nullptr) {
        if (cells)
            m_cells.emplace(*cells, radiusOfSupport);
    }

    /// All of a block, surfel by surfel. Where the surface has no foot it is looked for half as far away; a surfel that
    /// has none at all stays as it is.
    std::vector<Disc> of(const SurfelBlock& block) {
        std::vector<Vec3f> places;
        for (int i = 0; i < block.size(); ++i)
            for (const Disc& each : spread(discOf(block, i), radiusOf(block, i), ringRadius))
                places.push_back(each.surfel.position);
        std::vector<surface::Projection<float>> feet(places.size());
        surface::project(m_surface, places, projector, feet);
        std::vector<Disc> out;
        CutCodes own{};
        bool cut = false;
        for (int i = 0; i < block.size(); ++i) {
            const float radius = radiusOf(block, i);
            const auto far = spread(discOf(block, i), radius, ringRadius);
            const auto half = spread(discOf(block, i), radius, ringRadius / 2);
            const std::size_t before = out.size();
            const bool ends =
                m_cells && m_cells->endsWithin(block.position(i), m_labels->cellAt(block, i), spreadReach * radius);
            for (std::size_t k = 0; k < discsFor; ++k) {
                Disc disc = far[k];
                const auto& foot = feet[static_cast<std::size_t>(i) * discsFor + k];
                bool settled = settle(disc, block, i, ends, &foot);
                if (!settled && k > 0) {
                    disc = half[k];
                    settled = settle(disc, block, i, ends, nullptr);
                }
                if (settled)
                    out.push_back(disc);
            }
            if (out.size() > before)
                continue;
            out.push_back(discOf(block, i));
            if (m_labels && !std::exchange(cut, true))
                LabelCuts(m_surface.tree(), *m_labels, m_radius).cut(block, own);
            out.back().code = own[static_cast<std::size_t>(i)];
        }
        return out;
    }

    /// One disc for each surfel, at its foot; without one it stays where it is. Of models without cells.
    std::vector<Disc> settled(const SurfelBlock& block) const {
        std::vector<Vec3f> places;
        for (int i = 0; i < block.size(); ++i)
            places.push_back(block.position(i));
        std::vector<surface::Projection<float>> feet(places.size());
        surface::project(m_surface, places, projector, feet);
        std::vector<Disc> out;
        for (int i = 0; i < block.size(); ++i) {
            out.push_back(discOf(block, i));
            render::settle(out.back().surfel, feet[static_cast<std::size_t>(i)], (finerReach - 1) * radiusOf(block, i));
        }
        return out;
    }

  private:
    static constexpr surface::ProjectOptions projector{.projector = surface::Projector::Almost};

    Disc discOf(const SurfelBlock& block, int i) const { return {block.surfel(i), surfel::shapeOf(block, i, m_shape)}; }
    float radiusOf(const SurfelBlock& block, int i) const { return m_radius * block.support(i); }

    /// `ends`: an edge is near. `foot`: on the smooth surface, where that is known.
    bool settle(Disc& disc, const SurfelBlock& block, int i, bool ends, const surface::Projection<float>* foot) {
        const float radius = radiusOf(block, i);
        if (m_cells && m_cells->concerns(disc.surfel.position)) {
            const std::uint32_t cell = m_labels->cellAt(block, i);
            return ends ? m_cells->settle(disc.surfel, cell, nearFoot * radius, disc.code)
                        : m_cells->place(disc.surfel, cell, nearFoot * radius);
        }
        return render::settle(disc.surfel, foot ? *foot : surface::project(m_surface, disc.surfel.position, projector),
                              radius);
    }

    const surface::Surface& m_surface;
    float m_radius;
    int m_shape;
    const cells::LabelLayout* m_labels; ///< null for models without cells
    std::optional<FinerInCells> m_cells;
};

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
           layout.normals && (cells::LabelLayout::of(layout) || !layout.find("patch"));
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

FinerBlocks::Kept& FinerBlocks::keptOf(const SurfelBlock& block) {
    Kept& out = m_kept[&block];
    if (!out.block)
        out.block = surfel::BlockPtr(&block);
    return out;
}

template <class Measure>
std::vector<float> FinerBlocks::measured(std::span<const SurfelBlock* const> blocks, float Kept::*value,
                                         const Measure& measure) {
    std::vector<Kept*> fresh;
    for (const SurfelBlock* block : blocks)
        if (Kept& kept = keptOf(*block); kept.*value < 0)
            fresh.push_back(&kept);
    base::parallelFor(fresh.size(), 4, [&](std::size_t i) { fresh[i]->*value = measure(*fresh[i]->block); });
    std::vector<float> out;
    for (const SurfelBlock* block : blocks)
        out.push_back(m_kept.at(block).*value);
    return out;
}

std::vector<float> FinerBlocks::standOut(std::span<const SurfelBlock* const> blocks) {
    return measured(blocks, &Kept::standOut,
                    [&](const SurfelBlock& block) { return StandOut(m_model, m_radiusOfSupport).of(block); });
}

std::vector<float> FinerBlocks::offSurface(std::span<const SurfelBlock* const> blocks) {
    if (m_model.empty() || cells::LabelLayout::of(*m_model.layout()))
        return std::vector<float>(blocks.size());
    return measured(blocks, &Kept::offSurface,
                    [&](const SurfelBlock& block) { return render::offSurface(block, m_radiusOfSupport); });
}

void FinerBlocks::prepare(std::span<const Wish> wishes) {
    std::vector<Kept*> fresh;
    for (const Wish& wish : wishes) {
        Kept& kept = m_kept.at(wish.block);
        const bool cut = wish.cut || wish.spread;
        if (!kept.parts.empty() && kept.spread == wish.spread && (kept.cut || !cut))
            continue;
        drop(kept);
        kept.spread = wish.spread, kept.cut = cut;
        fresh.push_back(&kept);
    }
    if (fresh.empty())
        return;
    const surface::Surface surface(m_model, m_definition);
    std::optional<cells::CellSurface> cells;
    if (const auto labels = cells::LabelLayout::of(*m_model.layout()))
        cells = cells::CellSurface::unprepared(surface, *labels);
    std::optional<BoundarySubject> bounded;
    if (std::isfinite(m_definition.boundaryLimit) &&
        std::ranges::any_of(fresh, [](const Kept* kept) { return kept->cut; }))
        bounded.emplace(m_model, m_definition, m_radiusOfSupport);
    base::parallelFor(fresh.size(), 1, [&](std::size_t b) {
        const SurfelBlock& block = *fresh[b]->block;
        Finer finer(surface, cells ? &*cells : nullptr, m_radiusOfSupport);
        const std::vector<Disc> kept = fresh[b]->spread ? finer.of(block) : finer.settled(block);
        std::optional<BoundaryCuts> boundary;
        if (bounded && fresh[b]->cut)
            boundary.emplace(*bounded);
        SharpCuts sharp(m_model, m_radiusOfSupport);
        for (std::size_t first = 0; first < kept.size(); first += surfel::blockCapacity) {
            const auto discs =
                std::span(kept).subspan(first, std::min<std::size_t>(surfel::blockCapacity, kept.size() - first));
            Part part{blockOf(discs, *m_model.layout()), nullptr};
            CutCodes codes{};
            bool any = boundary && boundary->cut(*part.block, codes);
            for (std::size_t i = 0; i < discs.size(); ++i)
                if (codes[i] == wholeDisc && discs[i].code != wholeDisc) {
                    codes[i] = discs[i].code;
                    any = true;
                }
            any |= fresh[b]->cut && sharp.cut(*part.block, codes);
            if (any)
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
