// The smooth base under the relief about a hole, over a map of it (solid/README 1.5). Inside this room only.
#pragma once

#include "core/solid/loops/patch.h"

#include <memory>
#include <span>

namespace solid {

/// In model units from the middle of the map.
struct MapPlace {
    double u = 0, v = 0;
};

/// Directions and ways from a place, on spheres and planes exactly.
class HoleMap {
  public:
    HoleMap(const base::Vec3d& middle, const base::Vec3d& normal);
    /// `normal`: the surface's at x, without its relief.
    MapPlace at(const base::Vec3d& x, const base::Vec3d& normal) const;
    /// Beyond some angle ways from the middle tell nothing.
    bool covers(const base::Vec3d& normal) const { return dot(normal, m_normal) > -0.3; }

  private:
    base::Vec3d m_middle, m_normal, m_u, m_v;
};

/// About the middle of the patch.
HoleMap mapOver(const Patch& patch, const std::vector<base::Vec3d>& normals);

/// Positions as polynomials of the map's places, by least squares.
class ReliefBase {
  public:
    ReliefBase() = default;
    ReliefBase(std::span<const base::Vec3d> positions, std::span<const MapPlace> places, int degree);
    static constexpr int least = 2, most = 5; ///< degrees
    base::Vec3d at(const MapPlace& place) const;
    base::Vec3d normal(const MapPlace& place) const;
    /// Unit: along u, or along v.
    base::Vec3d along(const MapPlace& place, bool u) const;

  private:
    int m_degree = 0;
    double m_scale = 1;
    base::Vec3d m_origin;
    std::vector<base::Vec3d> m_factors;
};

} // namespace solid
