#include "core/mesh/marching/solid.h"

#include "core/base/parallel.h"
#include "core/base/scratch.h"
#include "core/surface/rims.h"

#include <cmath>

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationf;

namespace {

constexpr double offCentre = 0.4, farOff = 0.8;     ///< of h: where f begins to be doubted, where it no longer counts
constexpr float oneSheet = 0.92f;                   ///< agreement below which there may be several
constexpr float fewSamples = 2;                     ///< sum of weights: a stray's are little more than 1, a sheet's 5
constexpr double surelyOut = 0.25, surelyIn = 0.75; ///< winding numbers that are sure of themselves

/// From winding numbers on a sheet, which are a half where normals point out of a solid, and less beside gaps: turns by
/// which they differ downwards; 1 where they may upwards.
int turnsOf(double least, double most) {
    constexpr double low = -0.25, high = 0.75, farthest = -100;
    return least < low ? static_cast<int>(std::floor(std::max(least, farthest))) : most > high ? 1 : 0;
}

surface::Surface withoutSecondPass(const surface::Surface& surface) {
    surface::SurfaceDefinition definition = surface.definition();
    definition.oneSheet = false;
    return {surface.tree(), definition};
}

std::vector<surfel::BlockPtr> blocksOf(const tree::SurfelTree& tree) {
    std::vector<surfel::BlockPtr> out;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock&) { out.push_back(tree.block(number)); });
    return out;
}

double smoothStep(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace

Solid::Solid(const surface::Surface& surface, const base::Progress& progress)
    : m_surface(surface), m_plain(withoutSecondPass(surface)), m_winding(surface.tree(), progress),
      m_open(std::isfinite(surface.definition().boundaryLimit)) {
    if (m_open)
        findMissing();
    else
        classify();
}

/// By a few surfels of each cluster.
int Solid::turnsOn(const surfel::SurfelBlock& block, int cluster) const {
    constexpr int stride = 5;
    double least = 1e300, most = -1e300;
    const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
    for (int slot = begin; slot < end; slot += stride) {
        const double w = m_winding.at(base::cast<double>(block.position(slot)));
        least = std::min(least, w);
        most = std::max(most, w);
    }
    return turnsOf(least, most);
}

void Solid::classify() {
    const std::vector<surfel::BlockPtr> blocks = blocksOf(m_surface.tree());
    std::vector<Turns> turns(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        for (int cluster = 0; cluster < blocks[b]->clusterCount(); ++cluster)
            turns[b][std::size_t(cluster)] = static_cast<std::int8_t>(turnsOn(*blocks[b], cluster));
    });
    std::ptrdiff_t inwards = 0, clusters = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        clusters += blocks[b]->clusterCount();
        inwards += std::count_if(turns[b].begin(), turns[b].end(), [](std::int8_t t) { return t < 0; });
    }
    m_around = 2 * inwards > clusters ? -1 : 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        for (int cluster = 0; cluster < blocks[b]->clusterCount(); ++cluster)
            turns[b][std::size_t(cluster)] = static_cast<std::int8_t>(turns[b][std::size_t(cluster)] - m_around);
        if (turns[b] != Turns{})
            m_turns.emplace(blocks[b].get(), turns[b]);
    }
}

/// What is missing at surfels of which one sheet is alone, mean over those of a block: near sheets are too near for
/// winding numbers of points.
void Solid::findMissing() {
    constexpr int stride = 3;
    const std::vector<surfel::BlockPtr> blocks = blocksOf(m_surface.tree());
    std::vector<std::vector<Vec3f>> places(blocks.size());
    std::vector<double> missing(blocks.size());
    base::parallelFor(blocks.size(), 16, [&](std::size_t b) {
        double sum = 0;
        for (int slot = 0; slot < blocks[b]->size(); slot += stride) {
            const Vec3f x = blocks[b]->position(slot);
            const Evaluationf at = m_plain.evaluate(x, surface::Need::Value);
            if (at.status == surface::Status::Outside || !(at.agreement >= oneSheet))
                continue;
            places[b].push_back(x);
            sum += m_winding.at(base::cast<double>(x));
        }
        if (!places[b].empty())
            missing[b] = 0.5 - sum / static_cast<double>(places[b].size());
    });
    surfel::SurfelList known;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (const Vec3f& x : places[b]) {
            known.items.emplace_back().position = x;
            known.items.back().support = 1;
            known.items.back().mask = static_cast<float>(missing[b]);
        }
    m_missing = tree::SurfelTree::build(known);
}

