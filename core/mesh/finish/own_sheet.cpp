#include "core/mesh/finish/own_sheet.h"

#include "core/surface/projection/project.h"

namespace mesh {

using base::Vec3d, base::Vec3f;

std::optional<SurfacePoint> ontoOwnSheet(const surface::Surface& surface, const SurfaceTraits& traits,
                                         const Vec3d& start, const Vec3f& normal, double farthest) {
    constexpr int turns = 8;
    constexpr double still = 2e-5; // of the spacing
    SurfacePoint out{start, normal};
    for (int turn = 0; turn < turns; ++turn) {
        const auto found = surface::projectReference(surface, out.position, {}, {out.normal});
        if (!found.ok() || distance(found.foot, start) > farthest)
            return std::nullopt;
        const double moved = distance(found.foot, out.position);
        out.position = found.foot;
        if (turn > 0 && moved <= still * traits.spacingsPerUnit * found.at.unit)
            return out;
        Vec3f next = base::cast<float>(base::normalized(found.at.gradient));
        if (!traits.oriented && dot(next, normal) < 0)
            next = -next;
        // halfway, once normals lead to each other in circles
        out.normal = turn < turns / 2 ? next : base::normalized(next + out.normal, next);
    }
    return std::nullopt;
}

} // namespace mesh
