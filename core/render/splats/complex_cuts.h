// Where discs of a complex end (render/README 3.2): at the nearest curve of their patch's boundary. Points on curves
// and corners have no disc: the patches' discs reach there.
#pragma once

#include "core/complexes/complex.h"
#include "core/render/splats/disc_cuts.h"

namespace render {

class ComplexCuts {
  public:
    /// Nothing for models of another kind. `radiusOfSupport`: radius of a disc in supports.
    static std::optional<ComplexCuts> of(const tree::SurfelTree& model, const surface::SurfaceDefinition& definition,
                                         float radiusOfSupport);

    /// True if any disc of the block is cut.
    bool cut(const surfel::SurfelBlock& block, CutCodes& codes) const;

  private:
    ComplexCuts(complexes::Complex complex, float radiusOfSupport)
        : m_complex(std::move(complex)), m_radius(radiusOfSupport) {}
    CutCode cutOf(const surfel::SurfelBlock& block, int slot) const;

    complexes::Complex m_complex;
    float m_radius;
    std::size_t m_word = 0; ///< of surfels that tells their cell
};

} // namespace render
