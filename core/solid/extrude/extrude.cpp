#include "core/solid/extrude/extrude.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/process/estimation/known_rims.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/resampling/point_grid.h"
#include "core/solid/extrude/crossings.h"
#include "core/solid/extrude/extrude_wall.h"
#include "core/solid/extrude/extruded_rims.h"
#include "core/solid/extrude/lying_walls.h"
#include "core/solid/extrude/seam_border.h"
#include "core/solid/link_creases.h"
#include "core/solid/loops/open_loops.h"
#include "core/solid/merge.h"
#include "core/surface/projection/project.h"

#include <algorithm>

namespace solid {

using base::Vec3d, base::Vec3f;
using surfel::SurfelBlock;

namespace {

constexpr double behind = 3; ///< spacings from a loop that tell how dense walls are to be

void requireLength(const ExtrudeOptions& options) {
    if (options.length == 0)
        throw base::Error("a length of 0 extrudes nothing", "extrude", "give it a length, below 0 for the other way");
}

/// What was made, as trees: who a surfel belongs to is told by its place.
struct Made {
    tree::SurfelTree moved, walls;

    std::uint8_t kindOf(const Vec3f& at) const {
        std::vector<tree::Neighbour> near;
        for (const tree::SurfelTree* each : {&walls, &moved})
            if (!each->empty()) {
                each->nearest(at, 1, near);
                if (near[0].distanceSq == 0)
                    return each == &walls ? 2 : 1;
            }
        return 0;
    }
};

/// Sharp where two of them meet and turn, and where walls of two cells do, as at a corner.
surface::Surface withEdges(const surface::Surface& surface, const Made& made, std::size_t& atEdge) {
    constexpr float least = 0.14f; // 8 degrees: less is as flat as surfaces are
    return creasedWhere(
        surface,
        [&](const cells::SurfelLinks& links) -> LeadsOver {
            std::vector<std::uint8_t> kinds(links.size());
            for (std::uint32_t i = 0; i < kinds.size(); ++i)
                kinds[i] = made.kindOf(links.surfel(i).position);
            return [kinds, labels = cells::labelsOf(surface.tree()), &links](std::uint32_t a, std::uint32_t e) {
                const std::uint32_t b = links.link(e).other;
                return links.link(e).cut == cells::Cut::None &&
                       (kinds[a] != kinds[b] || (kinds[a] == 2 && labels[a].cell != labels[b].cell)) &&
                       length(links.surfel(a).normal - links.surfel(b).normal) > least;
            };
        },
        atEdge);
}

/// The border of a part: where o reaches L, pulled back to where the area of its outermost surfels ends. Of a
/// half-plane under Wendland's C2 kernel o is .35 h so far beyond its edge: at the edge itself, where it is .21 h, gaps
/// of points that were drawn by chance would count as borders.
constexpr float limitOfBorder = 0.35f;
constexpr double beyondEdge = 0.2; // h

std::vector<surface::BoundaryCurve> bordersOf(const surface::Surface& part, const base::Progress& progress) {
    std::vector<surface::BoundaryCurve> out = surface::findBoundaryCurves(part, progress);
    std::erase_if(out, [](const surface::BoundaryCurve& curve) { return !curve.closed; });
    for (surface::BoundaryCurve& curve : out)
        for (surface::BoundaryPoint& p : curve.points) {
            const Vec3d place = p.position - p.outward * (beyondEdge * p.unit);
            const auto foot =
                surface::projectReference(part, place, {.checkBoundary = false}, {base::cast<float>(p.normal)});
            p.position = foot.ok() && distance(foot.foot, place) < beyondEdge * p.unit ? foot.foot : place;
        }
    return out;
}

/// Where there is something beyond a border: next to a place, and no farther than its links would lead.
std::vector<std::uint8_t> besideRest(const Loop& loop, const tree::SurfelTree& rest) {
    constexpr double reach = 1.6; // spacings
    std::vector<std::uint8_t> out(loop.size());
    std::vector<tree::Neighbour> near;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const LoopPoint& p = loop.points[i];
        rest.nearest(base::cast<float>(p.position), 1, near, static_cast<float>(reach * p.spacing));
        out[i] = near.empty() ? 0 : 1;
    }
    return out;
}

/// Surfels near a border belong to the side of it that they lie on, where they face as the part does there.
void takeSides(const surface::Surface& surface, const std::vector<Loop>& loops,
               const std::vector<std::vector<std::uint8_t>>& stands, Part& part) {
    constexpr double near = 1.5; // spacings
    std::vector<process::PointGrid::Entry> entries;
    std::vector<const LoopPoint*> places;
    base::Box3d box;
    double widest = 0;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t i = 0; i < loops[l].size(); ++i)
            if (stands[l][i]) {
                const LoopPoint& p = loops[l].points[i];
                entries.push_back({base::cast<float>(p.position), static_cast<std::uint32_t>(places.size())});
                places.push_back(&p);
                box.extend(p.position);
                widest = std::max(widest, near * p.spacing);
            }
    if (places.empty())
        return;
    process::PointGrid grid(base::cast<float>(box.lo), static_cast<float>(widest));
    grid.build(entries);
    std::size_t number = 0;
    surface.tree().forEachBlock([&](std::uint32_t, const SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot, ++number) {
            const Vec3d x = base::cast<double>(block.position(slot)), n = base::cast<double>(block.normal(slot));
            const LoopPoint* nearest = nullptr;
            double least = widest;
            grid.forNear(block.position(slot), static_cast<float>(widest), [&](const auto& entry) {
                const LoopPoint& p = *places[entry.index];
                if (const double d = distance(p.position, x); d < std::min(least, near * p.spacing))
                    least = d, nearest = &p;
            });
            if (nearest && std::abs(dot(n, nearest->normal)) > 0.8)
                part.put(number, dot(x - nearest->position, nearest->outward) < 0);
        }
    });
}

