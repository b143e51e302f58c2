// How far the cubes of a grid are halved where, so that they are as large as the surfels there are apart (mesh/README
// 3.16). Internal to the room.
//
// A tree over all of space: cubes of the highest level are everywhere, some are halved into eight of the level below,
// and so on down to level 0, the lattice's own cells. Places of cubes count in sides of their level. Cubes that meet,
// if only in a corner, differ by one level at most.
#pragma once

#include "core/mesh/marching/crossing_grid.h"
#include "core/mesh/marching/sparse_set.h"

namespace mesh {

class CubeLevels {
  public:
    static constexpr int most = 12;

    /// `wanted[level]`: cubes of that level, from 1 to the highest, that have to be halved. More are, where levels
    /// would differ by more than one.
    explicit CubeLevels(std::vector<std::vector<BrickBits>> wanted);

    int highest() const { return static_cast<int>(m_halved.size()) - 1; }
    bool isHalved(const GridIndex& place, int level) const {
        return level > 0 && m_halved[std::size_t(level)].contains(place);
    }
    struct Cube {
        GridIndex place;
        int level = 0;
    };
    /// The cube that is not halved and has a cube of some level in it. REQUIRES: that one is not halved.
    Cube cubeOver(GridIndex place, int level) const;
    /// Is one of the four cubes of the level about an edge from a node (in the level's sides) halved?
    bool edgeIsHalved(const GridIndex& node, int axis, int level) const;
    /// Is one of the two beside a face?
    bool faceIsQuartered(const GridIndex& place, int axis, int level) const {
        return isHalved(place, level) || isHalved(place.next(axis, -1), level);
    }

  private:
    std::vector<SparseSet> m_halved; ///< by level; none at level 0
};

} // namespace mesh
