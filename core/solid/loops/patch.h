// A patch over a boundary loop as triangles of the loop's spacing (solid/README 1.2): where it lies is shaped
// afterwards (shape_patch.h).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/solid/loops/loop.h"

#include <span>

namespace solid {

struct Patch {
    std::vector<base::Vec3d> positions;    ///< the loop's points, then those inside
    std::vector<double> spacings;          ///< wanted at each
    std::vector<mesh::Triangle> triangles; ///< a disc, counter-clockwise seen from where the loop's normals point
    std::size_t loopSize = 0;
    /// Of the loop's points, where the patch goes on into the surface around; empty: theirs.
    std::vector<base::Vec3d> edgeNormals = {};

    bool inside(std::size_t vertex) const { return vertex >= loopSize; }
};

/// Corners of the polygon that stands for the loop at first.
constexpr std::size_t mostCorners = 160;

/// Area of the least triangulation of some of the loop's points: what a patch will have at least.
double areaOver(const Loop& loop);

/// An even triangulation of the loop, about the surface of least area. Throws base::Cancelled.
Patch patchOver(const Loop& loop, const base::Progress& progress = {});

/// The same surface, with triangles of the spacings wanted once it was moved or stretched. Throws base::Cancelled.
Patch evened(const Loop& loop, const Patch& patch);

/// A sheet that vertices stay on: a place for each pair of numbers, u from 0 to 1, where it begins anew, v across.
struct SheetPlace {
    double u = 0, v = 0;
};
class Sheet {
  public:
    virtual base::Vec3d at(const SheetPlace& place) const = 0;

  protected:
    ~Sheet() = default;
};
/// An even triangulation of a sheet from one loop to another. `loops`: the points of one after those of the other, each
/// as seen by itself counter-clockwise about the sheet; `places`: of each of them, with v = 0 for the first loop, where
/// u grows along it, and v = 1 for the other, where it falls. Throws base::Cancelled.
Patch patchBetween(const Loop& loops, std::span<const SheetPlace> places, const Sheet& sheet,
                   const base::Progress& progress = {});

/// Every edge halved `times`, new vertices on the cubics that the normals at its ends make of it [Vlachos01]; `normals`
/// becomes theirs. The loop's points are no longer the first ones: loopSize becomes 0.
void halveEdges(Patch& patch, std::vector<base::Vec3d>& normals, int times);

} // namespace solid
