// Batches in packets: consecutive positions share one neighbourhood; scattered ones are first put along a Morton curve.
#pragma once

#include "core/surface/source.h"

#include <functional>
#include <span>

namespace surface {

/// Calls fn(source, i) for every i in [0, x.size()), in parallel, with sources prepared for x[i] and up to `slack`
/// units of h around it. The order is chosen for speed; fn must not depend on it.
void forPackets(const Surface& surface, std::span<const base::Vec3f> x, float slack,
                const std::function<void(Source&, std::size_t)>& fn);

} // namespace surface
