// The grid of cubes that marching cubes lays through space, and positions in it by whole numbers.
//
// Nodes have coordinates from 0 to `Lattice::extent`; a cube is named by its lowest node, an edge by its lower node and
// its axis. Lengths are in model units.
#pragma once

#include "core/base/mat3.h"

#include <cstdint>

namespace mesh {

/// A node, or the cube above it.
struct GridIndex {
    std::int32_t x = 0, y = 0, z = 0;

    constexpr std::int32_t& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr std::int32_t operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr GridIndex next(int axis, int by = 1) const {
        GridIndex out = *this;
        out[axis] += by;
        return out;
    }
    constexpr bool operator==(const GridIndex&) const = default;
};

/// Of places of cubes: of the one twice as large; of the lowest of those 2^level times smaller; one of eight.
inline GridIndex halved(const GridIndex& p) {
    return {p.x >> 1, p.y >> 1, p.z >> 1};
}
inline GridIndex scaled(const GridIndex& p, int level) {
    return {p.x << level, p.y << level, p.z << level};
}
inline GridIndex cornerOf(const GridIndex& p, int which) {
    return {p.x + (which & 1), p.y + (which >> 1 & 1), p.z + (which >> 2)};
}

struct Lattice {
    static constexpr std::int32_t extent = 1 << 22; ///< nodes along an axis

    base::Vec3d origin; ///< of node 0, 0, 0
    base::Mat3d turned; ///< rows: unit directions of the grid's axes
    double cell = 0;

    base::Vec3d direction(int axis) const { return {turned[axis][0], turned[axis][1], turned[axis][2]}; }
    /// Where grid coordinates, whole or not, are in space.
    base::Vec3d at(const base::Vec3d& grid) const { return origin + transposed(turned) * (grid * cell); }
    base::Vec3d at(const GridIndex& p) const { return at(base::Vec3d{double(p.x), double(p.y), double(p.z)}); }
    base::Vec3d toGrid(const base::Vec3d& x) const { return turned * (x - origin) / cell; }
};

} // namespace mesh
