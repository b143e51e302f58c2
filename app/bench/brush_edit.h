// Edits at a brush: the surfels nearest to a place go, as many others come.
#pragma once

#include "app/bench/scene.h"

namespace bench {

/// Surfels removed and inserted by one edit, fewer on small models.
constexpr std::size_t brushEditSurfels = 1000;

struct BrushEdit {
    tree::Edit edit;
    std::vector<base::Vec3f> removed; ///< where the surfels that go are
};

/// The nearest surfels around `place` are replaced by ones scattered over the tangent disc that they fill.
BrushEdit brushEdit(const tree::SurfelTree& version, const surfel::Surfel& place, std::uint64_t seed);

} // namespace bench
