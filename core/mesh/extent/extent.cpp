#include "core/mesh/extent/extent.h"

#include "core/base/box.h"
#include "core/base/parallel.h"
#include "core/base/radix_sort.h"
#include "core/cells/cell_projection.h"
#include "core/cells/cell_source.h"
#include "core/mesh/cell_size.h"
#include "core/mesh/check/topology.h"
#include "core/mesh/extent/edge_shortfall.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/mesh/marching/thin_walls.h"
#include "core/mesh/surface_parts.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/curves/boundary.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace mesh {

using base::Vec3d;

namespace {

constexpr double lackingFactor = 8; ///< so well is known what is lacking at edges: that at corners is not counted
constexpr double aboutAll = 4;      ///< the way about a square, over its side

struct Edge {
    std::uint32_t a, b; ///< a < b
    bool operator==(const Edge&) const = default;
    bool operator<(const Edge& o) const { return a != o.a ? a < o.a : b < o.b; }
};

Edge edgeOf(const Triangle& t, std::size_t k) {
    const std::uint32_t a = t[k], b = t[(k + 1) % 3];
    return {std::min(a, b), std::max(a, b)};
}

/// All edges once, in order, and whether one triangle alone has them.
struct Edges {
    std::vector<Edge> list;
    std::vector<std::uint8_t> boundary;

    explicit Edges(const Mesh& mesh) {
        std::vector<Edge> all(3 * mesh.triangles.size());
        base::parallelFor(mesh.triangles.size(), 8192, [&](std::size_t i) {
            for (std::size_t k = 0; k < 3; ++k)
                all[3 * i + k] = edgeOf(mesh.triangles[i], k);
        });
        const int bits = std::bit_width(mesh.positions.size());
        base::radixSort(all, 2 * bits, [bits](const Edge& e) { return std::uint64_t(e.a) << bits | e.b; });
        for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
            for (end = i; end < all.size() && all[end] == all[i];)
                ++end;
            list.push_back(all[i]);
            boundary.push_back(end - i == 1);
        }
    }
    std::uint32_t find(const Edge& edge) const {
        return static_cast<std::uint32_t>(std::lower_bound(list.begin(), list.end(), edge) - list.begin());
    }
};

/// The middle of an edge put on the surface, or on its boundary; straight where that is too far away to be the same
/// place.
struct Middle {
    Vec3d position;
    bool flat = true;
};

Middle middleAt(const Mesh& mesh, const Edge& edge, const Vec3d& place) {
    constexpr double farthest = 0.5; ///< of the edge
    const Vec3d &a = mesh.positions[edge.a], &b = mesh.positions[edge.b], straight = (a + b) / 2;
    return distance(place, straight) <= farthest * distance(a, b) ? Middle{place, false} : Middle{straight};
}

/// Not the closest point, but as near to the middle, but for the square of how far that is.
surface::ProjectOptions toTheSurface() {
    surface::ProjectOptions out;
    out.projector = surface::Projector::Almost;
    out.checkBoundary = false;
    return out;
}

Middle middleOf(const surface::Surface& surface, const std::optional<cells::CellSurface>& cells, const Mesh& mesh,
                const Edge& edge, bool boundary) {
    const Vec3d &a = mesh.positions[edge.a], &b = mesh.positions[edge.b];
    Middle out{(a + b) / 2};
    surface::OrientationHint hint;
    if (!mesh.normals.empty())
        hint.direction = mesh.normals[edge.a] + mesh.normals[edge.b];
    const auto take = [&](const Vec3d& p) { out = middleAt(mesh, edge, p); };
    const auto isLimit = [&](std::uint32_t v) { return mesh.kinds.empty() || mesh.kinds[v] == VertexKind::Limit; };
    if (boundary) {
        if (isLimit(edge.a) && isLimit(edge.b))
            if (const auto found = surface::findBoundaryPoint(surface, out.position, hint); found.ok())
                take(found.point.position);
        return out;
    }
    surface::ProjectOptions options = toTheSurface();
    options.tolerance = 1e-9;
    if (cells)
        if (const cells::CellFoot found = cells::project(*cells, out.position, options); found.projection.ok()) {
            take(found.projection.foot);
            if (found.mixed || !out.flat)
                return out;
        }
    for (const surface::OrientationHint& asked : {surface::OrientationHint{}, hint})
        if (out.flat)
            if (const auto found = surface::projectReference(surface, out.position, options, asked); found.ok())
                take(found.foot);
    return out;
}

