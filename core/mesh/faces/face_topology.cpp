#include "core/mesh/faces/face_topology.h"

#include "core/base/box.h"
#include "core/base/cells.h"
#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/mesh/faces/tee_joints.h"
#include "core/mesh/faces/turn_outwards.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace mesh {

namespace {

using base::Vec3d;
using base::Vec3f;

/// Which vertices are one, and which of these lie on sides of triangles that they are no corners of.
struct Places {
    std::vector<std::uint32_t> of; ///< of each vertex: the first that stands for all at its place
    TeeJoints joints;
};

/// The side of a triangle from corner `corner` to the next, or a part of it between places that lie on it.
struct Side {
    std::uint64_t key;    ///< the lower place, then the higher
    std::uint32_t corner; ///< 3 t + k
    bool downwards;       ///< runs from the higher place to the lower
};

/// The first vertex at the same place, for every vertex.
std::vector<std::uint32_t> placesOf(std::span<const Vec3f> positions) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), none), out(positions.size());
    const std::size_t mask = slots.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t hash = 0;
        for (std::size_t k = 0; k < 3; ++k)
            hash = base::mix(hash ^ std::bit_cast<std::uint32_t>(positions[i][k] + 0.0f)); // -0 is 0
        std::size_t slot = hash & mask;
        while (slots[slot] != none && positions[slots[slot]] != positions[i])
            slot = (slot + 1) & mask;
        if (slots[slot] == none)
            slots[slot] = i;
        out[i] = slots[slot];
    }
    return out;
}

/// Of the extent: coordinates that differ by this came from one number, computed twice.
constexpr double roundOff = 5e-7;

/// Joins places on the boundary that are the same but for round-off: the first of them stands for all. False where
/// there are none.
bool joinBoundary(std::vector<std::uint32_t>& places, std::span<const Vec3f> positions, double tolerance,
                  const std::vector<std::uint32_t>& boundary) {
    const Vec3d origin = base::cast<double>(positions[boundary.front()]);
    base::CellMap<std::vector<std::uint32_t>> cells;
    std::vector<std::uint32_t> joined(places.size());
    std::iota(joined.begin(), joined.end(), 0u);
    bool any = false;
    for (const std::uint32_t place : boundary) {
        const Vec3d p = base::cast<double>(positions[place]);
        const base::Cell cell = base::cellOf(p, origin, 1 / tolerance);
        base::forCellsAround(cell, [&](const base::Cell& near) {
            if (const auto* found = cells.find(near); found && joined[place] == place)
                for (const std::uint32_t other : *found)
                    if (distance(base::cast<double>(positions[other]), p) <= tolerance)
                        joined[place] = other;
        });
        if (joined[place] == place)
            cells.at(cell).push_back(place);
        else
            any = true;
    }
    for (std::uint32_t& place : places)
        place = joined[place];
    return any;
}

Triangle at(const std::vector<std::uint32_t>& places, const Triangle& t) {
    return {places[t[0]], places[t[1]], places[t[2]]};
}

/// Leaves out triangles whose three places another one before them has, in whatever order.
void leaveOutRepetitions(FaceTopology& out, const std::vector<std::uint32_t>& places) {
    struct Sorted {
        Triangle places;
        std::uint32_t triangle;
        auto operator<=>(const Sorted&) const = default;
    };
    std::vector<Sorted> all(out.triangles.size());
    base::parallelFor(all.size(), 8192, [&](std::size_t t) {
        all[t] = {at(places, out.triangles[t]), static_cast<std::uint32_t>(t)};
        std::sort(all[t].places.begin(), all[t].places.end());
    });
    std::sort(all.begin(), all.end());
    std::vector<std::uint8_t> twice(all.size());
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].places == all[i - 1].places)
            twice[all[i].triangle] = 1;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < all.size(); ++t)
        if (!twice[t]) {
            out.sources.push_back(static_cast<std::uint32_t>(t));
            out.triangles[kept++] = out.triangles[t];
        }
    out.repeated = out.triangles.size() - kept;
    out.triangles.resize(kept);
}

