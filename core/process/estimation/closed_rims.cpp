#include "core/process/estimation/closed_rims.h"

#include <algorithm>
#include <cmath>

namespace process {

namespace {

constexpr double beyond = 0.3; ///< of h, from the rim outwards
constexpr double above = 0.75; ///< spacings, from the sheet outwards
/// How far a winding number is from a whole one. What opens at a fin's end is seen from there at an angle: less than
/// 0.12 of the whole turn up to a thickness of some 2 spacings.
constexpr double openEnd = 0.12, openSheet = 0.15;

/// What is thinner, in spacings, may end without a surfel on its end. (A neck this wide has surfels all around.)
constexpr double thickest = 2.6;
constexpr double facesAway = -0.5;      ///< cosine
constexpr double before = 0.3;          ///< spacings that a wall may seem to stand before its other side, by noise
constexpr std::size_t mostNearby = 256; ///< surfels, of which within `thickest` both walls have some 40

double spacingsPerUnitOf(const surface::SurfaceDefinition& definition) {
    return definition.support > 0 ? surface::spacingOfUnit : 1 / double(definition.unitInSpacings());
}

double unsure(double winding) {
    return std::abs(winding - std::round(winding));
}

} // namespace

ClosedRims::ClosedRims(const surface::Surface& surface, const base::Progress& progress)
    : m_tree(surface.tree()), m_winding(surface.tree(), progress, surface::Areas::Few),
      m_spacingsPerUnit(spacingsPerUnitOf(surface.definition())) {}

bool ClosedRims::hasWallBehind(const base::Vec3d& beside, const base::Vec3d& normal, double spacing) const {
    std::vector<tree::Neighbour> near;
    m_tree.nearest(base::cast<float>(beside), mostNearby, near, static_cast<float>(thickest * spacing));
    return std::any_of(near.begin(), near.end(), [&](const tree::Neighbour& each) {
        const base::Vec3d way = base::cast<double>(each.block->position(each.slot)) - beside;
        return dot(base::cast<double>(each.block->normal(each.slot)), normal) < facesAway &&
               dot(way, normal) < before * spacing;
    });
}

bool ClosedRims::closedAt(const surface::BoundaryPoint& rim, const base::Vec3d& beside,
                          const base::Vec3d& normal) const {
    const double spacing = m_spacingsPerUnit * rim.unit;
    return hasWallBehind(beside, normal, spacing) &&
           unsure(m_winding.at(rim.position + rim.outward * (beyond * rim.unit))) < openEnd &&
           unsure(m_winding.at(beside + normal * (above * spacing))) < openSheet;
}

} // namespace process