Vec3d directionOf(const surfel::SurfelList& part, const ExtrudeOptions& options) {
    if (options.direction)
        return *options.direction;
    if (!part.layout->oriented)
        throw base::Error("the normals have no sides, which tell outwards from inwards", "extrude",
                          "orient them first, or give a direction");
    Vec3d sum, any;
    double area = 0;
    for (const surfel::Surfel& s : part.items) {
        const double a = static_cast<double>(s.support) * static_cast<double>(s.support);
        sum += base::cast<double>(s.normal) * a;
        area += a;
    }
    constexpr double least = 0.05;
    if (!(length(sum) > least * area))
        throw base::Error("what is selected faces all ways, and no mean normal says where to", "extrude",
                          "give a direction");
    return normalized(sum);
}

tree::SurfelTree treeOf(const surfel::SurfelList& list) {
    return list.size() > 0 ? tree::SurfelTree::build(list) : tree::SurfelTree();
}

/// Where a part borders on the rest of the model, laid onto its sharp edges. Throws base::Error where it does not.
struct Borders {
    std::vector<Loop> loops;
    std::vector<std::vector<std::uint8_t>> stands;
};

Borders bordersWithRest(const surface::Surface& surface, const Part& part, const surface::SurfaceDefinition& definition,
                        const base::Progress& progress) {
    constexpr std::size_t reach = 4; // of raggedness, in spacings
    const surface::Surface alone{tree::SurfelTree::build(part.surfels(true)), definition};
    const tree::SurfelTree rest = tree::SurfelTree::build(part.surfels(false));
    const std::vector<cells::SeamLine> seams = cells::seamLines(surface, process::part(progress, 0, 0.3));
    Borders out;
    for (const surface::BoundaryCurve& curve : bordersOf(alone, process::part(progress, 0.3, 0.6))) {
        Loop loop = evenLoop(alone, curve, 1, behind);
        straighten(loop, reach);
        layOnto(seams, loop);
        std::vector<std::uint8_t> where = besideRest(loop, rest);
        if (std::ranges::count(where, 1) == 0) // the model ends there, too
            continue;
        out.loops.push_back(std::move(loop));
        out.stands.push_back(std::move(where));
    }
    if (out.loops.empty())
        throw base::Error("what is selected has no border with the rest of the model", "extrude",
                          "select a part of it, or move it as a whole");
    return out;
}

/// What moved, and its walls, in the place of the part and of what walls cover.
tree::SurfelTree replaced(const tree::SurfelTree& tree, const Part& part, const std::vector<std::uint8_t>& covered,
                          const surfel::SurfelList& moved, const surfel::SurfelList& walls) {
    tree::Edit edit;
    edit.inserted = moved;
    edit.inserted.items.insert(edit.inserted.items.end(), walls.items.begin(), walls.items.end());
    edit.inserted.extra.insert(edit.inserted.extra.end(), walls.extra.begin(), walls.extra.end());
    std::size_t number = 0;
    tree.forEachBlock([&](std::uint32_t block, const SurfelBlock& content) {
        tree::BlockEdit change{block, {}, {}};
        for (int slot = 0; slot < content.size(); ++slot, ++number)
            change.removed[static_cast<std::size_t>(slot)] =
                part.holds(number) || (!covered.empty() && covered[number] != 0);
        if (change.removed.any())
            edit.blocks.push_back(change);
    });
    return tree.apply(edit);
}

/// Points drawn by chance took the foot of a wall for a rim.
surface::Surface endingWhere(const surface::Surface& surface, std::span<const Vec3d> rims) {
    return rims.empty() ? surface : process::endingAt(surface, rims);
}

} // namespace