void measure(FaceTopology& out, std::span<const Vec3f> positions) {
    out.normals.resize(out.triangles.size());
    out.areas.resize(out.triangles.size());
    base::parallelFor(out.triangles.size(), 4096, [&](std::size_t t) {
        const auto p = [&](std::size_t k) { return base::cast<double>(positions[out.triangles[t][k]]); };
        const Vec3d sides = cross(p(1) - p(0), p(2) - p(0));
        out.areas[t] = length(sides) / 2;
        out.normals[t] = normalized(sides);
    });
    out.area = std::accumulate(out.areas.begin(), out.areas.end(), 0.0);
}

std::uint64_t keyOf(std::uint64_t a, std::uint64_t b) {
    return std::min(a, b) << 32 | std::max(a, b);
}

std::vector<Side> sidesOf(const FaceTopology& topology, const Places& places) {
    std::vector<Side> out;
    out.reserve(3 * topology.triangles.size());
    for (std::uint32_t t = 0; t < topology.triangles.size(); ++t) {
        const Triangle corners = at(places.of, topology.triangles[t]);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint64_t a = corners[k], b = corners[(k + 1) % 3], key = keyOf(a, b);
            if (a == b)
                continue;
            const auto joints = places.joints.empty() ? places.joints.end() : places.joints.find(key);
            if (joints == places.joints.end()) {
                out.push_back({key, 3 * t + k, a > b});
                continue;
            }
            std::uint64_t from = std::min(a, b);
            const auto part = [&](std::uint64_t to) {
                out.push_back({keyOf(from, to), 3 * t + k, (a > b) != (from > to)});
                from = to;
            };
            for (const std::uint32_t place : joints->second)
                part(place);
            part(std::max(a, b));
        }
    }
    std::sort(out.begin(), out.end(),
              [](const Side& a, const Side& b) { return a.key != b.key ? a.key < b.key : a.corner < b.corner; });
    return out;
}

/// Between the two places of an edge.
double edgeLength(std::span<const Vec3f> positions, std::uint64_t key) {
    return distance(base::cast<double>(positions[key >> 32]),
                    base::cast<double>(positions[static_cast<std::uint32_t>(key)]));
}

/// fn(sides) for every edge: the sides of the triangles that meet in it.
template <class Fn>
void forEdges(const std::vector<Side>& sides, const Fn& fn) {
    for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
        for (end = begin + 1; end < sides.size() && sides[end].key == sides[begin].key;)
            ++end;
        fn(std::span(sides).subspan(begin, end - begin));
    }
}

void turn(FaceTopology& out, std::uint32_t t) {
    std::swap(out.triangles[t][1], out.triangles[t][2]);
    out.normals[t] = -out.normals[t];
}

/// Turns the faces of each piece the way in which most of its area is turned already, and tells which piece each
/// triangle belongs to.
FacePieces turnAlike(FaceTopology& out, std::span<const Vec3f> positions, const std::vector<Side>& sides) {
    base::ParitySets pieces(out.triangles.size());
    std::vector<std::uint32_t> seams; // triangles
    forEdges(sides, [&](std::span<const Side> edge) {
        if (edge.size() != 2)
            return;
        const bool opposed = edge[0].downwards == edge[1].downwards;
        if (!pieces.relate(edge[0].corner / 3, edge[1].corner / 3, opposed))
            seams.push_back(edge[0].corner / 3);
    });
    out.oneSided = !seams.empty();
    std::vector<double> balance(out.triangles.size());
    for (std::uint32_t t = 0; t < out.triangles.size(); ++t) {
        const auto [root, turned] = pieces.find(t);
        balance[root] += turned ? -out.areas[t] : out.areas[t];
    }
    FacePieces told;
    told.of.resize(out.triangles.size());
    std::uint32_t count = 0;
    for (std::uint32_t t = 0; t < out.triangles.size(); ++t) {
        const auto [root, turned] = pieces.find(t);
        told.of[t] = root == t ? count++ : told.of[root]; // the root is the smallest
        if (turned == (balance[root] < 0))
            continue;
        turn(out, t);
        ++out.reversed;
    }
    told.borders.resize(count);
    forEdges(sides, [&](std::span<const Side> edge) {
        for (std::size_t i = 0; i < edge.size(); ++i) { // the first of each piece counts for it
            const auto same = [&](const Side& s) { return told.of[s.corner / 3] == told.of[edge[i].corner / 3]; };
            if (std::none_of(edge.begin(), edge.begin() + static_cast<std::ptrdiff_t>(i), same) &&
                std::count_if(edge.begin(), edge.end(), same) % 2 == 1)
                told.borders[told.of[edge[i].corner / 3]] += edgeLength(positions, edge[i].key);
        }
    });
    for (const std::uint32_t t : seams)
        told.borders[told.of[t]] = std::numeric_limits<double>::infinity();
    return told;
}

