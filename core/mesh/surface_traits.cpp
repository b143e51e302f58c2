#include "core/mesh/surface_traits.h"

#include "core/surface/definition.h"
#include "core/surface/frames/frame_table.h"
#include "core/surface/rims.h"

#include <cmath>
#include <numbers>

namespace mesh {

namespace {

double spacingsPerUnitOf(const surface::SurfaceDefinition& definition) {
    return definition.support > 0 ? surface::spacingOfUnit : std::sqrt(std::numbers::pi / definition.neighbours);
}

} // namespace

SurfaceTraits::SurfaceTraits(const surface::Surface& surface)
    : oriented(surface.tree().layout()->normals && surface.tree().layout()->oriented),
      closed(oriented && std::isinf(surface.definition().boundaryLimit)),
      sided(closed || (oriented && surface::knowsRims(surface))),
      continuous(surface::rowOf(surface.effectiveFrame()).solids || !surface.definition().oneSheet),
      distances(surface::rowOf(surface.effectiveFrame()).distance),
      spacingsPerUnit(spacingsPerUnitOf(surface.definition())) {}

} // namespace mesh
