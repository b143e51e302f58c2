#include "core/sculpt/tools/deform.h"

#include "core/sculpt/tools/mask_slope.h"

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
static bool unmask(const tree::SurfelTree& tree, const LanePlace& where, const ShiftLanes& by, ShiftLanes& out) {
    const float* mask = where.in.block->channel(where.cluster, surfel::Mask);
    bool moves = false;
    for (std::size_t i = 0; i < lanes; ++i) {
        const float free = 1 - mask[i];
        for (std::size_t a = 0; a < 3; ++a) {
            out.d[a][i] = by.d[a][i] * free;
            for (std::size_t b = 0; b < 3; ++b)
                out.j[a][b][i] = by.j[a][b][i] * free;
        }
        moves |= out.d[0][i] != 0 || out.d[1][i] != 0 || out.d[2][i] != 0;
    }
    MaskSlopes slopes;
    if (!moves || !maskSlopes(tree, *where.in.block, where.cluster, slopes))
        return moves;
    const float* g[3] = {slopes.gx, slopes.gy, slopes.gz};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            for (std::size_t i = 0; i < lanes; ++i)
                out.j[a][b][i] -= by.d[a][i] * g[b][i];
    return true;
}

void carry(const tree::SurfelTree& tree, const LanePlace& where, const ShiftLanes& shift, bool footprints,
           surfel::MutableBlockPtr& changed) {
    const int cluster = where.cluster;
    ShiftLanes by;
    if (!unmask(tree, where, shift, by))
        return;
    if (!changed)
        changed = where.in.block->clone();
    float* x = changed->channel(cluster, surfel::X);
    float* y = changed->channel(cluster, surfel::Y);
    float* z = changed->channel(cluster, surfel::Z);
    float* nx = changed->channel(cluster, surfel::NormalX);
    float* ny = changed->channel(cluster, surfel::NormalY);
    float* nz = changed->channel(cluster, surfel::NormalZ);
    float* support = changed->channel(cluster, surfel::Support);
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
        const float length = std::sqrt(mx * mx + my * my + mz * mz);
        const bool moves = by.d[0][i] != 0 || by.d[1][i] != 0 || by.d[2][i] != 0;
        const bool turns = moves && mx * nx[i] + my * ny[i] + mz * nz[i] > 0;
        const float scale = 1 / (turns ? length : 1.0f);
        nx[i] = turns ? mx * scale : nx[i], ny[i] = turns ? my * scale : ny[i], nz[i] = turns ? mz * scale : nz[i];
        support[i] = turns && footprints ? support[i] * std::sqrt(length) : support[i];
        x[i] = moves ? x[i] + by.d[0][i] : x[i];
        y[i] = moves ? y[i] + by.d[1][i] : y[i];
        z[i] = moves ? z[i] + by.d[2][i] : z[i];
    }
}

} // namespace sculpt
