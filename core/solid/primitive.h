// Solids by formula: balls, boxes, cylinders, cones, tori, capsules and half-spaces, as a distance and as surfels
// (solid/README 3). One table that commands, help and tests loop over.
//
// A primitive stands in its own frame, its middle at the origin, its axis along z; a pose places it.
#pragma once

#include "core/base/mat3.h"
#include "core/solid/side.h"
#include "core/surfel/surfel.h"

#include <array>
#include <string_view>

namespace solid {

/// x = turn q + middle.
struct Pose {
    base::Mat3d turn = base::Mat3d::identity(); ///< a rotation
    base::Vec3d middle;

    base::Vec3d place(const base::Vec3d& q) const { return turn * q + middle; }
    base::Vec3d local(const base::Vec3d& x) const { return transposed(turn) * (x - middle); }
};

/// A pose whose z axis is that unit vector.
Pose poseAlong(const base::Vec3d& middle, const base::Vec3d& axis);

using Size = std::array<double, 3>;

struct PrimitiveRow {
    const char* id;
    const char* label;
    const char* sizes; ///< what the numbers of a size are, for help
    int sizeCount;
    double (*distance)(const Size& size, const base::Vec3d& q); ///< signed, > 0 outside; exact near the surface
    double (*volume)(const Size& size);
};

std::span<const PrimitiveRow> primitiveTable();
/// Throws base::Error naming the known ones.
const PrimitiveRow& primitive(std::string_view id);

/// A placed one as a solid.
class PrimitiveSide : public Side {
  public:
    PrimitiveSide(const PrimitiveRow& row, const Size& size, const Pose& pose)
        : m_row(row), m_size(size), m_pose(pose) {}
    SideValue at(const base::Vec3d& x) const override;
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

  private:
    const PrimitiveRow& m_row;
    Size m_size;
    Pose m_pose;
};

/// The half of space on the side away from the plane's normal.
class HalfSpaceSide : public Side {
  public:
    HalfSpaceSide(const base::Vec3d& normal, double offset) : m_normal(normal), m_offset(offset) {}
    SideValue at(const base::Vec3d& x) const override { return {dot(m_normal, x) - m_offset, m_normal, true}; }
    bool meets(const base::Box3d& box) const override;
    SideFoot foot(const base::Vec3d& x) const override;

  private:
    base::Vec3d m_normal;
    double m_offset;
};

/// Samples of a primitive's surface in its own frame: even, `spacing` apart, with exact normals and supports by the
/// definition, and labels of its smooth pieces (cells/README 1) where it has edges. Throws base::Error where they would
/// be more than 20 million.
surfel::SurfelList surfelsOf(const PrimitiveRow& row, const Size& size, double spacing,
                             const surface::SurfaceDefinition& definition);

} // namespace solid
