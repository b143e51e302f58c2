#include "core/cells/any_surface.h"

#include "core/cells/cell_rays.h"
#include "core/complexes/complex_rays.h"

namespace cells {

void intersect(const AnySurface& surface, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
               std::span<surface::RayHit<float>> out) {
    if (const CellSurface* cells = surface.cells())
        intersect(*cells, rays, options, out);
    else if (const complexes::Complex* complex = surface.complex())
        intersect(*complex, rays, options, out);
    else
        intersect(surface.surface(), rays, options, out);
}

void intersectAny(const AnySurface& surface, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::uint8_t> out) {
    if (const CellSurface* cells = surface.cells())
        intersectAny(*cells, rays, options, out);
    else if (const complexes::Complex* complex = surface.complex())
        intersectAny(*complex, rays, options, out);
    else
        intersectAny(surface.surface(), rays, options, out);
}

} // namespace cells