/// Turns pieces that are inside out.
void turnOutwards(FaceTopology& out, std::span<const Vec3f> positions, const FacePieces& pieces) {
    const std::vector<Facing> facing = facingOf(pieces, out.triangles, out.areas, positions);
    out.bodies.resize(out.triangles.size());
    for (std::uint32_t t = 0; t < out.triangles.size(); ++t) {
        const std::uint32_t piece = pieces.of[t];
        out.bodies[t] = facing[piece] == Facing::Open ? noBody : piece;
        if (facing[piece] == Facing::Inwards)
            turn(out, t);
    }
    out.turnedOut = static_cast<std::size_t>(std::count(facing.begin(), facing.end(), Facing::Inwards));
}

void countEdges(FaceTopology& out, const std::vector<Side>& sides) {
    forEdges(sides, [&](std::span<const Side> edge) {
        out.borders += edge.size() % 2;
        out.nonManifold += edge.size() > 2 ? 1 : 0;
    });
}

/// Numbers for the sets of a union, in the order of their first members; returns how many there are.
std::size_t numbered(base::DisjointSets& sets, std::vector<std::uint32_t>& out) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < out.size(); ++i) {
        const std::uint32_t root = sets.find(i); // the smallest member
        out[i] = root == i ? count++ : out[root];
    }
    return count;
}

/// Of the sides that begin at corners a and b: which way the edge is bent tells where the other triangle goes from
/// there.
SharpEdge sharpEdge(const FaceTopology& topology, std::span<const Vec3f> positions, const Side& side, std::uint32_t b,
                    double turn) {
    const std::uint32_t a = side.corner;
    const auto at = [&](std::uint32_t corner, std::uint32_t further) {
        return base::cast<double>(positions[topology.triangles[corner / 3][(corner % 3 + further) % 3]]);
    };
    const Vec3d &n = topology.normals[a / 3], &m = topology.normals[b / 3];
    const double rise = dot(n, at(b, 2) - at(b, 0)) + dot(m, at(a, 2) - at(a, 0));
    const Vec3d low = base::cast<double>(positions[side.key >> 32]),
                high = base::cast<double>(positions[static_cast<std::uint32_t>(side.key)]);
    return {side.downwards ? high : low, side.downwards ? low : high, a / 3, b / 3, rise < 0, turn};
}

