#include "core/mesh/faces/face_topology.h"

#include "core/base/box.h"
#include "core/base/disjoint_sets.h"
#include "core/base/parallel.h"
#include "core/mesh/faces/face_cells.h"
#include "core/mesh/faces/join_boundary.h"
#include "core/mesh/faces/turn_outwards.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace mesh {

namespace {

using base::Vec3d;
using base::Vec3f;

/// Of the extent: coordinates that differ by this came from one number, computed twice.
constexpr double roundOff = 5e-7;

constexpr std::int8_t repetition = std::numeric_limits<std::int8_t>::max();

/// Leaves out the others, with what is known of them.
template <class Which>
void keepFaces(FaceTopology& out, const Which& which) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < out.triangles.size(); ++t) {
        if (!which(t))
            continue;
        out.triangles[kept] = out.triangles[t], out.sources[kept] = out.sources[t];
        if (!out.normals.empty())
            out.normals[kept] = out.normals[t], out.areas[kept] = out.areas[t];
        ++kept;
    }
    out.triangles.resize(kept), out.sources.resize(kept);
    if (!out.normals.empty())
        out.normals.resize(kept), out.areas.resize(kept);
}

/// Leaves out triangles with two corners at one place: nothing of them is left but an edge, which others may need.
void leaveOutEdges(FaceTopology& out, const Places& places) {
    keepFaces(out, [&](std::size_t t) {
        const Triangle p = places.at(out.triangles[t]);
        return p[0] != p[1] && p[1] != p[2] && p[2] != p[0];
    });
}

/// Leaves out triangles whose three places another one before them has, in whatever order. Of each that stays: it
/// came more often its own way round (1), the other way (-1), or neither (0).
std::vector<std::int8_t> leaveOutRepetitions(FaceTopology& out, const Places& places) {
    struct Sorted {
        Triangle places;
        std::uint32_t triangle;
        auto operator<=>(const Sorted&) const = default;
    };
    std::vector<Sorted> all(out.triangles.size());
    base::parallelFor(all.size(), 8192, [&](std::size_t t) {
        all[t] = {places.at(out.triangles[t]), static_cast<std::uint32_t>(t)};
        std::sort(all[t].places.begin(), all[t].places.end());
    });
    std::sort(all.begin(), all.end());
    const auto isEven = [&](std::uint32_t t) { // does it run from its lowest place to the next one up?
        const Triangle p = places.at(out.triangles[t]);
        return (p[0] < p[1]) + (p[1] < p[2]) + (p[2] < p[0]) == 2;
    };
    std::vector<std::int8_t> given(all.size());
    for (std::size_t begin = 0, end; begin < all.size(); begin = end) {
        const std::uint32_t first = all[begin].triangle;
        int balance = 0;
        for (end = begin; end < all.size() && all[end].places == all[begin].places; ++end) {
            balance += isEven(all[end].triangle) == isEven(first) ? 1 : -1;
            given[all[end].triangle] = repetition;
        }
        given[first] = static_cast<std::int8_t>((balance > 0) - (balance < 0));
    }
    const std::size_t before = given.size();
    keepFaces(out, [&](std::size_t t) { return given[t] != repetition; });
    std::erase(given, repetition);
    out.repeated = before - given.size();
    return given;
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
}

void turn(FaceTopology& out, std::uint32_t t) {
    std::swap(out.triangles[t][1], out.triangles[t][2]);
    out.normals[t] = -out.normals[t];
}

