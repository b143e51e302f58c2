// Which side of a surface a place is on (mesh/README 3.14): of a closed one everywhere, of one that knows its rims
// wherever these are out of reach. Internal to the room.
//
// f tells it near the surfels. It has no value far from all of them, and next to near sheets, sharp edges, gaps and
// stray surfels it may tell of a sheet that ends before. There the winding number decides, where it is sure of itself;
// over gaps, f's planes pass into the surface where the winding number is a half.
//
// Sheets inside of the solid, such as those of parts that run into each other, are no part of its surface. Parts whose
// normals point inwards while those of others point outwards stay as they are.
//
// The winding number of an open surface lacks what its holes would have. On a sheet it is a half with them, so that
// what lacks is known at every surfel; it changes slowly away from the rims, and is added back.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/surface_traits.h"
#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace mesh {

enum class SolidSide : std::uint8_t { Untold, Outside, Inside };
constexpr bool told(SolidSide side) {
    return side != SolidSide::Untold;
}

class Solid {
  public:
    /// REQUIRES: SurfaceTraits::sided. Throws base::Cancelled.
    Solid(const surface::Surface& surface, const base::Progress& progress);

    struct Height {
        double value = 0;       ///< above zero outside; near the surface its distance in units of h
        double winding = 0;     ///< share of the winding number in it, 0 to 1
        bool overruled = false; ///< f says otherwise, or nothing
    };
    /// `at`: what the surface answers there; `alone`: its sheet has no other within reach.
    Height height(const base::Vec3d& x, const surface::Evaluationf& at, bool alone) const;
    /// Evaluates many places. Returns of each on which side it is; untold is what a rim may reach.
    std::vector<SolidSide> sides(std::span<const base::Vec3f> x, std::span<surface::Evaluationf> out) const;
    /// The same by the winding number alone.
    double byWinding(const base::Vec3d& x) const { return 0.5 - winding(x, sheetNear(x)); }
    /// Which way out. `at` with its gradient, where the height needs it.
    base::Vec3d outwards(const base::Vec3d& x, const surface::Evaluationf& at, const Height& height) const;

  private:
    using Turns = std::array<std::int8_t, surfel::clustersPerBlock>;

    int turnsOn(const surfel::SurfelBlock& block, int cluster) const;
    void classify();
    void findMissing();
    /// What winding numbers are off by about the sheet nearest to a place.
    struct Sheet {
        /// Whole turns away from 0 and 1 on its sides; mostly none. Nor any beyond its support: else one that is inside
        /// out would have all space up to the next one inside.
        int turns = 0;
        double missing = 0; ///< of open surfaces
    };
    Sheet sheetNear(const base::Vec3d& x) const;
    double winding(const base::Vec3d& x, const Sheet& sheet) const {
        return m_winding.at(x) - m_around - std::min(sheet.turns, 0) + sheet.missing;
    }
    bool rimReaches(const base::Vec3f& x, const surface::Evaluationf& at) const;

    surface::Surface m_surface, m_plain; ///< m_plain: by plain sums, whose agreement tells that sheets are near
    surface::WindingNumber m_winding;
    bool m_open;
    int m_around = 0; ///< winding number far outside: -1 where normals point inwards
    /// Of the clusters of blocks; only of blocks that have others than 0.
    std::unordered_map<const surfel::SurfelBlock*, Turns> m_turns;
    tree::SurfelTree m_missing; ///< of open surfaces: places on them, whose masks are what is missing there
};

} // namespace mesh