/// The corners of both triangles at either end of a smooth edge belong to one fan, the triangles to one patch.
void joinSmooth(FaceTopology& out, std::span<const Vec3f> positions, const Places& places,
                const std::vector<Side>& sides, double sharp) {
    out.patches.assign(out.triangles.size(), 0);
    out.fans.assign(3 * out.triangles.size(), 0);
    base::DisjointSets patches(out.patches.size()), fans(out.fans.size());
    double length = 0, sharpLength = 0;
    const auto next = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    const auto placeOf = [&](std::uint32_t corner) { return places.of[out.triangles[corner / 3][corner % 3]]; };
    forEdges(sides, [&](std::span<const Side> edge) {
        if (edge.size() != 2)
            return;
        const std::uint32_t a = edge[0].corner, b = edge[1].corner;
        const Vec3d &n = out.normals[a / 3], &m = out.normals[b / 3];
        const double turn = std::atan2(base::length(cross(n, m)), dot(n, m)); // 0 beside a face without area
        const double along = edgeLength(positions, edge[0].key);
        out.turns.push_back(static_cast<float>(turn));
        length += along;
        if (turn > sharp) {
            sharpLength += along;
            out.sharpEdges.push_back(sharpEdge(out, positions, edge[0], b, turn));
            return;
        }
        const bool against = edge[0].downwards != edge[1].downwards;
        patches.join(a / 3, b / 3);
        const auto meet = [&](std::uint32_t c, std::uint32_t d) { // parts of sides may end between corners
            if (placeOf(c) == placeOf(d))
                fans.join(c, d);
        };
        meet(a, against ? next(b) : b);
        meet(next(a), against ? b : next(b));
    });
    out.sharpShare = length > 0 ? sharpLength / length : 0;
    out.patchCount = numbered(patches, out.patches);
    out.fanCount = numbered(fans, out.fans);
}

/// The edges with an odd number of faces.
std::vector<std::uint64_t> boundaryEdges(const FaceTopology& topology, const Places& places) {
    std::vector<std::uint64_t> out;
    forEdges(sidesOf(topology, places), [&](std::span<const Side> edge) {
        if (edge.size() % 2 == 1)
            out.push_back(edge[0].key);
    });
    return out;
}

/// The places at which they end, each once, ascending.
std::vector<std::uint32_t> boundaryPlaces(const std::vector<std::uint64_t>& edges) {
    std::vector<std::uint32_t> out;
    for (const std::uint64_t edge : edges) {
        out.push_back(static_cast<std::uint32_t>(edge >> 32));
        out.push_back(static_cast<std::uint32_t>(edge));
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

FaceTopology topologyOf(std::span<const Vec3f> positions, std::span<const Triangle> triangles, double sharp,
                        const Places& places) {
    FaceTopology out;
    out.triangles.assign(triangles.begin(), triangles.end());
    if (out.triangles.empty())
        return out;
    forEdges(sidesOf(out, places), [&](std::span<const Side> edge) { out.bordersGiven += edge.size() % 2; });
    leaveOutRepetitions(out, places.of);
    measure(out, positions);
    turnOutwards(out, positions, turnAlike(out, positions, sidesOf(out, places)));
    const std::vector<Side> sides = sidesOf(out, places); // the turned ones run the other way
    countEdges(out, sides);
    joinSmooth(out, positions, places, sides, sharp);
    return out;
}

} // namespace

FaceTopology faceTopology(std::span<const Vec3f> positions, std::span<const Triangle> triangles, double sharp) {
    Places places{placesOf(positions), {}};
    FaceTopology out = topologyOf(positions, triangles, sharp, places);
    base::Box3f box;
    for (const Vec3f& p : positions)
        box.extend(p);
    const double tolerance = roundOff * static_cast<double>(box.diagonal());
    const auto isBetter = [&](const Places& other) {
        FaceTopology found = topologyOf(positions, triangles, sharp, other);
        if (found.borders >= out.borders)
            return false;
        out = std::move(found);
        return true;
    };
    if (out.borders == 0 || !(tolerance > 0))
        return out;
    Places joined = places;
    if (joinBoundary(joined.of, positions, tolerance, boundaryPlaces(boundaryEdges(out, places))) && isBetter(joined))
        places = std::move(joined);
    if (out.borders == 0)
        return out;
    places.joints = teeJoints(positions, boundaryEdges(out, places), tolerance);
    if (!places.joints.empty())
        isBetter(places);
    return out;
}

} // namespace mesh
