#include "core/mesh/faces/piece_spacings.h"

#include "core/mesh/faces/face_walls.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double leastCount = 100'000, mostForWalls = 1'000'000, mostCount = 5'000'000; ///< of all
constexpr double fewestOfPiece = 2000; ///< while all that have no more share this:
constexpr double fewestTriangles = 12; ///< of open pieces: leaves and crumbs of one or two have less to tell
constexpr double forSmallPieces = 400'000, forSmallOfCount = 0.5; ///< of a count that was asked for
constexpr double samplesOfProbe = 5;
constexpr double acrossWall = 3; ///< spacings
constexpr double finestForWalls =
    0.125; ///< of a piece's spacing. Where less than a 100th asks for less, it touches itself
constexpr std::size_t fewPlaces = 100;

struct Piece {
    double area = 0, volume = 0;
    std::size_t triangles = 0;
    bool closed = true;

    /// Samples that its mean thickness asks for. Walls of plates are twice the volume over the area.
    double forThickness() const {
        const double thickness = closed && area > 0 ? 2 * std::abs(volume) / area : 0;
        return thickness > 0 ? area / (thickness * thickness) * acrossWall * acrossWall : 0;
    }
};

std::vector<Piece> piecesOf(const FaceTopology& topology, std::span<const Vec3f> positions) {
    std::vector<Piece> out(topology.pieceCount);
    std::vector<Vec3d> origins(topology.pieceCount);
    for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
        Piece& piece = out[topology.pieces[t]];
        Vec3d& origin = origins[topology.pieces[t]];
        const auto corner = [&](std::size_t k) { return base::cast<double>(positions[topology.triangles[t][k]]); };
        if (piece.triangles++ == 0)
            origin = corner(0);
        piece.area += topology.areas[t];
        piece.volume += dot(corner(0) - origin, cross(corner(1) - origin, corner(2) - origin)) / 6;
        piece.closed = piece.closed && topology.bodies[t] != noBody;
    }
    return out;
}

/// The most that each may have so that all have no more than `most`: who wants less gets it.
double levelFor(std::vector<double> wanted, double most) {
    std::sort(wanted.begin(), wanted.end());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const double each = most / static_cast<double>(wanted.size() - i);
        if (wanted[i] > each)
            return each;
        most -= wanted[i];
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

PieceSpacings pieceSpacings(const FaceTopology& topology, std::span<const Vec3f> positions, const InnerPlaces& inside,
                            std::size_t count, const base::Progress& progress) {
    const std::vector<Piece> pieces = piecesOf(topology, positions);
    const double asked = count > 0 ? static_cast<double>(count) : leastCount;
    const double evenly = topology.area * inside.outerShare() / asked; // area of a sample
    const double small = count > 0 ? asked * forSmallOfCount : forSmallPieces;
    const double fewest = std::min(fewestOfPiece, small / static_cast<double>(pieces.size()));
    std::vector<double> counts, thick;
    PieceSpacings out;
    std::vector<double> probes;
    const auto spacingOf = [](const Piece& piece, double samples) {
        return piece.area > 0 ? std::sqrt(piece.area / samples) : std::numeric_limits<double>::infinity();
    };
    for (const Piece& piece : pieces) {
        const double triangles = count > 0 ? 0 : static_cast<double>(piece.triangles);
        const double shape = piece.closed ? 1 : std::min(1.0, static_cast<double>(piece.triangles) / fewestTriangles);
        counts.push_back(std::max({piece.area / evenly, fewest * shape, triangles}));
        probes.push_back(spacingOf(piece, counts.back() / samplesOfProbe));
        thick.push_back(count > 0 ? 0 : piece.forThickness());
    }
    const FaceDensity sparse(topology, positions, probes);
    const double all = sparse.samples(&inside);
    const std::vector<FacePoint> points =
        spreadPoints(topology, positions, static_cast<std::size_t>(std::max(4.0, std::min(all, mostCount))),
                     process::part(progress, 0, 0.5), {&inside, &sparse, {}, false});
    const std::vector<float> walls = wallsBehind(topology, positions, points, probes, process::part(progress, 0.5, 1));
    const double most = levelFor(thick, mostForWalls);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        out.spacings.push_back(spacingOf(pieces[i], std::max(counts[i], std::min(thick[i], most))));
    std::vector<std::size_t> placesOf(pieces.size()), foils(pieces.size());
    const auto wanted = [&](std::size_t i) { return static_cast<double>(walls[i]) / acrossWall; };
    const auto finest = [&](std::uint32_t piece) { return finestForWalls * out.spacings[piece]; };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t piece = topology.pieces[points[i].triangle];
        out.places.push_back({placeOf(points[i], topology, positions), out.spacings[piece], probes[piece]});
        out.walls.push_back({walls[i], piece});
        ++placesOf[piece];
        foils[piece] += wanted(i) < finest(piece) ? 1 : 0;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t piece = out.walls[i].piece;
        const bool foil = wanted(i) < finest(piece), fewFoils = foils[piece] * fewPlaces < placesOf[piece];
        if (wanted(i) < out.spacings[piece] && !(foil && fewFoils))
            out.finer.push_back({out.places[i].place, std::max(wanted(i), finest(piece)), probes[piece]});
    }
    return out;
}

double mostSamplesOf(const FaceTopology& topology, std::span<const double> spacings) {
    double out = 0;
    for (std::size_t t = 0; t < topology.triangles.size(); ++t)
        if (const double s = spacings[topology.pieces[t]]; topology.areas[t] > 0)
            out += topology.areas[t] / (s * s);
    return std::clamp(2 * out, mostForWalls, mostCount);
}

} // namespace mesh
