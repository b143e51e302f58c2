#include "core/process/estimation/prepare.h"

#include "core/base/unit_normal.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_supports.h"
#include "core/process/estimation/complex_supports.h"
#include "core/process/estimation/duplicates.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/normals.h"
#include "core/process/estimation/orientation/agreement.h"
#include "core/process/estimation/orientation/global_orientation.h"
#include "core/process/estimation/orientation/outside.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/scan_lines.h"
#include "core/process/estimation/supports.h"
#include "core/process/neighbours/cloud_neighbours.h"
#include "core/process/neighbours/curve_order.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

namespace process {

namespace {

using surface::Boundary;
using surface::SurfaceDefinition;

constexpr int orientNeighbours = 12;
constexpr std::size_t normalNeighbours = 18;
/// Of h: a curve ends at 3/14 h (process/README 3); uneven spacing alone stays below this.
constexpr float curveLimit = 0.3f;

constexpr std::size_t grain = 8192;

/// Whether `holds(point)` for every point, in parallel.
template <class Holds>
bool allOf(const surfel::SurfelList& points, const Holds& holds) {
    std::atomic<bool> all = true;
    base::parallelChunks(points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end && all.load(std::memory_order_relaxed); ++i)
            if (!holds(points.items[i]))
                all.store(false, std::memory_order_relaxed);
    });
    return all;
}

void dropNonFinite(surfel::SurfelList& points) {
    if (!allOf(points, [](const surfel::Surfel& s) { return base::isFinite(s.position); }))
        keepPoints(points, [&](std::size_t i) { return base::isFinite(points.items[i].position); });
}

/// Unit length where it is not; what was saved comes back bit for bit.
void makeUnit(surfel::SurfelList& points) {
    base::parallelFor(points.size(), grain, [&](std::size_t i) {
        surfel::Surfel& s = points.items[i];
        s.normal = base::unitNormal(s.normal);
    });
}

void setOriented(surfel::SurfelList& points, bool oriented) {
    if (points.layout->normals && points.layout->oriented == oriented)
        return;
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->normals = true;
    layout->oriented = oriented;
    points.layout = std::move(layout);
}

bool hasNormal(const surfel::Surfel& s) {
    return s.normal != base::Vec3f{};
}

/// What is known of the points' surroundings, found where something must be estimated: a file that brings everything
/// opens without. One search serves all, because each step hands on what the next one needs. First of all the points
/// are put in the order of the curve, in which all that follows, the tree included, finds them side by side.
class Surroundings {
  public:
    Surroundings(surfel::SurfelList& points, surface::Manifold manifold, const base::Progress& progress)
        : m_points(points), m_indexing(part(progress, 0, 0.3)), m_searching(part(progress, 0.3, 1)),
          m_isCurve(manifold == surface::Manifold::Curve) {}

    const Cloud& cloud() {
        if (!m_cloud) {
            m_indexing.step(0, "Sorting points");
            m_numbers = putInCurveOrder(m_points);
            m_cloud.emplace(m_points.items, m_indexing);
        }
        return *m_cloud;
    }
    /// Beside lines too, where the scan is made of these.
    CloudNeighbours& neighbours() {
        nearest();
        if (!m_isCurve && !std::exchange(m_besideLines, true))
            lookBesideLines(cloud(), *m_neighbours, {nullptr, m_searching.cancel}); // too short a time to report
        return *m_neighbours;
    }
    /// From the next search on.
    void wantNormals() { m_wantNormals = true; }
    std::span<base::Vec3f> normals() {
        m_wantNormals = true;
        if (neighbours().normals.empty())
            m_neighbours.reset(), m_besideLines = false;
        return neighbours().normals;
    }
    void dropNormals() {
        m_wantNormals = false;
        if (m_neighbours)
            m_neighbours->normals = {};
    }
    CloudNeighbours take() {
        CloudNeighbours out = std::move(neighbours());
        m_neighbours.reset(), m_besideLines = false;
        return out;
    }
    /// Merges what stands in one place. Returns how many points went.
    std::size_t merge(const base::Progress& progress) {
        const CloudNeighbours& near = nearest();
        const std::vector<std::uint32_t> first = firstOfDuplicates(cloud(), near, progress, m_numbers);
        m_numbers = {};
        if (first.empty())
            return 0;
        std::vector<std::uint8_t> stays(m_cloud->size(), 0);
        for (std::uint32_t i = 0; i < first.size(); ++i)
            if (first[i] == i)
                stays[m_cloud->places()[i]] = 1;
        KeptNeighbours kept(*m_cloud, std::move(*m_neighbours), stays);
        m_cloud.reset();
        const std::size_t merged = mergeDuplicates(m_points, first);
        m_indexing.report = m_searching.report = nullptr; // so far it was already
        m_neighbours = std::move(kept).in(cloud(), m_wantNormals ? normalNeighbours : 0, m_searching);
        return merged;
    }

