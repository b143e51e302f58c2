// Creases where two kinds of surfels meet (solid/README 4.3, 4.4): on both sides bands, cells that are sharp to the one
// across and smooth to the rest of their face (cells/README 1.4). Inside this room only.
#pragma once

#include "core/cells/creases/surfel_links.h"
#include "core/surface/surface.h"

#include <functional>

namespace solid {

/// Does a link of surfel a, by number, lead over an edge?
using LeadsOver = std::function<bool(std::uint32_t a, std::uint32_t link)>;

/// What is on both sides of an edge.
enum class Sides {
    Bands, ///< of what was one cell, which stays what it was elsewhere
    Pieces ///< of edges that part the whole of it: each piece a cell, bands only where an edge ends within one
};

/// `over(links)` tells which links do. As it was where none does; `atEdge` grows by the surfels beside edges.
surface::Surface creasedWhere(const surface::Surface& surface,
                              const std::function<LeadsOver(const cells::SurfelLinks&)>& over, std::size_t& atEdge,
                              Sides sides = Sides::Bands);

} // namespace solid
