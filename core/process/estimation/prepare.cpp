#include "core/process/estimation/prepare.h"

#include "core/base/unit_normal.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_supports.h"
#include "core/process/estimation/duplicates.h"
#include "core/process/estimation/keep_points.h"
#include "core/process/estimation/normals.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/supports.h"

#include <algorithm>
#include <optional>

namespace process {

namespace {

using surface::Boundary;
using surface::SurfaceDefinition;

constexpr int orientNeighbours = 12;
/// Of h: a curve ends at 3/14 h (process/README 3); uneven spacing alone stays below this.
constexpr float curveLimit = 0.3f;

void dropNonFinite(surfel::SurfelList& points) {
    keepPoints(points, [&](std::size_t i) { return base::isFinite(points.items[i].position); });
}

/// Unit length where it is not; what was saved comes back bit for bit.
void makeUnit(surfel::SurfelList& points) {
    for (surfel::Surfel& s : points.items)
        s.normal = base::unitNormal(s.normal);
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

/// Estimates the normals that are missing. Where others are known, the estimates take their side. False where the
/// surface has no sides to take.
bool completeNormals(surfel::SurfelList& points, const Cloud& cloud, const base::Progress& progress) {
    std::vector<base::Vec3f> normals = normalsOf(cloud, 18, part(progress, 0, 0.5));
    const bool some = std::any_of(points.items.begin(), points.items.end(), hasNormal);
    const bool sided = some || orient(cloud, normals, orientNeighbours, part(progress, 0.5, 1));
    std::vector<base::Vec3f> known(cloud.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        known[cloud.places()[i]] += points.items[i].normal;
    std::vector<base::Vec3f> side = known;
    if (some)
        cloud.forEach(18, part(progress, 0.5, 1), "Completing normals", [&](std::size_t i, const Neighbours& near) {
            for (const std::uint32_t j : near.index)
                side[i] += known[j];
        });
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t place = cloud.places()[i];
        if (!hasNormal(points.items[i]))
            points.items[i].normal = base::dot(normals[place], side[place]) < 0 ? -normals[place] : normals[place];
    }
    return sided;
}

/// Neighbourhoods are found where something must be estimated: a file that brings everything opens without them.
class LazyCloud {
  public:
    LazyCloud(const surfel::SurfelList& points, const base::Progress& progress)
        : m_points(points), m_progress(progress) {}
    const Cloud& operator*() {
        if (!m_cloud)
            m_cloud.emplace(m_points.items, m_progress);
        return *m_cloud;
    }
    /// The points have become others.
    void forget() { m_cloud.reset(); }

  private:
    const surfel::SurfelList& m_points;
    base::Progress m_progress;
    std::optional<Cloud> m_cloud;
};

/// Returns how many.
std::size_t mergeThrough(surfel::SurfelList& points, LazyCloud& cloud, const base::Progress& progress) {
    const std::size_t merged = mergeDuplicates(points, firstOfDuplicates(*cloud, progress));
    if (merged > 0)
        cloud.forget();
    return merged;
}

/// Distinct positions, counted up to 4.
std::size_t fewDistinct(const surfel::SurfelList& points) {
    std::vector<base::Vec3f> seen;
    for (std::size_t i = 0; i < points.size() && seen.size() < 4; ++i)
        if (std::find(seen.begin(), seen.end(), points.items[i].position) == seen.end())
            seen.push_back(points.items[i].position);
    return seen.size();
}

void prepareNormals(surfel::SurfelList& points, LazyCloud& cloud, const SurfaceDefinition& definition,
                    const base::Progress& progress) {
    const bool declared = points.layout->normals;
    if (!declared)
        for (surfel::Surfel& s : points.items)
            s.normal = {};
    makeUnit(points);
    if (definition.manifold == surface::Manifold::Curve)
        return; // what there is are tangents, and curves do without
    bool oriented = points.layout->oriented || !declared;
    if (!std::all_of(points.items.begin(), points.items.end(), hasNormal))
        oriented &= completeNormals(points, *cloud, part(progress, 0, 0.7));
    if (oriented || !declared)
        setOriented(points, oriented);
    else if (definition.frame == surface::Frame::Normals)
        orientNormals(points, orientNeighbours, part(progress, 0.7, 1));
}

void prepareSupports(surfel::SurfelList& points, LazyCloud& cloud, const PrepareOptions& options,
                     const base::Progress& progress) {
    const auto keeps = [&](const surfel::Surfel& s) {
        return options.keepSupports && s.support > 0 && std::isfinite(s.support);
    };
    if (std::all_of(points.items.begin(), points.items.end(), keeps))
        return;
    const std::vector<float> h = supportsOf(*cloud, points, options.definition, progress);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!keeps(points.items[i]))
            points.items[i].support = h[(*cloud).places()[i]];
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

/// The same tree with the surfels' supports made anew; blocks in which none differs stay shared.
tree::SurfelTree withSupports(const tree::SurfelTree& tree, const SurfaceDefinition& definition,
                              const base::Progress& progress) {
    surfel::SurfelList points = tree.surfels();
    assignSupports(points, definition, progress);
    tree::Edit edit;
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        surfel::MutableBlockPtr changed;
        for (int slot = 0; slot < block.size(); ++slot, ++at) {
            const float support = points.items[at].support;
            if (support == block.support(slot))
                continue;
            if (!changed)
                changed = block.clone();
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

surface::Surface prepare(surfel::SurfelList points, const PrepareOptions& options, const base::Progress& progress) {
    dropNonFinite(points);
    if (const std::size_t distinct = fewDistinct(points); distinct < 4)
        throw base::Error("a surface needs at least 4 distinct points, but there are only " + std::to_string(distinct),
                          "", "open a model with more points");
    const base::Progress indexing = part(progress, 0, 0.1);
    LazyCloud cloud(points, indexing);
    if (options.merged)
        *options.merged = mergeThrough(points, cloud, part(progress, 0.1, 0.2));
    prepareNormals(points, cloud, options.definition, part(progress, 0.2, 0.6));
    prepareSupports(points, cloud, options, part(progress, 0.6, 0.8));
    tree::SurfelTree tree =
        tree::SurfelTree::build(points, options.shape ? *options.shape : tree::TreeShape(), part(progress, 0.8, 0.9));
    if (options.keepLimit)
        return {std::move(tree), options.definition};
    return withLimit(std::move(tree), options.definition, part(progress, 0.9, 1));
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
