// The force that a tool feels: a spring from the proxy to the tool, a damper along the contact's normal, force shading
// and texture (haptics/README 3). Forces are in units of stiffness times length.
#pragma once

#include "core/haptics/texture.h"

namespace haptics {

struct ForceLaw {
    double stiffness = 1; ///< force per length between proxy and tool
    double damping = 0;   ///< force per speed along the normal, in contact; it never pulls the tool in
    /// Radius in units of h of the spot over which the normal is averaged [Morgenbesser96]; 0: the exact normal. Edges
    /// feel rounder than they are.
    double shading = 0;
    Texture texture = {};
    bool operator==(const ForceLaw&) const = default;
};

/// Zero where the proxy does not touch. `x` and `velocity` are the tool's.
base::Vec3d forceOn(const ForceLaw& law, const Proxy& proxy, const surface::Surface& surface, const base::Vec3d& x,
                    const base::Vec3d& velocity);

} // namespace haptics