  private:
    CloudNeighbours& nearest() {
        if (!m_neighbours)
            m_neighbours = neighboursOf(cloud(), m_wantNormals ? normalNeighbours : 0, m_searching);
        return *m_neighbours;
    }

    surfel::SurfelList& m_points;
    base::Progress m_indexing, m_searching;
    bool m_isCurve, m_wantNormals = false, m_besideLines = false;
    base::LargeArray<std::uint32_t> m_numbers; ///< that the points had in the file; none where they stay
    std::optional<Cloud> m_cloud;
    std::optional<CloudNeighbours> m_neighbours;
};

/// The estimates take the side of normals that are known.
void takeKnownSides(const surfel::SurfelList& points, const Cloud& cloud, std::span<base::Vec3f> normals,
                    const base::Progress& progress) {
    std::vector<base::Vec3f> known(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        known[cloud.places()[i]] += points.items[i].normal;
    cloud.forEach(normalNeighbours, progress, "Completing normals", [&](std::size_t i, const Neighbours& near) {
        base::Vec3f side = known[i];
        for (const std::uint32_t j : near.index)
            side += known[j];
        if (base::dot(normals[i], side) < 0)
            normals[i] = -normals[i];
    });
}

/// Estimates the normals that are missing. Where others are known, the estimates take their side. False where the
/// surface has no sides to take.
bool completeNormals(surfel::SurfelList& points, Surroundings& around, const base::Progress& progress) {
    const std::span<base::Vec3f> normals = around.normals();
    bool sided = true;
    if (!allOf(points, [](const surfel::Surfel& s) { return !hasNormal(s); }))
        takeKnownSides(points, around.cloud(), normals, progress);
    else
        sided = orientGlobally(around.cloud(), around.neighbours().table, normals, progress);
    const auto places = around.cloud().places();
    base::parallelFor(points.size(), grain, [&](std::size_t i) {
        if (!hasNormal(points.items[i]))
            points.items[i].normal = normals[places[i]];
    });
    around.dropNormals();
    return sided;
}

/// Turns normals that do not agree on a side. Returns how many.
std::size_t turnDisagreeing(surfel::SurfelList& points, Surroundings& around, const base::Progress& progress) {
    const Cloud& cloud = around.cloud(); // it puts the points in another order
    const auto places = cloud.places();
    std::vector<base::Vec3f> normals(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        normals[places[i]] = points.items[i].normal;
    if (!makeAgree(cloud, around.neighbours().table, normals, progress))
        return 0;
    std::size_t turned = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (base::Vec3f& n = points.items[i].normal; base::dot(n, normals[places[i]]) < 0)
            n = -n, ++turned;
    return turned;
}

/// Distinct positions, counted up to 4.
std::size_t fewDistinct(const surfel::SurfelList& points) {
    std::vector<base::Vec3f> seen;
    for (std::size_t i = 0; i < points.size() && seen.size() < 4; ++i)
        if (std::find(seen.begin(), seen.end(), points.items[i].position) == seen.end())
            seen.push_back(points.items[i].position);
    return seen.size();
}

void prepareNormals(surfel::SurfelList& points, Surroundings& around, const PrepareOptions& options,
                    const base::Progress& progress) {
    const SurfaceDefinition& definition = options.definition;
    const bool declared = points.layout->normals;
    if (!declared)
        base::parallelFor(points.size(), grain, [&](std::size_t i) { points.items[i].normal = {}; });
    makeUnit(points);
    if (definition.manifold == surface::Manifold::Curve)
        return; // what there is are tangents, and curves do without
    bool oriented = points.layout->oriented || !declared;
    if (!allOf(points, hasNormal))
        oriented &= completeNormals(points, around, part(progress, 0, 0.7));
    else if (options.disagreed && declared && oriented)
        *options.disagreed = turnDisagreeing(points, around, part(progress, 0, 0.7));
    if (oriented || !declared)
        setOriented(points, oriented);
    else if (definition.frame == surface::Frame::Normals && !options.keepSides)
        orientNormals(points, orientNeighbours, part(progress, 0.7, 1));
}

/// Shapes as they may be, and balls where supports are made anew: what `keeps` leaves out. Strokes turn normals and
/// leave shapes, so that these are not turned here: a model opens as it was saved.
/// With `across`, those that are left out lie in the tangent planes instead.
template <class Keeps>
void prepareShapes(surfel::SurfelList& points, bool across, const Keeps& keeps) {
    if (surfel::shapeChannel(*points.layout) == 0)
        return;
    const std::size_t first = surfel::shapeWord(*points.layout), words = points.layout->words();
    base::parallelFor(points.size(), grain, [&](std::size_t i) {
        const auto own = std::span(points.extra).subspan(i * words, words);
        const surfel::Surfel& s = points.items[i];
        const bool kept = keeps(s);
        surfel::putShape(own, first,
                         kept || across
                             ? surfel::soundShape(surfel::shapeIn(own, first), kept ? base::Vec3f{} : s.normal)
                             : base::Vec3f{});
    });
}

/// As it is by now; zero where there are none.
base::Vec3f shapeOf(const surfel::SurfelList& points, std::size_t i) {
    return surfel::shapeChannel(*points.layout) == 0
               ? base::Vec3f{}
               : surfel::shapeIn(points.extraOf(i), surfel::shapeWord(*points.layout));
}

void prepareSupports(surfel::SurfelList& points, Surroundings& around, const PrepareOptions& options,
                     const base::Progress& progress) {
    const auto keeps = [&](const surfel::Surfel& s) {
        return options.keepSupports && s.support > 0 && std::isfinite(s.support);
    };
    prepareShapes(points, options.keepShapes, keeps);
    if (allOf(points, keeps))
        return;
    const bool one = options.definition.support > 0;
    const std::vector<float> h =
        supportsOf(around.cloud(), points, options.definition, one ? CloudNeighbours() : around.take(), progress);
    const auto places = around.cloud().places();
    base::parallelFor(points.size(), grain, [&](std::size_t i) {
        if (!keeps(points.items[i]))
            points.items[i].support = h[places[i]] * std::sqrt(surfel::aspectOf(shapeOf(points, i)));
    });
}

surface::Surface withLimit(tree::SurfelTree tree, SurfaceDefinition definition, const base::Progress& progress) {
    if (definition.boundary != Boundary::Limit)
        definition.boundaryLimit = std::numeric_limits<float>::infinity();
    if (definition.boundary == Boundary::Auto && definition.manifold == surface::Manifold::Curve)
        definition.boundaryLimit = curveLimit;
    surface::Surface out(std::move(tree), definition);
    if (definition.boundary != Boundary::Auto || definition.manifold == surface::Manifold::Curve)
        return out;
    definition.boundaryLimit = automaticBoundaryLimit(out, progress);
    return {out.tree(), definition};
}

/// The same tree, all normals turned round.
tree::SurfelTree turned(const tree::SurfelTree& tree) {
    tree::Edit edit;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        surfel::MutableBlockPtr changed = block.clone();
        for (int slot = 0; slot < block.size(); ++slot)
            changed->setNormal(slot, -block.normal(slot));
        changed->seal();
        edit.blocks.push_back({number, changed, {}});
    });
    return tree.apply(edit);
}

