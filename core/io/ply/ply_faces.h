// Faces of a PLY file: the element `face` with its list of vertex numbers, its colours and its places in pictures
// (`red green blue`, the list `texcoord` with `texnumber`), and strips of triangles, which some
// scanners' programs write instead.
#pragma once

#include "core/io/ply/ply_header.h"
#include "core/mesh/faces/polygons.h"

namespace io {

bool isFace(const PlyElement& element);
/// Strips: each further vertex makes a triangle with the two before it; -1 begins another strip.
bool isStrips(const PlyElement& element);

/// Of an element of either kind, whose records begin at `offset` of `body` and have been checked to be there. Corners
/// are as the file has them, or the largest number where that is none. Nothing where the element has no list of
/// vertices.
mesh::Polygons polygonsOf(const FileBytes& file, std::string_view body, const PlyElement& element, std::size_t offset,
                          bool bigEndian);

} // namespace io