Extruded extrudeSelected(const surface::Surface& surface, const tree::Selection& selected,
                         const ExtrudeOptions& options, const base::Progress& progress) {
    requireLength(options);
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " has nothing to extrude", "extrude",
                          "open the model as a surface");
    const base::CancelScope scope(progress.cancel);
    Part part(surface, selected);
    constexpr std::size_t fewest = 16;
    if (part.size() < fewest || surface.tree().size() < part.size() + fewest)
        throw base::Error("fewer than " + std::to_string(fewest) + " surfels are " +
                              (part.size() < fewest ? "selected" : "left beside what is selected"),
                          "extrude", part.size() < fewest ? "select more" : "move the whole model instead");
    surface::SurfaceDefinition definition = surface.definition();
    definition.boundary = surface::Boundary::Limit;
    definition.boundaryLimit = limitOfBorder;
    definition.knownRims = false; // borders with the rest are none of the whole's
    auto [loops, stands] = bordersWithRest(surface, part, definition, progress);
    takeSides(surface, loops, stands, part);

    surfel::SurfelList moved = part.surfels(true), walls;
    const Vec3d way = directionOf(moved, options) * options.length;
    const tree::SurfelTree left = tree::SurfelTree::build(part.surfels(false));
    const Crossings crossings =
        crossingsOf({{tree::SurfelTree::build(moved), definition}, {left, definition}, loops, stands, way},
                    process::part(progress, 0.6, 0.8));
    walls.layout = moved.layout;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        // walls go on from the rest, whose loop runs the other way
        Loop loop = loops[l];
        std::reverse(loop.points.begin(), loop.points.end());
        std::reverse(stands[l].begin(), stands[l].end());
        wallAlong(
            loop, [&](std::size_t) { return way; }, stands[l], left, surface.definition(), walls);
    }
    for (surfel::Surfel& s : moved.items)
        s.position = base::cast<float>(base::cast<double>(s.position) + way);
    std::vector<std::uint8_t> covered;
    const bool merges = options.merge && crossings.rays > 0;
    if (merges)
        takeLying(surface, part, left, walls, covered);
    Extruded out{{replaced(surface.tree(), part, covered, moved, walls), surface.definition()},
                 moved.size(),
                 walls.size(),
                 0,
                 crossings,
                 static_cast<std::size_t>(std::ranges::count(covered, 1))};
    out.surface = endingWhere(out.surface, rimsWithPart(surface, part, way, process::part(progress, 0.8, 0.85)));
    progress.step(0.85, "Sharpening edges");
    if (options.creases && surface.tree().layout()->oriented)
        out.surface = withEdges(out.surface, {treeOf(moved), treeOf(walls)}, out.atEdge);
    if (merges) {
        Combined whole = merged(out.surface, options.creases, process::part(progress, 0.85, 1), Overlaps::AndVoids);
        out.surface = std::move(whole.surface), out.inside += whole.removed, out.atEdge += whole.atSeam;
    }
    return out;
}

Extruded extrudeLoop(const surface::Surface& surface, std::optional<std::size_t> number, const ExtrudeOptions& options,
                     const base::Progress& progress) {
    requireLength(options);
    const base::CancelScope scope(progress.cancel);
    const std::vector<surface::BoundaryCurve> curves =
        openLoops(surface, "extrude", "has no boundary loops to extrude", process::part(progress, 0, 0.6));
    if (curves.empty())
        throw base::Error("the surface has no boundary loop", "extrude", "0 were found; they count from 0");
    if (!number && curves.size() > 1)
        throw base::Error(thereAreLoops(curves.size()) + ", and nothing says which one to extrude", "extrude",
                          "name one by number, the longest is 0");
    requireLoop(number.value_or(0), curves.size(), "extrude");
    const surface::BoundaryCurve& curve = curves[number.value_or(0)];
    const Loop loop = evenLoop(surface, curve, 1, behind);
    if (!curve.closed || touching({loop})[0])
        throw base::Error("boundary loop " + std::to_string(number.value_or(0)) +
                              (curve.closed ? " touches itself" : " does not close"),
                          "extrude", "choose another, or clean the model there");
    const auto way = [&](std::size_t i) {
        return (options.direction ? *options.direction : loop.points[i].normal) * options.length;
    };
    std::vector<Vec3d> ways;
    std::size_t back = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        ways.push_back(way(i));
        back += dot(normalized(way(i)), loop.points[i].outward) < -0.9 ? 1 : 0;
    }
    if (10 * back > loop.size())
        throw base::Error("the wall would lie on the surface that it begins at", "extrude", "choose another direction");
    surfel::SurfelList walls;
    walls.layout = surface.tree().layout();
    Loop edge = loop; // what a limit draws nearer or farther at the wall's foot it draws so at its other end, too
    const double beyond = pastEdge(surface.definition().boundaryLimit);
    for (std::size_t i = 0; i < edge.size(); ++i)
        edge.points[i].position -= normalized(ways[i]) * (beyond * edge.points[i].support);
    wallAlong(edge, way, {}, surface.tree(), surface.definition(), walls);
    tree::Edit edit;
    edit.inserted = walls;
    Extruded out{{surface.tree().apply(edit), surface.definition()}, 0, walls.size(), 0, {}, 0};
    out.crossings = crossingsOf(surface, loop, ways);
    out.surface = endingWhere(out.surface, rimsWithWall(surface, curves, number.value_or(0), loop, ways));
    progress.step(0.8, "Sharpening edges");
    if (options.creases && surface.tree().layout()->oriented)
        out.surface = withEdges(out.surface, {{}, treeOf(walls)}, out.atEdge);
    return out;
}

} // namespace solid
