// What cells ask of the way back: which places of a cell the others leave it, and labels of samples that are closer
// together than those of the model (reduce/README 8.1). Internal to the room.
#pragma once

#include "core/cells/cell_surface.h"
#include "core/reduce/places.h"

namespace reduce {

/// Leaves the places that are surface, of those on the surface of one cell alone. In parallel.
void keepOnFace(const cells::CellSurface& surface, std::uint32_t cell, Places& places);

/// Partners and signs from the model's own seams, within two spacings; cells, faces and sharpness stay. In parallel.
void labelBySeams(const cells::CellSurface& surface, float spacing, surfel::SurfelList& surfels);

} // namespace reduce
