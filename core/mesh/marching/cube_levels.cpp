#include "core/mesh/marching/cube_levels.h"

namespace mesh {

/// All cubes of the level around halved ones have to be there: so what they are halves of is halved.
static std::vector<BrickBits> around(const SparseSet& halvedBelow) {
    std::vector<BrickBits> out;
    std::size_t enough = 1 << 16;
    for (std::uint32_t b = 0; b < halvedBelow.bricks().size(); ++b) {
        halvedBelow.forMembers(b, [&](const GridIndex& p, std::uint32_t) {
            for (const int z : {-1, 1})
                for (const int y : {-1, 1})
                    for (const int x : {-1, 1})
                        out.push_back(bitsOf(halved({p.x + x, p.y + y, p.z + z})));
        });
        if (out.size() > enough) {
            joinBits(out);
            enough = 2 * out.size() + (1 << 16);
        }
    }
    return out;
}

CubeLevels::CubeLevels(std::vector<std::vector<BrickBits>> wanted) {
    m_halved.emplace_back();
    for (std::size_t level = 1; level < wanted.size(); ++level) {
        std::vector<BrickBits> bits = around(m_halved.back());
        bits.insert(bits.end(), wanted[level].begin(), wanted[level].end());
        m_halved.emplace_back(std::move(bits));
    }
}

CubeLevels::Cube CubeLevels::cubeOver(GridIndex place, int level) const {
    while (level < highest() && !isHalved(halved(place), level + 1))
        place = halved(place), ++level;
    return {place, level};
}

bool CubeLevels::edgeIsHalved(const GridIndex& node, int axis, int level) const {
    if (level == 0)
        return false;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int which = 0; which < 4; ++which)
        if (isHalved(node.next(u, -(which & 1)).next(v, -(which >> 1)), level))
            return true;
    return false;
}

} // namespace mesh
