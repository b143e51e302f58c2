// What is felt of a surface beside its shape: where it is rough or light it pushes back harder, where it is hollow or
// dark it gives way (haptics/README 3.1). A factor on the stiffness, so that force still begins at zero and has a
// potential.
#pragma once

#include "core/haptics/proxy.h"

namespace haptics {

/// Each 0 to 1: which part of the stiffness comes and goes.
struct Texture {
    double relief = 0; ///< with how high the surface is above what is around it within h
    double colour = 0; ///< with how light it is
    bool none() const { return relief == 0 && colour == 0; }
    bool operator==(const Texture&) const = default;
};

/// At the contacts of a proxy.
struct Grain {
    double factor = 1; ///< of the stiffness, 0 to 2
    base::Vec3d slope; ///< how the factor changes with the tool's place, per length
    double felt = 0;   ///< depth up to which it is one of the stiffness: what is deeper says no more of a surface
};

Grain grainAt(const Texture& texture, const Proxy& proxy, const surface::Surface& surface);

} // namespace haptics
