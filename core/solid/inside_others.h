// Which surfels of a model lie inside of another part of it (solid/README 4.3).
#pragma once

#include "core/base/progress.h"
#include "core/tree/surfel_tree.h"

namespace solid {

/// True for those, and for those that lie on another part and face it; in tree order. In parallel. REQUIRES: oriented
/// normals. Throws base::Cancelled.
std::vector<std::uint8_t> insideOthers(const tree::SurfelTree& tree, const base::Progress& progress = {});

} // namespace solid
