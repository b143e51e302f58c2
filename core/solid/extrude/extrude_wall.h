// Surfels of a wall that a loop sweeps (solid/README 4.4). Inside this room only.
#pragma once

#include "core/solid/loops/loop.h"

#include <functional>

namespace solid {

/// Rows as dense as the loop's spacings, half a row from both ends, along `way` (of its length) from each place;
/// normals continue the surface beyond the loop. Words, colours and kinds of supports are those of the nearest surfels
/// of `beside`, masks 0. `stands`: of the loop's places, where there is a wall; all where it is empty. Throws
/// base::Error where surfels would be more than 20 million.
void wallAlong(const Loop& loop, const std::function<base::Vec3d(std::size_t place)>& way,
               const std::vector<std::uint8_t>& stands, const tree::SurfelTree& beside,
               const surface::SurfaceDefinition& definition, surfel::SurfelList& out);

} // namespace solid
