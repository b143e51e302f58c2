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

std::vector<SectionCurve> facingParts(const std::vector<SectionCurve>& curves, const Camera& camera) {
    constexpr double least = -0.4; // of a right-angled edge's middle normal, one side of which is seen
    std::vector<SectionCurve> out;
    for (const SectionCurve& curve : curves) {
        bool going = false;
        for (const SectionPoint& p : curve.points) {
            const base::Vec3d at = camera.project(p.position);
            const bool seen =
                at.z > 0 && (p.normal == base::Vec3d{} || dot(p.normal, camera.ray(at.x, at.y).direction) < -least);
            if (seen && !going)
                out.emplace_back();
            if (seen)
                out.back().points.push_back(p);
            going = seen;
        }
        if (going && out.back().points.size() == curve.points.size())
            out.back().closed = curve.closed;
    }
    return out;
}

} // namespace render
