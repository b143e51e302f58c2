#include "core/cells/cell_value.h"

#include "core/cells/local_boolean.h"
#include "core/surface/rays/intersect.h"

namespace cells {

using surface::Evaluationd;
using surface::Need;

namespace {

/// The cell whose f the local Boolean has: of those that nothing cuts off the nearest one; of all, where everything is.
std::size_t activeCell(CellSource& source) {
    std::size_t best = CellSource::none;
    bool bestKept = false;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < source.count(); ++i) {
        const Evaluationd& at = source.at(i, Need::Value);
        if (!valid(at))
            continue;
        const bool there = at.offCentre <= surface::maxOffCentre * at.unit;
        const bool kept = !cutOff(source, i, cutTolerance(at.unit, length(source.position())));
        const double far = there ? std::abs(at.value) : at.unit + at.offCentre;
        if (kept > bestKept || (kept == bestKept && far < least)) {
            best = i;
            bestKept = kept;
            least = far;
        }
    }
    return best;
}

} // namespace

CellValue evaluate(CellSource& source, const base::Vec3d& x, Need need) {
    source.moveTo(x);
    CellValue out;
    out.mixed = source.count() > 1;
    const std::size_t i = source.count() == 1 ? 0 : activeCell(source);
    if (i == CellSource::none) {
        out.at = source.surface().surface().evaluateReference(x, need); // tells why there is none
        return out;
    }
    out.at = source.at(i, need);
    out.cell = source.cell(i);
    if (valid(out.at))
        if (const auto plane = cutOffByPlane(source, i, cutTolerance(out.at.unit, length(x)))) {
            out.at.value = plane->height;
            out.at.gradient = plane->normal;
            out.mixed = true;
        }
    if (out.mixed && valid(out.at))
        out.at.status = beyondBoundary(source, i) ? surface::Status::BeyondBoundary : surface::Status::Ok;
    return out;
}

CellValue evaluate(const CellSurface& surface, const base::Vec3d& x, Need need) {
    CellSource source(surface);
    return evaluate(source, x, need);
}

} // namespace cells
