// Surfels of a version taken out or changed, told as lists in tree order, as an Edit: blocks in which nothing differs
// stay shared, and undo costs what changed.
#pragma once

#include "core/tree/surfel_tree.h"

namespace process {

/// Lists hold one entry per surfel in tree order, or none where nothing changes.
struct ListChange {
    std::vector<std::uint8_t> removed;
    std::vector<base::Vec3f> positions, normals;
    std::vector<float> supports;
    surfel::AttributeLayoutPtr layout; ///< of the new version, same words; null: as it was
};

/// Throws nothing; an unchanged list gives the same tree.
tree::SurfelTree changed(const tree::SurfelTree& tree, const ListChange& change);

} // namespace process
