#include "core/selection/links.h"

namespace selection {

/// In spacings: over the diagonal of a square of neighbours and a missing one, not to the second row beyond.
constexpr float linkSpacings = 2.2f;

float spacingsPerSupport(const surface::SurfaceDefinition& definition) {
    const float kernel = definition.weight == surface::Weight::Gaussian
                             ? surface::gaussianReach * surface::gaussianScale // support to that of a Wendland kernel
                             : 1.0f;
    return 1 / (kernel * definition.unitInSpacings());
}

float Links::reachOf(const surface::SurfaceDefinition& definition) {
    return linkSpacings * spacingsPerSupport(definition);
}

} // namespace selection
