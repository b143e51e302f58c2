// Which surfels of a model lie inside of another part of it (solid/README 4.3).
#pragma once

#include "core/base/progress.h"
#include "core/tree/surfel_tree.h"

namespace solid {

/// What overlaps: matter with matter alone, or also what was taken away with what there was nothing of, as where a part
/// was pushed in and out on the other side.
enum class Overlaps { OfMatter, AndVoids };

/// True for those, and for those that lie on another part and face it; in tree order. In parallel. REQUIRES: oriented
/// normals. Throws base::Cancelled.
std::vector<std::uint8_t> insideOthers(const tree::SurfelTree& tree, const base::Progress& progress = {},
                                       Overlaps overlaps = Overlaps::OfMatter);

} // namespace solid
