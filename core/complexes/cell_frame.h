// The plane of a patch, or the line of a curve, at a place [Adamson07, 9.2]: from the cell's own points, and from the
// feet on the cells that bound it, which weigh without limit as one comes nearer (complexes/README 2). Internal to the
// room.
#pragma once

#include "core/complexes/complex.h"

namespace complexes {

/// A boundary cell that is near, and its point for x.
struct Attached {
    std::uint32_t cell = 0;
    base::Vec3d foot;
    base::Vec3d tangent; ///< of a curve there, unit; zero of points, and beyond a curve's ends
    double distance = 0; ///< from x
    double reach = 0;    ///< from where on it has no weight; looked at up to its whole h
};

struct CellFrame {
    surface::Status status = surface::Status::Outside;
    surface::Cause cause = surface::Cause::NoSupport;
    base::Vec3d centre;    ///< c(x)
    base::Vec3d ownCentre; ///< of the cell's own points alone; the cell's where none has weight
    base::Vec3d axis;      ///< unit: of a patch the normal, of a curve the tangent
    double unit = 0;       ///< h at x
    double agreement = 0;  ///< |sum theta n| / w of the own normals
    int samples = 0;       ///< own ones with weight
    bool reached = false;  ///< x is on the boundary, to 1e-9 of its reach: at attached[0]
    std::vector<Attached> attached;

    bool ok() const { return status == surface::Status::Ok; }
    /// All that speaks here lies to one side of x: the plane tells of other places.
    bool offCentre(const base::Vec3d& x) const {
        constexpr double most = 0.35; // on cells it is below .25, their boundary pulls the centre along
        return base::distance(x, centre) > most * unit;
    }
    /// x's foot on the plane or line through c, x moved to be seen from `from`.
    base::Vec3d foot(int dimension, const base::Vec3d& from) const {
        const base::Vec3d d = from - centre, along = axis * dot(d, axis);
        return centre + (dimension == 1 ? along : d - along);
    }
};

/// REQUIRES: a cell of dimension 1 or 2. Normals of patches have the side of the points' where these agree; else that
/// of `side`, or any where it is zero.
CellFrame frameOf(const Complex& complex, std::uint32_t cell, const base::Vec3d& x, const base::Vec3d& side = {});

} // namespace complexes
