#include "core/process/estimation/orientation/normal_links.h"

#include "core/base/clones.h"

#include <cmath>
#include <limits>

namespace process {

/// Compares the normal at b with the one that a circular arc from a to b would carry there, the normal at a mirrored in
/// the plane halfway: exact on spheres and cylinders, and right across sharp edges, where n_a . n_b is 0. An edge along
/// the normals joins two layers or two sides of something thin, and nobody can tell which: it comes last. The same bits
/// from a to b and from b to a.
POINTCLAY_CLONES
static void likeness(const Beside& b, Likeness& out) {
    for (int k = 0; k < Likeness::most; ++k) {
        const float ex = b.x[k] - b.a.x, ey = b.y[k] - b.a.y, ez = b.z[k] - b.a.z;
        const float l = std::sqrt(ex * ex + ey * ey + ez * ez);
        const bool far = l > 0 && l <= std::numeric_limits<float>::max();
        const float ux = far ? ex / l : 0, uy = far ? ey / l : 0, uz = far ? ez / l : 0;
        const float alongA = b.na.x * ux + b.na.y * uy + b.na.z * uz;
        const float alongB = b.nx[k] * ux + b.ny[k] * uy + b.nz[k] * uz;
        const float arc = b.na.x * b.nx[k] + b.na.y * b.ny[k] + b.na.z * b.nz[k] - 2 * alongA * alongB;
        const float steepA = alongA * alongA, steepB = alongB * alongB;
        const float unlike = 1 - std::abs(arc) * (1 - (steepA < steepB ? steepB : steepA));
        const float clamped = unlike < 0 ? 0 : 1 < unlike ? 1 : unlike;
        const float side = b.na.x * b.nx[k] + b.na.y * b.ny[k] + b.na.z * b.nz[k] < 0 ? -alongB : alongB;
        const float step = (alongA + side) / 2; // none along an arc, however it bends
        out.stepSq[k] = step * step;
        out.flip[k] = arc < 0;
        out.unlike[k] = static_cast<std::int32_t>(clamped * (unlikeClasses - 1));
    }
}

void NormalLinks::compare(std::size_t i, const NeighbourTable::Row& row, Beside& beside, Likeness& out) const {
    beside.a = m_positions[i], beside.na = m_normals[i];
    for (std::size_t k = 0; k < count(); ++k) {
        const base::Vec3f &p = m_positions[row[k]], &n = m_normals[row[k]];
        beside.x[k] = p.x, beside.y[k] = p.y, beside.z[k] = p.z;
        beside.nx[k] = n.x, beside.ny[k] = n.y, beside.nz[k] = n.z;
    }
    likeness(beside, out);
}

} // namespace process
