// The shape of the tree that a native file was saved from, as its last element: one record of three lists, which other
// programs pass over (io/README 2.3).
#pragma once

#include "core/io/ply/ply_header.h"
#include "core/tree/tree_shape.h"

namespace io {

bool isTreeShape(const PlyElement& element);

/// `body`: the element in little-endian binary, its extent having been checked. Empty where it is not as we write it.
tree::TreeShape treeShapeOf(const FileBytes& file, const PlyElement& element, std::string_view body);

/// Header lines and record; nothing for an empty shape.
std::string treeShapeDeclaration(const tree::TreeShape& shape);
std::string treeShapeBody(const tree::TreeShape& shape);

} // namespace io
