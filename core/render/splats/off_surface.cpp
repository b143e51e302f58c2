#include "core/render/splats/off_surface.h"

#include "core/base/ranked.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace render {

constexpr int leastNeighbours = 4;
constexpr float within = 1.5f; ///< radii: as far as the surface is about flat
constexpr std::size_t tellingPart = 16;

float offSurface(const surfel::SurfelBlock& block, float radiusOfSupport) {
    std::vector<float> off;
    for (int i = 0; i < block.size(); ++i) {
        const base::Vec3f p = block.position(i), n = block.normal(i);
        const float reach = within * radiusOfSupport * block.support(i);
        float sum = 0;
        int count = 0;
        for (int j = 0; j < block.size(); ++j) {
            const base::Vec3f way = block.position(j) - p;
            if (j == i || lengthSq(way) > reach * reach || !(dot(n, block.normal(j)) > 0))
                continue;
            sum += dot(way, n);
            ++count;
        }
        if (count >= leastNeighbours)
            off.push_back(std::abs(sum) / static_cast<float>(count));
    }
    return base::ranked(off, off.size() / tellingPart, std::greater<>());
}

} // namespace render
