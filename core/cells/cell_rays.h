// Rays and the surface of a model with cells (cells/README 4), with the meaning of surface/rays/intersect.h: first hit,
// all hits, any hit. Float64 near creases; where no mixed cluster is on the way, the answer of the surface without
// cells, bit for bit.
//
// Each cell has its own zeros along the ray, whatever other cells do. From the discs of its surfels that the ray meets
// follows where they can be; there they are found, and the first one counts that the local Boolean leaves.
#pragma once

#include "core/cells/cell_value.h"
#include "core/surface/rays/intersect.h"

#include <span>

namespace cells {

struct CellHit {
    surface::RayHit<double> hit;
    std::uint32_t cell = noCell; ///< that was hit
    bool alone = false;          ///< no other cell has surfels in support there
};

/// By cells alone, wherever on the model. `robust` is not needed: what is not monotone is marched always.
CellHit intersectCells(const CellSurface& surface, const base::Rayd& ray,
                       const surface::IntersectOptions& options = {});
std::vector<CellHit> intersectAllCells(const CellSurface& surface, const base::Rayd& ray,
                                       const surface::IntersectOptions& options = {});

/// By cells where several are near the way, else as surface::intersect and so on.
surface::RayHit<double> intersectReference(const CellSurface& surface, const base::Rayd& ray,
                                           const surface::IntersectOptions& options = {});
std::vector<surface::RayHit<double>> intersectAllReference(const CellSurface& surface, const base::Rayd& ray,
                                                           const surface::IntersectOptions& options = {});
bool intersectAnyReference(const CellSurface& surface, const base::Rayd& ray,
                           const surface::IntersectOptions& options = {});

/// Many rays in parallel, the same bits as one by one at any thread count.
void intersect(const CellSurface& surface, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
               std::span<surface::RayHit<float>> out);
void intersectAll(const CellSurface& surface, std::span<const base::Rayf> rays,
                  const surface::IntersectOptions& options, std::span<std::vector<surface::RayHit<float>>> out);
void intersectAny(const CellSurface& surface, std::span<const base::Rayf> rays,
                  const surface::IntersectOptions& options, std::span<std::uint8_t> out);

} // namespace cells
