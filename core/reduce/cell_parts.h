// Cells of a model taken out, each as a model of its own, and put together again. Internal to the room.
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace reduce {

struct Cell {
    surfel::SurfelList surfels;
    std::uint32_t label = 0;
    std::size_t partners = 0; ///< cells that it meets

    std::size_t size() const { return surfels.size(); }
};

/// By ascending label. REQUIRES: hasCells(model).
std::vector<Cell> cellsOf(const surface::Surface& model);

/// The surface of a cell's surfels alone, without an end of its own.
surface::Surface surfaceOf(const surface::Surface& model, const Cell& cell);

/// Labels for surfels that stand for those of the cell: surfels further apart are beside creases within another reach.
/// Those of the cell's surfels beside a crease that are nearest, within two spacings, tell all five words.
void label(const Cell& cell, surfel::SurfelList& reduced);

/// So many of a cell's surfels, evenly by their order in a tree, each with the support of what it stands for: where
/// they define no surface that others could be fitted to. REQUIRES: 0 < count <= size.
surfel::SurfelList thinned(const Cell& cell, std::size_t count);

/// All surfels in one list, which has shapes where any of them has.
surfel::SurfelList joined(std::vector<surfel::SurfelList> lists);

} // namespace reduce
