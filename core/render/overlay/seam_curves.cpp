#include "core/render/overlay/seam_curves.h"

#include "core/cells/seam_lines.h"

namespace render {

using surface::SectionCurve, surface::SectionPoint;

std::vector<SectionCurve> seamCurves(const surface::Surface& surface, const base::Progress& progress) {
    std::vector<SectionCurve> out;
    for (const cells::SeamLine& line : cells::seamLines(surface, progress)) {
        SectionCurve& curve = out.emplace_back();
        curve.closed = line.closed;
        for (const cells::SeamPoint& p : line.points) {
            SectionPoint& at = curve.points.emplace_back();
            at.position = p.position;
            at.normal = p.normal;
            at.unit = p.unit;
        }
    }
    return out;
}

} // namespace render
