// A surface, with the cells that it may have, or a complex: what pictures and others ask who take models of any kind.
// Where there are neither every answer is that of the surface, bit for bit, and costs no more.
//
// A value, cheap to copy, made of a surface without further words. All functions are const and may run on any thread.
#pragma once

#include "core/cells/cell_surface.h"
#include "core/complexes/complex.h"
#include "core/surface/rays/intersect.h"

namespace cells {

class AnySurface {
  public:
    AnySurface() = default;
    AnySurface(surface::Surface surface) // NOLINT: a surface is one
        : m_surface(std::move(surface)), m_cells(CellSurface::of(m_surface)),
          m_complex(complexes::Complex::of(m_surface)) {}

    const surface::Surface& surface() const { return m_surface; }
    const tree::SurfelTree& tree() const { return m_surface.tree(); }
    /// Null for models without cells.
    const CellSurface* cells() const { return m_cells ? &*m_cells : nullptr; }
    /// Null for models that are none.
    const complexes::Complex* complex() const { return m_complex ? &*m_complex : nullptr; }

  private:
    surface::Surface m_surface;
    std::optional<CellSurface> m_cells;
    std::optional<complexes::Complex> m_complex;
};

/// As surface::intersect and so on; with cells as in cell_rays.h.
void intersect(const AnySurface& surface, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
               std::span<surface::RayHit<float>> out);
void intersectAny(const AnySurface& surface, std::span<const base::Rayf> rays, const surface::IntersectOptions& options,
                  std::span<std::uint8_t> out);

} // namespace cells
