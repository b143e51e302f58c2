#include "core/sculpt/tools/deform.h"

#include "core/base/clones.h"
#include "core/sculpt/tools/mask_slope.h"
#include "core/sculpt/tools/moved_lanes.h"

#include <cmath>

#include <cstring>

namespace sculpt {

void ShiftLanes::set(std::size_t lane, const base::Vec3f& shift, const base::Mat3f& gradient) {
    for (std::size_t a = 0; a < 3; ++a) {
        d[a][lane] = shift[a];
        for (std::size_t b = 0; b < 3; ++b)
            j[a][b][lane] = gradient.m[a][b];
    }
}

void ShiftLanes::clear() {
    std::memset(this, 0, sizeof *this);
}

void multiply(const BrushFactors& factors, const LanePlace& where, ShiftLanes& by) {
    FactorLanes f;
    factors.fill(where.in.number, *where.in.block, where.cluster, f);
    const float* g[3] = {f.gx, f.gy, f.gz};
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t i = 0; i < lanes; ++i)
                by.j[a][b][i] = by.j[a][b][i] * f.value[i] + by.d[a][i] * g[b][i];
        for (std::size_t i = 0; i < lanes; ++i)
            by.d[a][i] *= f.value[i];
    }
}

/// Does any lane move? Multiplies by what the mask leaves.
POINTCLAY_CLONES
static bool unmask(const float* mask, const ShiftLanes& by, ShiftLanes& out) {
    int moves = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t i = 0; i < lanes; ++i)
            out.d[a][i] = by.d[a][i] * (1 - mask[i]);
        for (std::size_t i = 0; i < lanes; ++i)
            moves |= out.d[a][i] != 0 ? 1 : 0;
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t i = 0; i < lanes; ++i)
                out.j[a][b][i] = by.j[a][b][i] * (1 - mask[i]);
    }
    return moves != 0;
}

/// What the slope of the mask adds to the gradient.
static void slopeMask(const tree::SurfelTree& tree, const LanePlace& where, const ShiftLanes& by, ShiftLanes& out) {
    MaskSlopes slopes;
    if (!maskSlopes(tree, *where.in.block, where.cluster, slopes))
        return;
    const float* g[3] = {slopes.gx, slopes.gy, slopes.gz};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t i = 0; i < lanes; ++i)
                out.j[a][b][i] -= by.d[a][i] * g[b][i];
}

/// cof(F) n in lanes.
POINTCLAY_CLONES
static void turnLanes(const surfel::SurfelBlock& block, int cluster, const ShiftLanes& by, MovedLanes& out) {
    const float* nx = block.channel(cluster, surfel::NormalX);
    const float* ny = block.channel(cluster, surfel::NormalY);
    const float* nz = block.channel(cluster, surfel::NormalZ);
#pragma GCC ivdep
    for (std::size_t i = 0; i < lanes; ++i) {
        const float xx = 1 + by.j[0][0][i], xy = by.j[0][1][i], xz = by.j[0][2][i];
        const float yx = by.j[1][0][i], yy = 1 + by.j[1][1][i], yz = by.j[1][2][i];
        const float zx = by.j[2][0][i], zy = by.j[2][1][i], zz = 1 + by.j[2][2][i];
        // Rows of the cofactor matrix.
        const float cxx = yy * zz - yz * zy, cxy = yz * zx - yx * zz, cxz = yx * zy - yy * zx;
        const float cyx = zy * xz - zz * xy, cyy = zz * xx - zx * xz, cyz = zx * xy - zy * xx;
        const float czx = xy * yz - xz * yy, czy = xz * yx - xx * yz, czz = xx * yy - xy * yx;
        const float mx = cxx * nx[i] + cxy * ny[i] + cxz * nz[i], my = cyx * nx[i] + cyy * ny[i] + cyz * nz[i],
                    mz = czx * nx[i] + czy * ny[i] + czz * nz[i];
        const float dx = by.d[0][i], dy = by.d[1][i], dz = by.d[2][i];
        const float far = std::abs(dx) + std::abs(dy) + std::abs(dz), moves = far > 0 ? 1.0f : 0.0f;
        out.m[0][i] = mx, out.m[1][i] = my, out.m[2][i] = mz;
        out.d[0][i] = dx, out.d[1][i] = dy, out.d[2][i] = dz;
        out.turns[i] = mx * nx[i] + my * ny[i] + mz * nz[i] > 0 ? moves : 0.0f;
    }
}

void carry(const tree::SurfelTree& tree, const LanePlace& where, const ShiftLanes& shift, bool footprints,
           surfel::MutableBlockPtr& changed) {
    ShiftLanes by;
    if (!unmask(where.in.block->channel(where.cluster, surfel::Mask), shift, by))
        return;
    slopeMask(tree, where, shift, by);
    if (!changed)
        changed = where.in.block->clone();
    MovedLanes moved;
    turnLanes(*where.in.block, where.cluster, by, moved);
    move(*changed, where.cluster, moved, footprints);
    const surfel::SurfelBlock& block = *where.in.block;
    moveShapes(*changed, block, where.cluster, surfel::shapeChannel(*tree.layout()), moved, footprints, [&](int lane) {
        base::Mat3d f = base::Mat3d::identity();
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                f[a][b] += double(by.j[a][b][lane]);
        return f;
    });
}

} // namespace sculpt