Vec3d middleOf(const Mesh& mesh) {
    base::Box3d box;
    for (const Vec3d& p : mesh.positions)
        box.extend(p);
    return mesh.positions.empty() ? Vec3d() : (box.lo + box.hi) / 2;
}

/// Sums of triangles in chunks, in their order.
template <class Each>
double sumOver(const Mesh& mesh, const Each& each) {
    constexpr std::size_t grain = 8192;
    std::vector<double> parts(base::chunkCount(mesh.triangles.size(), grain));
    base::parallelChunks(mesh.triangles.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i) {
            const Triangle& t = mesh.triangles[i];
            parts[chunk] += each(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
        }
    });
    double out = 0;
    for (const double part : parts)
        out += part;
    return out;
}

} // namespace

double areaOf(const Mesh& mesh) {
    return sumOver(mesh,
                   [](const Vec3d& a, const Vec3d& b, const Vec3d& c) { return 0.5 * length(cross(b - a, c - a)); });
}

double volumeOf(const Mesh& mesh) {
    const Vec3d middle = middleOf(mesh);
    return sumOver(mesh, [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
        return dot(a - middle, cross(b - middle, c - middle)) / 6;
    });
}

/// Vertices with several cells about them.
static std::vector<std::uint8_t> mixedVertices(const std::optional<cells::CellSurface>& cells, const Mesh& mesh) {
    std::vector<std::uint8_t> out(mesh.positions.size());
    if (cells)
        base::parallelChunks(out.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            cells::CellSource source(*cells);
            for (std::size_t v = begin; v < end; ++v) {
                source.moveTo(mesh.positions[v]);
                out[v] = source.count() > 1;
            }
        });
    return out;
}

/// The middles of all edges. Within faces in float32, many at once: what that rounds is among the errors told.
static std::vector<Middle> middlesOf(const surface::Surface& surface, const Mesh& mesh, const Edges& edges,
                                     const base::Progress& progress) {
    constexpr std::size_t slab = 1 << 14;
    const std::optional<cells::CellSurface> cells = cells::CellSurface::of(surface);
    const std::vector<std::uint8_t> mixed = mixedVertices(cells, mesh);
    const surface::ProjectOptions options = toTheSurface();
    std::vector<Middle> out(edges.list.size());
    std::vector<base::Vec3f> starts;
    std::vector<surface::Projection<float>> found;
    for (std::size_t first = 0; first < out.size(); first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(out.size()), "Measuring area");
        const std::size_t count = std::min(slab, out.size() - first);
        starts.resize(count);
        found.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Edge& edge = edges.list[first + i];
            starts[i] = base::cast<float>((mesh.positions[edge.a] + mesh.positions[edge.b]) / 2);
        }
        surface::project(surface, starts, options, found);
        base::parallelFor(count, 64, [&](std::size_t i) {
            const Edge& edge = edges.list[first + i];
            Middle& middle = out[first + i];
            if (edges.boundary[first + i] == 0 && !mixed[edge.a] && !mixed[edge.b] && found[i].ok())
                middle = middleAt(mesh, edge, base::cast<double>(found[i].foot));
            if (middle.flat)
                middle = middleOf(surface, cells, mesh, edge, edges.boundary[first + i] != 0);
        });
    }
    return out;
}

