// A surface with other labels: what the makers of creases end in.
#pragma once

#include "core/cells/labels.h"
#include "core/surface/surface.h"

namespace cells {

/// Throws base::Error where normals tell no sides, of curves, and of models without surfels.
void requireSides(const surface::Surface& surface);

/// The labels of its surfels, in the order of the tree; those of one cell where there are none.
std::vector<Label> labelsOf(const tree::SurfelTree& tree);

/// `surfels` are those of the surface in the order of its tree, with other normals and labels at most. Throws
/// base::Error where an attribute of a label's name holds something else.
surface::Surface labelled(const surface::Surface& surface, surfel::SurfelList surfels, std::span<const Label> labels);

/// Without labels. Attributes stay that other programs may have called so.
surface::Surface unlabelled(const surface::Surface& surface);

} // namespace cells
