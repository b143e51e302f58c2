#include "core/mesh/marching/graded_cubes.h"

#include <algorithm>
#include <tuple>

namespace mesh {

/// fn(face, pairs, side of the cube) for the faces of a cube that have crossings.
template <class Fn>
static void forPairedFaces(const GradedGrid& grid, const CubeLevels::Cube& cube, const Fn& fn) {
    for (int axis = 0; axis < 3; ++axis)
        for (int above = 0; above < 2; ++above)
            grid.forFaces(cube, axis, above, [&](const GridFace& face) {
                if (face.count > 0)
                    fn(face, pairsOf(grid, face), 2 * axis + above);
            });
}

std::vector<LooseEnd> looseEnds(const GradedGrid& grid) {
    std::vector<LooseEnd> out;
    if (grid.traits().closed)
        return out;
    for (int level = 0; level <= grid.levels().highest(); ++level) {
        const SparseSet& cubes = grid.cubes(level);
        for (std::uint32_t b = 0; b < cubes.bricks().size(); ++b)
            cubes.forMembers(b, [&](const GridIndex& place, std::uint32_t) {
                forPairedFaces(grid, {place, level}, [&](const GridFace& face, const FacePairs& pairs, int) {
                    for (int i = 0; i < face.count; ++i)
                        if (pairs.partner[std::size_t(i)] < 0)
                            out.push_back({grid.rankOf(face.place), face.axis, face, i});
                });
            });
    }
    const auto key = [](const LooseEnd& end) { return std::tuple(end.node, end.axis, end.index); };
    std::sort(out.begin(), out.end(), [&](const LooseEnd& a, const LooseEnd& b) { return key(a) < key(b); });
    const auto same = [&](const LooseEnd& a, const LooseEnd& b) { return key(a) == key(b); };
    out.erase(std::unique(out.begin(), out.end(), same), out.end()); // both cubes beside a face have told
    return out;
}

bool hasLooseEnd(const GradedGrid& grid, const CubeLevels::Cube& cube) {
    bool any = false;
    forPairedFaces(grid, cube, [&](const GridFace& face, const FacePairs& pairs, int) {
        for (int i = 0; i < face.count; ++i)
            any = any || pairs.partner[std::size_t(i)] < 0;
    });
    return any;
}

void loopsOf(const GradedGrid& grid, const LooseEnds& loose, const CubeLevels::Cube& cube, std::vector<Loop>& out) {
    out.clear();
    LargeCubeGraph graph;
    forPairedFaces(grid, cube, [&](const GridFace& face, const FacePairs& pairs, int side) {
        for (int i = 0; i < face.count; ++i) {
            const std::uint32_t a = face.crossing[std::size_t(i)];
            const int j = pairs.partner[std::size_t(i)];
            if (j > i)
                graph.segment(a, face.crossing[std::size_t(j)], side);
            else if (j < 0) {
                const std::uint32_t b = loose.partner(grid.rankOf(face.place), face.axis, a);
                if (b >= grid.crossings().size() || a < b)
                    graph.segment(a, b, side);
            }
        }
    });
    graph.loops(out);
}

} // namespace mesh