/// Turns the faces of each piece the way in which most of its area is turned already, and tells which piece each
/// triangle belongs to.
FacePieces turnAlike(FaceTopology& out, std::span<const Vec3f> positions, const std::vector<FaceSide>& sides) {
    base::ParitySets pieces(out.triangles.size());
    std::vector<std::uint32_t> seams; // triangles
    forEdges(sides, [&](std::span<const FaceSide> edge) {
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
    forEdges(sides, [&](std::span<const FaceSide> edge) {
        for (std::size_t i = 0; i < edge.size(); ++i) { // the first of each piece counts for it
            const auto same = [&](const FaceSide& s) { return told.of[s.corner / 3] == told.of[edge[i].corner / 3]; };
            if (std::none_of(edge.begin(), edge.begin() + static_cast<std::ptrdiff_t>(i), same) &&
                std::count_if(edge.begin(), edge.end(), same) % 2 == 1)
                told.borders[told.of[edge[i].corner / 3]] += edgeLength(positions, edge[i].key);
        }
    });
    for (const std::uint32_t t : seams)
        told.borders[told.of[t]] = std::numeric_limits<double>::infinity();
    return told;
}

/// Leaves out faces that lie in the solid where three and more meet at an edge, and turns those alike that bound it.
void leaveOutInside(FaceTopology& out, std::span<const Vec3f> positions, const Places& places,
                    std::span<const std::int8_t> given) {
    const std::vector<FaceRole> roles =
        rolesOf({out.triangles, out.normals, out.areas, given, positions}, sidesOf(out.triangles, places), places);
    for (std::uint32_t t = 0; t < roles.size(); ++t)
        if (roles[t] == FaceRole::Turned)
            turn(out, t), ++out.reversed;
    out.inside = static_cast<std::size_t>(std::count(roles.begin(), roles.end(), FaceRole::Inside));
    for (std::uint32_t t = 0; t < roles.size(); ++t)
        if (roles[t] == FaceRole::Inside)
            out.insideCorners.insert(out.insideCorners.end(), out.triangles[t].begin(), out.triangles[t].end());
    if (out.inside > 0)
        keepFaces(out, [&](std::size_t t) { return roles[t] != FaceRole::Inside; });
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
    out.sealed.resize(facing.size());
    for (std::size_t piece = 0; piece < facing.size(); ++piece)
        out.sealed[piece] = facing[piece] != Facing::Open && pieces.borders[piece] == 0 ? 1 : 0;
    out.turnedOut = static_cast<std::size_t>(std::count(facing.begin(), facing.end(), Facing::Inwards));
}

void countEdges(FaceTopology& out, std::span<const Vec3f> positions, const std::vector<FaceSide>& sides) {
    forEdges(sides, [&](std::span<const FaceSide> edge) {
        const auto a = static_cast<std::uint32_t>(edge[0].key >> 32), b = static_cast<std::uint32_t>(edge[0].key);
        if (edge.size() == 1)
            out.borderEdges.push_back(
                {base::cast<double>(positions[a]), base::cast<double>(positions[b]), {a, b}, edge[0].corner});
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
SharpEdge sharpEdge(const FaceTopology& topology, std::span<const Vec3f> positions, const FaceSide& side,
                    std::uint32_t b, double turn) {
    const std::uint32_t a = side.corner;
    const auto at = [&](std::uint32_t corner, std::uint32_t further) {
        return base::cast<double>(positions[topology.triangles[corner / 3][(corner % 3 + further) % 3]]);
    };
    const Vec3d &n = topology.normals[a / 3], &m = topology.normals[b / 3];
    const double rise = dot(n, at(b, 2) - at(b, 0)) + dot(m, at(a, 2) - at(a, 0));
    const Vec3d low = base::cast<double>(positions[side.key >> 32]),
                high = base::cast<double>(positions[static_cast<std::uint32_t>(side.key)]);
    SharpEdge out{side.downwards ? high : low, side.downwards ? low : high, a / 3, b / 3, rise < 0, turn};
    out.ends[side.downwards ? 1 : 0] = static_cast<std::uint32_t>(side.key >> 32);
    out.ends[side.downwards ? 0 : 1] = static_cast<std::uint32_t>(side.key);
    return out;
}

/// What the other edges at the ends of sharp ones are.
void lookAtEnds(FaceTopology& out, std::span<const Vec3f> positions, const std::vector<FaceSide>& sides, double sharp) {
    if (out.sharpEdges.empty())
        return;
    struct Place {
        double length = 0, turn = 0;
        bool border = false;
    };
    std::vector<Place> there(positions.size());
    std::size_t edgeOfTwo = 0;
    forEdges(sides, [&](std::span<const FaceSide> edge) {
        const std::uint32_t ends[] = {static_cast<std::uint32_t>(edge[0].key >> 32),
                                      static_cast<std::uint32_t>(edge[0].key)};
        if (edge.size() != 2) {
            for (const std::uint32_t end : ends)
                there[end].border = true;
            return;
        }
        const auto turn = static_cast<double>(out.turns[edgeOfTwo++]);
        const double along = edgeLength(positions, edge[0].key);
        for (const std::uint32_t end : ends)
            if (!(turn > sharp)) {
                there[end].length += along;
                there[end].turn += along * turn;
            }
    });
    for (SharpEdge& edge : out.sharpEdges) {
        const Place &a = there[edge.ends[0]], &b = there[edge.ends[1]];
        edge.atBorder[0] = a.border, edge.atBorder[1] = b.border;
        const double length = a.length + b.length;
        edge.rough = length > 0 ? (a.turn + b.turn) / length : 0;
    }
}

/// The corners of both triangles at either end of a smooth edge belong to one fan, the triangles to one patch.
void joinSmooth(FaceTopology& out, std::span<const Vec3f> positions, const Places& places,
                const std::vector<FaceSide>& sides, double sharp) {
    out.patches.assign(out.triangles.size(), 0);
    out.fans.assign(3 * out.triangles.size(), 0);
    out.pieces.assign(out.triangles.size(), 0);
    base::DisjointSets patches(out.patches.size()), fans(out.fans.size()), pieces(out.pieces.size());
    double length = 0, sharpLength = 0;
    const auto next = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
    const auto placeOf = [&](std::uint32_t corner) { return places.of[out.triangles[corner / 3][corner % 3]]; };
    forEdges(sides, [&](std::span<const FaceSide> edge) {
        for (const FaceSide& side : edge.subspan(1))
            pieces.join(edge[0].corner / 3, side.corner / 3);
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
    out.pieceCount = numbered(pieces, out.pieces);
    out.fanCount = numbered(fans, out.fans);
}

/// The edges with an odd number of faces.
std::vector<std::uint64_t> boundaryEdges(const FaceTopology& topology, const Places& places) {
    std::vector<std::uint64_t> out;
    forEdges(sidesOf(topology.triangles, places), [&](std::span<const FaceSide> edge) {
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
    forEdges(sidesOf(out.triangles, places),
             [&](std::span<const FaceSide> edge) { out.bordersGiven += edge.size() % 2; });
    out.sources.resize(out.triangles.size());
    std::iota(out.sources.begin(), out.sources.end(), 0u);
    leaveOutEdges(out, places);
    if (out.triangles.empty())
        return out;
    const std::vector<std::int8_t> given = leaveOutRepetitions(out, places);
    measure(out, positions);
    leaveOutInside(out, positions, places, given);
    out.area = std::accumulate(out.areas.begin(), out.areas.end(), 0.0);
    turnOutwards(out, positions, turnAlike(out, positions, sidesOf(out.triangles, places)));
    const std::vector<FaceSide> sides = sidesOf(out.triangles, places); // the turned ones run the other way
    countEdges(out, positions, sides);
    joinSmooth(out, positions, places, sides, sharp);
    lookAtEnds(out, positions, sides, sharp);
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
    const std::vector<std::uint64_t> edges = boundaryEdges(out, places);
    if (joinBoundary(joined.of, positions, tolerance, edges, boundaryPlaces(edges)) && isBetter(joined))
        places = std::move(joined);
    if (out.borders == 0)
        return out;
    places.joints = teeJoints(positions, boundaryEdges(out, places), tolerance);
    if (!places.joints.empty())
        isBetter(places);
    return out;
}

} // namespace mesh
