#include "core/process/estimation/orientation/contradictions.h"

namespace process {

double contradictions(const tree::SurfelTree& tree) {
    constexpr std::size_t mostSamples = 4096, looked = 9; // itself among them
    const std::size_t stride = (tree.size() + mostSamples - 1) / mostSamples;
    std::size_t at = 0, pairs = 0, opposite = 0;
    std::vector<tree::Neighbour> near;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot, ++at) {
            if (at % stride != 0)
                continue;
            const base::Vec3f x = block.position(slot), n = block.normal(slot);
            tree.nearest(x, looked, near);
            for (const tree::Neighbour& each : near) {
                const base::Vec3f m = each.block->normal(each.slot), way = each.block->position(each.slot) - x;
                if (!inSheet(way, n) || !inSheet(way, m))
                    continue;
                ++pairs;
                opposite += lookOpposite(n, m);
            }
        }
    });
    return pairs > 0 ? static_cast<double>(opposite) / static_cast<double>(pairs) : 0;
}

} // namespace process
