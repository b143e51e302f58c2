#include "core/process/estimation/closed_rims.h"

#include <cmath>

namespace process {

namespace {

constexpr double beyond = 0.3; ///< of h, from the rim outwards
constexpr double above = 0.75; ///< spacings, from the sheet outwards
/// How far a winding number is from a whole one. What opens at a fin's end is seen from there at an angle: less than
/// 0.12 of the whole turn up to a thickness of some 2 spacings.
constexpr double openEnd = 0.12, openSheet = 0.15;

double spacingsPerUnitOf(const surface::SurfaceDefinition& definition) {
    return definition.support > 0 ? surface::spacingOfUnit : 1 / double(definition.unitInSpacings());
}

double unsure(double winding) {
    return std::abs(winding - std::round(winding));
}

} // namespace

ClosedRims::ClosedRims(const surface::Surface& surface, const base::Progress& progress)
    : m_winding(surface.tree(), progress, surface::Areas::Few),
      m_spacingsPerUnit(spacingsPerUnitOf(surface.definition())) {}

bool ClosedRims::closedAt(const surface::BoundaryPoint& rim, const base::Vec3d& beside,
                          const base::Vec3d& normal) const {
    return unsure(m_winding.at(rim.position + rim.outward * (beyond * rim.unit))) < openEnd &&
           unsure(m_winding.at(beside + normal * (above * m_spacingsPerUnit * rim.unit))) < openSheet;
}

} // namespace process