/// The same tree with the surfels' supports made anew; blocks in which none differs stay shared.
tree::SurfelTree withSupports(const tree::SurfelTree& tree, const SurfaceDefinition& definition,
                              const base::Progress& progress) {
    surfel::SurfelList points = tree.surfels();
    assignSupports(points, definition, progress);
    const int shape = surfel::shapeChannel(*tree.layout());
    tree::Edit edit;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        surfel::MutableBlockPtr changed;
        for (int slot = 0; slot < block.size(); ++slot, ++at) {
            const float support = points.items[at].support;
            const bool ball = surfel::shapeOf(block, slot, shape) == base::Vec3f();
            if (support == block.support(slot) && ball)
                continue;
            if (!changed)
                changed = block.clone();
            if (!ball)
                surfel::setShape(*changed, slot, shape, {});
            changed->channel(slot / surfel::clusterSize, surfel::Support)[slot % surfel::clusterSize] = support;
        }
        if (changed) {
            changed->seal();
            edit.blocks.push_back({number, changed, {}});
        }
    });
    return tree.apply(edit);
}

} // namespace

/// Of a complex nothing is estimated but supports: its points say what they are on.
static surface::Surface prepareComplex(surfel::SurfelList points, const PrepareOptions& options,
                                       const base::Progress& progress) {
    if (!options.definition.connectivity)
        throw base::Error("the model does not tell how the cells of a complex hang together", "",
                          "open a file with an element complex_cell, or choose another manifold");
    if (points.size() == 0)
        throw base::Error("the complex has no points", "", "open a model with some");
    makeUnit(points);
    assignComplexSupports(points, options.definition, options.keepSupports);
    return {tree::SurfelTree::build(points, options.shape ? *options.shape : tree::TreeShape(), progress),
            options.definition};
}

