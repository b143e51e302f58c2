#include "core/mesh/finish/drop_crumbs.h"

#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/surface_traits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace mesh {

namespace {

constexpr std::size_t surfelsOfBody = 4; ///< a closed one of at least
constexpr double onSurface = 0.25;       ///< of their spacing

/// The nearest surfel of a place.
struct Nearest {
    tree::Neighbour surfel;
    double spacing = 0; ///< of its support, in an even layout
};

Nearest nearestOf(const surface::Surface& surface, const base::Vec3d& x) {
    std::vector<tree::Neighbour> nearest;
    surface.tree().nearest(base::cast<float>(x), 1, nearest);
    if (nearest.empty())
        return {};
    return {nearest[0],
            static_cast<double>(nearest[0].block->support(nearest[0].slot)) * SurfaceTraits(surface).spacingsPerUnit};
}

/// What a surfel covers of a plane.
double areaOfSurfel(const surface::Surface& surface, const base::Vec3d& x) {
    const double spacing = nearestOf(surface, x).spacing;
    return spacing * spacing * std::sqrt(0.75);
}

/// Do enough surfels lie on these corners for a body of its own? Beyond acute edges and at folds f has small closed
/// zeros that no surfel made.
bool isBodyOfSurfels(const surface::Surface& surface, const std::set<std::uint32_t>& corners, const Mesh& mesh) {
    std::set<std::pair<const void*, int>> on;
    for (const std::uint32_t v : corners)
        if (const Nearest near = nearestOf(surface, mesh.positions[v]);
            near.spacing > 0 && std::sqrt(static_cast<double>(near.surfel.distanceSq)) < onSurface * near.spacing)
            on.emplace(near.surfel.block, near.surfel.slot);
    return on.size() >= surfelsOfBody;
}

} // namespace

std::size_t dropCrumbs(Mesh& mesh, const Orientation& pieces, const surface::Surface& surface) {
    struct Piece {
        double area = 0;
        bool open = false;
        base::Vec3d place; ///< of one of its corners
    };
    std::vector<Piece> found(pieces.pieceSizes.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& corners = mesh.triangles[t];
        Piece& piece = found[pieces.pieceOf[t]];
        piece.place = mesh.positions[corners[0]];
        piece.area +=
            0.5 * length(cross(mesh.positions[corners[1]] - piece.place, mesh.positions[corners[2]] - piece.place));
        for (const std::uint32_t v : corners)
            piece.open |= mesh.kinds[v] == VertexKind::Limit || mesh.kinds[v] == VertexKind::Fold;
    }
    std::vector<bool> crumb;
    for (const Piece& piece : found)
        crumb.push_back(piece.area < surfelsOfPiece * areaOfSurfel(surface, piece.place));
    std::map<std::size_t, std::set<std::uint32_t>> closed; // corners of small ones
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (const std::size_t piece = pieces.pieceOf[t]; crumb[piece] && !found[piece].open)
            closed[piece].insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    for (const auto& [piece, corners] : closed)
        crumb[piece] = !isBodyOfSurfels(surface, corners, mesh);
    const auto count = static_cast<std::size_t>(std::count(crumb.begin(), crumb.end(), true));
    if (count == 0 || count == crumb.size())
        return 0;
    keepTriangles(mesh, [&](std::size_t t) { return !crumb[pieces.pieceOf[t]]; });
    return count;
}

} // namespace mesh
