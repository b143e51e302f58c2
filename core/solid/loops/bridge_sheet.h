// The sheet between two boundary loops (solid/README 1.6): each place of one is led to a place of the other along a
// cubic that begins and ends in the surface's tangent planes, as long as an arc of a circle would be.
#pragma once

#include "core/solid/loops/patch.h"
#include "core/surface/surface.h"

namespace solid {

class BridgeSheet final : public Sheet {
  public:
    /// Loops of the surface as evenLoop gives them. REQUIRES: 6 points or more each.
    BridgeSheet(const surface::Surface& surface, const Loop& from, const Loop& to);

    base::Vec3d at(const SheetPlace& place) const override;
    /// Of the points of `from`, then of those of `to`.
    std::span<const SheetPlace> places() const { return m_places; }
    /// Mean length across, and how often it is that of places led to each other the other way about: above 1 where
    /// sides of the two surfaces look as if they did not agree.
    double across() const { return m_across; }
    double againstTurned() const { return m_againstTurned; }

  private:
    struct Row {
        base::Vec3d from, fromHandle, toHandle, to; ///< of the cubic, in Bézier's form
    };
    std::vector<Row> m_rows; ///< evenly in u
    std::vector<SheetPlace> m_places;
    double m_across = 0, m_againstTurned = 0;
};

} // namespace solid