surface::Surface prepare(surfel::SurfelList points, const PrepareOptions& options, const base::Progress& progress) {
    dropNonFinite(points);
    if (options.definition.manifold == surface::Manifold::Complex)
        return prepareComplex(std::move(points), options, progress);
    if (const std::size_t distinct = fewDistinct(points); distinct < 4)
        throw base::Error("a surface needs at least 4 distinct points, but there are only " + std::to_string(distinct),
                          "", "open a model with more points");
    tree::SurfelTree tree;
    const bool sided = options.turned && points.layout->normals && points.layout->oriented &&
                       options.definition.manifold == surface::Manifold::Surface && allOf(points, hasNormal);
    {
        const base::Progress looking = part(progress, 0, 0.3);
        Surroundings around(points, options.definition.manifold, looking);
        if (options.definition.manifold == surface::Manifold::Surface &&
            !(points.layout->normals && allOf(points, hasNormal)))
            around.wantNormals();
        if (options.merged)
            *options.merged = around.merge(part(progress, 0.3, 0.4));
        prepareNormals(points, around, options, part(progress, 0.4, 0.6));
        prepareSupports(points, around, options, part(progress, 0.6, 0.8));
    }
    tree =
        tree::SurfelTree::build(points, options.shape ? *options.shape : tree::TreeShape(), part(progress, 0.8, 0.9));
    points = {}; // the tree has it all
    if (options.keepLimit)
        return {std::move(tree), options.definition};
    surface::Surface out = withLimit(std::move(tree), options.definition, part(progress, 0.9, 1));
    const bool closed = options.definition.boundary == Boundary::Auto && std::isinf(out.definition().boundaryLimit);
    if (!sided || !closed || !looksInwards(out.tree()))
        return out;
    *options.turned = true;
    return {turned(out.tree()), out.definition()};
}

surface::Surface redefine(const surface::Surface& surface, const SurfaceDefinition& definition,
                          const base::Progress& progress) {
    const SurfaceDefinition& old = surface.definition();
    const bool same = old.weight == definition.weight && old.support == definition.support &&
                      (definition.support > 0 || old.neighbours == definition.neighbours);
    return withLimit(same ? surface.tree() : withSupports(surface.tree(), definition, part(progress, 0, 0.8)),
                     definition, part(progress, 0.8, 1));
}

} // namespace process
