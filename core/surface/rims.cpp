#include "core/surface/rims.h"

#include <algorithm>

namespace surface {

std::optional<int> rimChannel(const surfel::AttributeLayout& layout) {
    const surfel::Attribute* found = layout.find(rimName);
    if (!found || surfel::isReal(found->type))
        return std::nullopt;
    return surfel::Extra + static_cast<int>(found->firstWord);
}

bool isBesideRim(const surfel::SurfelBlock& block, int slot, const surfel::AttributeLayout& layout) {
    const std::optional<int> channel = rimChannel(layout);
    return channel && tellsOfRim(block, slot, *channel);
}

bool hasRim(const tree::SurfelTree& tree) {
    const std::optional<int> channel = rimChannel(*tree.layout());
    bool any = false;
    if (channel)
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size() && !any; ++slot)
                any = tellsOfRim(block, slot, *channel);
        });
    return any;
}

template <class T>
bool mayEnd(const Surface& surface, const base::Vec3<T>& x) {
    const std::optional<int> channel =
        surface.definition().knownRims ? rimChannel(*surface.tree().layout()) : std::nullopt;
    if (!channel)
        return true;
    const base::Vec3f at = base::cast<float>(x);
    float nearest = std::numeric_limits<float>::infinity();
    bool found = false;
    surface.tree().forClustersInSupport(
        at,
        [&](const surfel::SurfelBlock& block, int cluster) {
            const int begin = cluster * surfel::clusterSize, end = std::min(block.size(), begin + surfel::clusterSize);
            for (int slot = begin; slot < end; ++slot)
                if (const float d = distanceSq(block.position(slot), at); d < nearest)
                    nearest = d, found = tellsOfRim(block, slot, *channel);
        },
        surface.supportScale());
    return found;
}

template bool mayEnd(const Surface&, const base::Vec3f&);
template bool mayEnd(const Surface&, const base::Vec3d&);

} // namespace surface
