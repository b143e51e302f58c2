// Which side of a solid places are on, and how far from its surface where that is near (solid/README 2.1).
#pragma once

#include "core/base/box.h"
#include "core/cells/cell_surface.h"

namespace solid {

/// value > 0 outside. Where `near`, it is the height over the surface, and the gradient leads outwards.
struct SideValue {
    double value = 0;
    base::Vec3d gradient;
    bool near = false;
};

/// The place of a surface nearest to somewhere, also far from it.
struct SideFoot {
    base::Vec3d foot;
    double height = 0;    ///< > 0 outside
    base::Vec3d gradient; ///< unit, of the height
    bool ok = false;      ///< a foot was found
};

/// A solid as the half of space that it is not. Immutable; any number of threads may ask.
class Side {
  public:
    virtual ~Side() = default;
    virtual SideValue at(const base::Vec3d& x) const = 0;
    /// May the surface come into the box? False where it certainly does not: all of the box is on one side.
    virtual bool meets(const base::Box3d& box) const = 0;
    virtual SideFoot foot(const base::Vec3d& x) const = 0;
};

/// Of oriented surfels. Near their surface f tells, with creases that of the local Boolean; elsewhere the first hits of
/// some rays, from which side they come.
class SurfaceSide : public Side {
  public:
    explicit SurfaceSide(surface::Surface surface);
    SideValue at(const base::Vec3d& x) const override;
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

  private:
    surface::Surface m_surface;
    std::optional<cells::CellSurface> m_cells; ///< where the model has creases
};

/// For each surfel of a version, in tree order, whether it is outside (1), inside (-1), or on the surface within a
/// tenth of its spacing and parallel to it: 2 facing as that does, -2 facing against it. Cost follows the surfels near
/// the surface: whole blocks away from it are asked about once. Throws base::Cancelled by the scope.
std::vector<std::int8_t> sidesOf(const tree::SurfelTree& tree, const Side& side);

} // namespace solid
