#include "core/mesh/delaunay_start.h"

#include "core/base/parallel.h"
#include "core/process/part_progress.h"
#include "core/process/point_grid.h"
#include "core/surface/intersect.h"
#include "core/surface/project.h"
#include "core/surface/rims.h"

namespace mesh {

using base::Vec3d, base::Vec3f;
using process::PointGrid;

namespace {

/// Some of a rim's points, about a size apart.
RimChain chainOf(const surface::Rim& rim, const SizeField& size) {
    RimChain out;
    out.closed = rim.closed;
    const std::size_t count = rim.points.size();
    double since = std::numeric_limits<double>::infinity(); // how far along since the last one taken, in sizes
    for (std::size_t i = 0; i < count; ++i) {
        const surface::RimPoint& p = rim.points[i];
        if (i > 0)
            since += distance(p.position, rim.points[i - 1].position) / size(p.position);
        const bool end = !rim.closed && i + 1 == count;
        if (since < 1 && !end)
            continue;
        since = 0;
        out.positions.push_back(p.position);
        out.normals.push_back(p.normal);
    }
    return out;
}

struct Foot {
    Vec3d position;
    bool good = false;
};

/// Where a surfel's foot is surface: valid, within the limits, and f rises there.
Foot footOf(const surface::Surface& surface, const surfel::Surfel& s) {
    surface::ProjectOptions how;
    how.projector = surface::Projector::Basic;
    const auto found = project(surface, s.position, how);
    if (!found.ok())
        return {};
    const surface::Evaluationf e = surface.evaluate(found.foot);
    const bool good = e.ok() && double(e.offCentre) <= surface::maxOffCentre * double(e.unit) &&
                      double(dot(e.normal, e.gradient)) >= surface::minSlope;
    return {base::cast<double>(found.foot), good};
}

std::vector<Foot> feetOf(const surface::Surface& surface, const base::Progress& progress) {
    const auto blocks = surface.tree().blockCount();
    std::vector<std::vector<Foot>> parts(blocks);
    constexpr std::uint32_t slab = 64;
    for (std::uint32_t first = 0; first < blocks; first += slab) {
        progress.step(double(first) / double(blocks), "Spreading points");
        base::parallelFor(std::min(slab, blocks - first), 1, [&](std::size_t i) {
            const auto number = first + static_cast<std::uint32_t>(i);
            const surfel::BlockPtr block = surface.tree().block(number);
            for (int slot = 0; slot < block->size(); ++slot)
                parts[number].push_back(footOf(surface, block->surfel(slot)));
        });
    }
    std::vector<Foot> out;
    for (const auto& part : parts)
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

/// A grid over the model with cells of about `cell`.
PointGrid gridOver(const surface::Surface& surface, double cell) {
    const base::Box3f box = surface.tree().bounds().inflated(surface.tree().maxSupport());
    const double least = double(box.diagonal()) * 2e-6;
    return {box.lo, static_cast<float>(std::max(cell, least))};
}

bool anyWithin(const PointGrid& grid, const Vec3d& x, double radius) {
    bool any = false;
    const Vec3f at = base::cast<float>(x);
    grid.forNear(at, static_cast<float>(radius),
                 [&](const PointGrid::Entry& e) { any |= double(base::distance(e.position, at)) < radius; });
    return any;
}

} // namespace

std::vector<RimChain> rimChains(const surface::Surface& surface, const SizeField& size,
                                const base::Progress& progress) {
    std::vector<RimChain> out;
    if (!std::isfinite(surface.definition().boundaryLimit))
        return out;
    for (const surface::Rim& rim : findRims(surface, progress)) {
        RimChain chain = chainOf(rim, size);
        if (chain.positions.size() >= (chain.closed ? 3u : 2u))
            out.push_back(std::move(chain));
    }
    return out;
}

std::vector<Vec3d> spreadPoints(const surface::Surface& surface, const SizeField& size, std::span<const Vec3d> taken,
                                const base::Progress& progress) {
    std::vector<Vec3d> out;
    const std::vector<Foot> feet = feetOf(surface, progress);
    double smallest = std::numeric_limits<double>::infinity();
    std::vector<double> sizes(feet.size());
    base::parallelFor(feet.size(), 256, [&](std::size_t i) { sizes[i] = feet[i].good ? size(feet[i].position) : 0; });
    for (const double s : sizes)
        smallest = s > 0 ? std::min(smallest, s) : smallest;
    if (!std::isfinite(smallest))
        return out;
    PointGrid grid = gridOver(surface, smallest);
    for (const Vec3d& p : taken)
        grid.insert({base::cast<float>(p), 0});
    for (std::size_t i = 0; i < feet.size(); ++i)
        if (feet[i].good && !anyWithin(grid, feet[i].position, sizes[i])) {
            out.push_back(feet[i].position);
            grid.insert({base::cast<float>(feet[i].position), 0});
        }
    return out;
}

std::vector<Vec3d> uncoveredFeet(const surface::Surface& surface, const SizeField& size, const Mesh& mesh,
                                 double reach) {
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Triangle& t : mesh.triangles)
        used[t[0]] = used[t[1]] = used[t[2]] = true;
    const std::vector<Foot> feet = feetOf(surface, {});
    std::vector<double> sizes(feet.size());
    base::parallelFor(feet.size(), 256, [&](std::size_t i) { sizes[i] = feet[i].good ? size(feet[i].position) : 0; });
    double smallest = std::numeric_limits<double>::infinity();
    for (const double s : sizes)
        smallest = s > 0 ? std::min(smallest, s) : smallest;
    if (!std::isfinite(smallest))
        return {};
    PointGrid grid = gridOver(surface, reach * smallest);
    std::vector<PointGrid::Entry> entries;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v])
            entries.push_back({base::cast<float>(mesh.positions[v]), static_cast<std::uint32_t>(v)});
    grid.build(entries);
    std::vector<char> bare(feet.size(), 0);
    base::parallelFor(feet.size(), 256, [&](std::size_t i) {
        bare[i] = feet[i].good && !anyWithin(grid, feet[i].position, reach * sizes[i]);
    });
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < feet.size(); ++i)
        if (bare[i])
            out.push_back(feet[i].position);
    return out;
}

} // namespace mesh
