// The surface within a disc by few of its places: a cubic height over the plane of the one in the middle, fitted to
// feet and their normals, so that finer discs cost no projection each (render/README 4.4). Lengths are in model units.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <optional>
#include <span>

namespace render {

/// A place of the surface.
struct Foot {
    base::Vec3f position, normal; ///< unit
};

class SmoothPatch {
  public:
    /// The first foot is the one in the middle; seven are enough. Nothing where it turns away from them by 70 degrees
    /// and more, or lies off any of them by more than `most`: the surface has more shape than that.
    static std::optional<SmoothPatch> through(std::span<const Foot> feet, float radius, float most);
    /// Above or below x, which is not much farther off than `radius`.
    Foot at(const base::Vec3f& x) const;

  private:
    static constexpr int terms = 10;
    using Row = std::array<double, terms>;
    /// Height and slopes at a place, in radii.
    struct Height {
        double value, a, b;
    };
    static std::array<Row, 3> rowsAt(double a, double b);
    Height heightAt(double a, double b) const;

    base::Vec3d m_middle, m_u, m_v, m_normal;
    double m_radius = 1;
    Row m_factors{};
};

} // namespace render
