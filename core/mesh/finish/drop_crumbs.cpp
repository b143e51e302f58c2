#include "core/mesh/finish/drop_crumbs.h"

#include "core/mesh/finish/drop_triangles.h"
#include "core/mesh/surface_traits.h"

#include <algorithm>
#include <cmath>

namespace mesh {

/// What a surfel covers of a plane, in an even layout with the spacing of its support.
static double areaOfSurfel(const surface::Surface& surface, const base::Vec3d& x) {
    std::vector<tree::Neighbour> nearest;
    surface.tree().nearest(base::cast<float>(x), 1, nearest);
    if (nearest.empty())
        return 0;
    const double spacing =
        static_cast<double>(nearest[0].block->support(nearest[0].slot)) * SurfaceTraits(surface).spacingsPerUnit;
    return spacing * spacing * std::sqrt(0.75);
}

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
        crumb.push_back(piece.open && piece.area < surfelsOfPiece * areaOfSurfel(surface, piece.place));
    const auto count = static_cast<std::size_t>(std::count(crumb.begin(), crumb.end(), true));
    if (count == 0 || count == crumb.size())
        return 0;
    keepTriangles(mesh, [&](std::size_t t) { return !crumb[pieces.pieceOf[t]]; });
    return count;
}

} // namespace mesh
