#include "core/render/splats/finer_blocks.h"

#include "core/base/parallel.h"
#include "core/render/splats/boundary_cuts.h"
#include "core/render/splats/off_surface.h"
#include "core/render/splats/sharp_cuts.h"
#include "core/render/splats/stand_out.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <optional>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// With the layout of the model's blocks where supports have shapes, else without further attributes.
surfel::BlockPtr blockOf(std::span<const FinerDisc> discs, const surfel::AttributeLayout& layout) {
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
    struct Fresh {
        Kept* kept;
        const Wish* wish;
    };
    std::vector<Fresh> fresh;
    for (const Wish& wish : wishes) {
        Kept& kept = m_kept.at(wish.block);
        const bool cut = wish.cut || wish.spread;
        const float pixel = wish.spread ? wish.pixel : 0;
        if (!kept.parts.empty() && kept.spread == wish.spread && kept.pixel == pixel && (kept.cut || !cut))
            continue;
        drop(kept);
        kept.spread = wish.spread, kept.cut = cut, kept.pixel = pixel;
        fresh.push_back({&kept, &wish});
    }
    if (fresh.empty())
        return;
    const surface::Surface surface(m_model, m_definition);
    std::optional<cells::CellSurface> cells;
    if (const auto labels = cells::LabelLayout::of(*m_model.layout()))
        cells = cells::CellSurface::unprepared(surface, *labels);
    std::optional<BoundarySubject> bounded;
    if (std::isfinite(m_definition.boundaryLimit) &&
        std::ranges::any_of(fresh, [](const Fresh& each) { return each.kept->cut; }))
        bounded.emplace(m_model, m_definition, m_radiusOfSupport);
    base::parallelFor(fresh.size(), 1, [&](std::size_t b) {
        Kept& made = *fresh[b].kept;
        FinerDiscs finer(surface, cells ? &*cells : nullptr, m_radiusOfSupport);
        const std::vector<FinerDisc> kept =
            made.spread ? finer.of(*made.block, {made.pixel, bounded ? fresh[b].wish->own : nullptr})
                        : finer.settled(*made.block);
        std::optional<BoundaryCuts> boundary;
        if (bounded && made.cut)
            boundary.emplace(*bounded);
        SharpCuts sharp(m_model, m_radiusOfSupport);
        for (std::size_t first = 0; first < kept.size(); first += surfel::blockCapacity) {
            const auto discs =
                std::span(kept).subspan(first, std::min<std::size_t>(surfel::blockCapacity, kept.size() - first));
            Part part{blockOf(discs, *m_model.layout()), nullptr};
            CutCodes codes{};
            bool any = boundary && boundary->cut(*part.block, codes, made.spread);
            for (std::size_t i = 0; i < discs.size(); ++i)
                if (codes[i] == wholeDisc && discs[i].code != wholeDisc) {
                    codes[i] = discs[i].code;
                    any = true;
                }
            any |= made.cut && sharp.cut(*part.block, codes);
            if (any)
                part.cuts = std::make_unique<CutCodes>(codes);
            made.parts.push_back(std::move(part));
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
