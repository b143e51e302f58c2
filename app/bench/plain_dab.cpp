#include "app/bench/plain_dab.h"

namespace bench {

/// Of the radius.
constexpr float move = 0.05f, travel = 0.1f;

sculpt::Dab plainDab(const sculpt::ToolRow& row, const surfel::Surfel& at, float radius) {
    sculpt::Dab dab;
    dab.centre = dab.areaCentre = at.position;
    dab.normal = dab.areaNormal = base::normalized(at.normal, {0, 0, 1});
    dab.view = -dab.normal;
    dab.radius = radius;
    dab.strength = 0.5f;
    dab.move = dab.normal * (move * radius);
    dab.travel = base::perpendicular(dab.normal) * (travel * radius);
    dab.angle = travel;
    for (const sculpt::ToolParameter& parameter : row.parameters)
        dab.parameters[parameter.id] = parameter.fallback;
    return dab;
}

} // namespace bench
