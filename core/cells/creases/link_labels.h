// Labels from cells and the links that creases cut between them (cells/README 6.3): partners, signs, sharpness.
#pragma once

#include "core/cells/creases/surfel_links.h"
#include "core/cells/labels.h"

namespace cells {

/// Of a surfel with a link cut between its cell and another one within two spacings, nearer than the crease that its
/// label tells of: that cell as partner, the sign, and `sharpness` (0 to 1), less where few of the links between both
/// cells are cut: a crease fades where it ends. Labels of other surfels stay as they are but for cell and face. In
/// parallel.
void labelByLinks(const SurfelLinks& links, std::span<const std::uint32_t> cells, std::span<const std::uint32_t> faces,
                  std::span<const base::Vec3f> normals, double sharpness, std::span<Label> labels);

} // namespace cells
