// A model cut flat: half of it goes, and a cap closes what is left (solid/README 2.4).
#pragma once

#include "core/base/plane.h"
#include "core/solid/combine.h"

namespace solid {

struct CutOptions {
    bool cap = true;     ///< else what is left ends in a boundary at the plane
    bool creases = true; ///< the cap's edge stays sharp
};

/// Keeps what lies on the plane's positive side. The cap is as dense as the model is beside it, place for place. Throws
/// as combine does, for a cap only where the model has normals that tell inside from outside.
Combined cutByPlane(const surface::Surface& model, const base::Plane& plane, const CutOptions& options = {},
                    const base::Progress& progress = {});

/// Without a cap: what is on the side `gone` (1: outside, -1: inside; `sides` as sidesOf tells them) goes, and the
/// model ends there.
Combined leftOpen(const surface::Surface& model, std::span<const std::int8_t> sides, int gone,
                  const base::Progress& progress = {});

} // namespace solid