/// Every edge halved; `flat` counts middles that stay on the straight edge.
static Mesh halved(const surface::Surface& surface, const Mesh& mesh, std::size_t& flat,
                   const base::Progress& progress) {
    const Edges edges(mesh);
    const std::vector<Middle> middles = middlesOf(surface, mesh, edges, progress);
    Mesh out;
    out.positions = mesh.positions;
    for (const Middle& m : middles) {
        out.positions.push_back(m.position);
        flat += m.flat;
    }
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Triangle& t : mesh.triangles) {
        const std::uint32_t ab = count + edges.find(edgeOf(t, 0)), bc = count + edges.find(edgeOf(t, 1)),
                            ca = count + edges.find(edgeOf(t, 2));
        for (const Triangle& each :
             {Triangle{t[0], ab, ca}, Triangle{t[1], bc, ab}, Triangle{t[2], ca, bc}, Triangle{ab, bc, ca}})
            out.triangles.push_back(each);
    }
    return out;
}

/// Of float coordinates.
static double roundingOf(const base::Box3f& bounds) {
    double most = 0;
    for (const base::Vec3f& p : {bounds.lo, bounds.hi})
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::abs(static_cast<double>(p[k])));
    return std::ldexp(most, -24);
}

/// Volumes are signed.
static Extent extentOfPart(const surface::Surface& surface, double cell, const base::Progress& progress) {
    MarchingOptions options;
    options.cell = cell;
    MarchingReport report;
    Mesh coarse = marchingCubes(surface, options, report, process::part(progress, 0, 0.6));
    std::erase_if(coarse.triangles, [](const Triangle& t) { return !isProper(t); });
    const Topology topology = topologyOf(coarse.triangles, coarse.positions.size(), coarse.kinds);
    Extent out;
    const Mesh fine = halved(surface, coarse, out.flat, process::part(progress, 0.6, 0.9));
    // errors go with the square of the triangles' size
    const auto extrapolated = [](double wide, double narrow, double& error) {
        const double more = (narrow - wide) / 3;
        error = std::abs(more);
        return narrow + more;
    };
    out.area = extrapolated(areaOf(coarse), areaOf(fine), out.areaError);
    out.triangles = fine.triangles.size();
    out.boundaryEdges = topology.boundaryEdges;
    out.foldLoops = topology.foldLoops;
    out.orientable = topology.orientable && topology.opposedEdges == 0;
    out.closed = topology.boundaryEdges == 0 && out.orientable && !coarse.triangles.empty();
    if (out.closed)
        out.volume = extrapolated(volumeOf(coarse), volumeOf(fine), out.volumeError);
    const Shortfall lacks = shortfallAtEdges(surface, fine, report.largestCell, process::part(progress, 0.9, 1));
    out.areaError += lackingFactor * lacks.area;
    out.volumeError += out.closed ? lackingFactor * lacks.volume : 0;
    const double rounding = roundingOf(surface.tree().bounds());
    out.areaError += aboutAll * std::sqrt(out.area) * rounding;
    out.volumeError += out.closed ? out.area * rounding : 0;
    return out;
}

Extent extentOf(const surface::Surface& surface, double cell, const base::Progress& progress) {
    std::vector<surface::Surface> parts{surface};
    if (!(cell > 0))
        parts = partsOf(surface, process::part(progress, 0, 0.02));
    Extent out;
    out.closed = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto share = [&](std::size_t k) {
            return 0.02 + 0.98 * static_cast<double>(k) / static_cast<double>(parts.size());
        };
        // walls that cells of one size do not see take cells of several
        const double own = cell > 0 ? cell : thinWalls(parts[i]).empty() ? usualCell(parts[i].tree()) : 0;
        const Extent part = extentOfPart(parts[i], own, process::part(progress, share(i), share(i + 1)));
        out.area += part.area, out.areaError += part.areaError;
        out.volume += part.volume, out.volumeError += part.volumeError;
        out.triangles += part.triangles, out.flat += part.flat;
        out.boundaryEdges += part.boundaryEdges, out.foldLoops += part.foldLoops;
        out.orientable = out.orientable && part.orientable;
        out.closed = out.closed && part.closed;
    }
    out.volume = out.closed ? std::abs(out.volume) : 0;
    out.volumeError = out.closed ? out.volumeError : 0;
    return out;
}

} // namespace mesh