Solid::Sheet Solid::sheetNear(const Vec3d& x) const {
    static base::Scratch<std::vector<tree::Neighbour>> scratch;
    const auto nearest = scratch.take();
    if (!m_missing.empty()) {
        m_missing.nearest(base::cast<float>(x), 1, *nearest);
        return {0, static_cast<double>(nearest->front().block->mask(nearest->front().slot))};
    }
    if (m_turns.empty())
        return {};
    m_surface.tree().nearest(base::cast<float>(x), 1, *nearest);
    const tree::Neighbour& beside = nearest->front();
    const float support = beside.block->support(beside.slot);
    const auto found = m_turns.find(beside.block);
    if (found == m_turns.end() || beside.distanceSq > support * support)
        return {};
    return {found->second[std::size_t(beside.slot / surfel::clusterSize)], 0};
}

/// Where no surfel has a say, an open surface has no sides: a sheet would span its holes.
bool Solid::rimReaches(const Vec3f& x, const Evaluationf& at) const {
    return at.status == surface::Status::Outside || surface::mayEnd(m_surface, x);
}

/// Where one sheet is alone it makes no difference what is done about near ones.
std::vector<SolidSide> Solid::sides(std::span<const Vec3f> x, std::span<Evaluationf> out) const {
    m_plain.evaluate(x, surface::Need::Value, out);
    std::vector<std::size_t> several;
    std::vector<Vec3f> again;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (!(out[i].ok() && out[i].agreement >= oneSheet)) {
            several.push_back(i);
            again.push_back(x[i]);
        }
    std::vector<Evaluationf> answers(again.size());
    m_surface.evaluate(again, surface::Need::Value, answers);
    std::vector<std::uint8_t> alone(x.size(), 1);
    std::vector<SolidSide> result(x.size());
    for (std::size_t i = 0; i < several.size(); ++i) {
        out[several[i]] = answers[i];
        alone[several[i]] = 0;
    }
    base::parallelFor(x.size(), 256, [&](std::size_t i) {
        if (!m_open || !rimReaches(x[i], out[i]))
            result[i] = height(base::cast<double>(x[i]), out[i], alone[i] != 0).value < 0 ? SolidSide::Inside
                                                                                          : SolidSide::Outside;
    });
    return result;
}

Solid::Height Solid::height(const Vec3d& x, const Evaluationf& at, bool alone) const {
    const Sheet sheet = sheetNear(x);
    if (!at.ok())
        return {0.5 - winding(x, sheet), 1, true};
    const double f = double(at.value) / double(at.unit), o = double(at.offCentre) / double(at.unit);
    if (o <= offCentre && alone && at.weight >= fewSamples && sheet.turns <= 0)
        return {f, 0, false};
    const double w = winding(x, sheet);
    if ((w < surelyOut && f < 0) || (w > surelyIn && f >= 0))
        return {0.5 - w, 1, true};
    const double share = smoothStep((o - offCentre) / (farOff - offCentre));
    return {(1 - share) * f + share * (0.5 - w), share, false};
}

Vec3d Solid::outwards(const Vec3d& x, const Evaluationf& at, const Height& height) const {
    Vec3d out;
    if (height.winding < 1)
        out = base::cast<double>(at.gradient) * ((1 - height.winding) / double(at.unit));
    if (height.winding > 0)
        out -= m_winding.gradient(x) * height.winding;
    return base::normalized(out, Vec3d{0, 0, 1});
}

} // namespace mesh
