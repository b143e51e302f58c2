// Whether a solid goes on where its sheets seem to end (process/README 3).
//
// On edges thinner than the spacing no surfel lies, or few: the two walls of a fin end there as a sheet does at its
// rim. Where no wall that looks the other way stands near behind, nothing thin ends there: it is a rim. Else the
// winding number tells them apart. Beyond the edge of a fin it is that of the outside, and one spacing off the wall as
// well; over a gap it is between, and beside a sheet that encloses nothing it jumps from below to above. Alone it does
// not do: over the mouth of a narrow neck it is as near to a whole one as over a fin's edge.
#pragma once

#include "core/surface/curves/boundary.h"
#include "core/surface/winding/winding_number.h"

namespace process {

class ClosedRims {
  public:
    /// REQUIRES: oriented normals. Throws base::Cancelled.
    explicit ClosedRims(const surface::Surface& surface, const base::Progress& progress = {});

    /// Given what looks like a rim, for a loose limit, and a place on the sheet beside it with the normal there.
    bool closedAt(const surface::BoundaryPoint& rim, const base::Vec3d& beside, const base::Vec3d& normal) const;

  private:
    bool hasWallBehind(const base::Vec3d& beside, const base::Vec3d& normal, double spacing) const;

    tree::SurfelTree m_tree;
    surface::WindingNumber m_winding;
    double m_spacingsPerUnit;
};

} // namespace process
