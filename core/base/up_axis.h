// Which axis of coordinates points upwards in a model, and the frame in which it stands.
//
// Views, turntables and grounds are made for a model that stands: x to the right, y up, z towards whoever looks from
// the front. Another axis up turns that frame into the model's coordinates by quarter turns, exactly:
//
//     up     right   front
//      y       x       z
//      z       x      -y      as most programs for z upwards have it
//     -z       x       y
//      x      -y       z
//     -x       y       z
//     -y      -x       z      upside down, seen from the same side
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>

namespace base {

enum class UpAxis : std::uint8_t { Y, Z, MinusY, MinusZ, X, MinusX };

struct UpRow {
    const char* id; ///< "-z", as files, sessions and the command line write it
    UpAxis axis;
    Vec3d right, up, front; ///< of the standing model, in its own coordinates; right-handed
};

/// One row for each axis, in the order of the enumeration.
std::span<const UpRow> upTable();
const UpRow& upRow(UpAxis axis);
/// The one after it in the table, and after the last the first.
UpAxis nextUp(UpAxis axis);

/// A direction of the standing frame in the model's coordinates.
inline Vec3d fromStanding(UpAxis axis, const Vec3d& v) {
    const UpRow& row = upRow(axis);
    return row.right * v.x + row.up * v.y + row.front * v.z;
}

/// A direction of the model in the standing frame.
inline Vec3d toStanding(UpAxis axis, const Vec3d& v) {
    const UpRow& row = upRow(axis);
    return {dot(row.right, v), dot(row.up, v), dot(row.front, v)};
}

} // namespace base
