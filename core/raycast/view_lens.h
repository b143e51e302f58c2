// The inverse of an image's rays: where a point of the model lies in the image, and the measure of depth that is affine
// across the image of a plane (raycast/README 1.1). Float64.
#pragma once

#include "core/base/mat3.h"
#include "core/raycast/full_cast.h"

namespace raycast {

/// The pixels that a box is seen in and its least depth; nothing if left > right.
struct BoxImage {
    double left = 0, right = -1, top = 0, bottom = -1, depth = 0;
};

class ViewLens {
  public:
    /// REQUIRES: rays that share their origin or their direction, as those of cameras do.
    explicit ViewLens(const ImageRays& rays) : m_rays(rays), m_parallel(rays.across == base::Vec3d{}) {
        const base::Vec3d &u = m_parallel ? rays.originAcross : rays.across,
                          &v = m_parallel ? rays.originDown : rays.down;
        const base::Vec3d w = m_parallel ? normalized(rays.corner) : rays.corner;
        // The rows of the inverse of the matrix with columns u, v, w.
        const double volume = dot(u, cross(v, w));
        m_column = cross(v, w) / volume, m_row = cross(w, u) / volume, m_depth = cross(u, v) / volume;
        m_pixel = 0.5 * (length(u) + length(v));
        m_along = w;
    }

    bool parallel() const { return m_parallel; }
    /// Column and row (0 is the centre of the first pixel), and depth, which is <= 0 where no ray leads.
    base::Vec3d project(const base::Vec3d& p) const {
        const base::Vec3d d = p - m_rays.eye;
        const double z = dot(m_depth, d), scale = m_parallel ? 1 : 1 / z;
        return {dot(m_column, d) * scale, dot(m_row, d) * scale, z};
    }
    /// A box that crosses the plane of the eye is seen everywhere.
    BoxImage imageOf(const base::Box3f& box) const {
        constexpr double inf = std::numeric_limits<double>::infinity();
        BoxImage out{inf, -inf, inf, -inf, inf};
        int before = 0;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const base::Vec3d p = project({static_cast<double>(corner & 1 ? box.hi.x : box.lo.x),
                                           static_cast<double>(corner & 2 ? box.hi.y : box.lo.y),
                                           static_cast<double>(corner & 4 ? box.hi.z : box.lo.z)});
            if (!(p.z > 0))
                continue;
            ++before;
            out = {std::min(out.left, p.x), std::max(out.right, p.x), std::min(out.top, p.y), std::max(out.bottom, p.y),
                   std::min(out.depth, p.z)};
        }
        return before == 8 ? out : before == 0 ? BoxImage{} : BoxImage{-inf, inf, -inf, inf, 0};
    }
    /// Model units that a pixel spans at a depth.
    double pixelAt(double depth) const { return m_parallel ? m_pixel : m_pixel * depth; }
    /// Distance along the ray of a pixel for one unit of depth.
    double stretch(double column, double row) const {
        return m_parallel ? 1 : length(m_rays.corner + m_rays.across * column + m_rays.down * row);
    }
    /// The point at a depth along the ray of a pixel.
    base::Vec3d at(double column, double row, double depth) const {
        return m_parallel ? m_rays.eye + m_rays.originAcross * column + m_rays.originDown * row + m_along * depth
                          : m_rays.eye + (m_rays.corner + m_rays.across * column + m_rays.down * row) * depth;
    }
    /// Affine in column and row over the image of a plane; z is the depth.
    double evenDepth(double z) const { return m_parallel ? z : 1 / z; }

    const base::Vec3d& eye() const { return m_rays.eye; }
    const base::Vec3d& columnAxis() const { return m_column; }
    const base::Vec3d& rowAxis() const { return m_row; }
    const base::Vec3d& depthAxis() const { return m_depth; }

  private:
    ImageRays m_rays;
    bool m_parallel;
    base::Vec3d m_column, m_row, m_depth, m_along;
    double m_pixel;
};

} // namespace raycast
