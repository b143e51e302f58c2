#include "core/haptics/patch.h"

#include "core/surfel/shape.h"

namespace haptics {

/// Reads a word of every page and line that evaluations in the box will read: what was swapped out or never read comes
/// back here, and not between two ticks.
static std::uint32_t read(const surface::Surface& surface, const base::Box3f& box) {
    std::uint32_t sum = 0;
    const int shape = surfel::shapeChannel(*surface.tree().layout());
    surface.tree().forClustersInSupport(box, [&](const surfel::SurfelBlock& block, int cluster) {
        for (const int channel :
             {surfel::X, surfel::Y, surfel::Z, surfel::NormalX, surfel::NormalY, surfel::NormalZ, surfel::Support})
            sum += *reinterpret_cast<const std::uint32_t*>(block.channel(cluster, channel));
        for (int channel = shape; shape > 0 && channel < shape + 3; ++channel)
            sum += *reinterpret_cast<const std::uint32_t*>(block.channel(cluster, channel));
    });
    return sum;
}

PatchPtr makePatch(const surface::Surface& surface, const base::Vec3d& tool, double reach, double time) {
    const base::Vec3f at = base::cast<float>(tool);
    const base::Box3f box = base::Box3f{at, at}.inflated(static_cast<float>(reach));
    auto out = std::make_shared<Patch>(Patch{surface, time, box});
    [[maybe_unused]] volatile std::uint32_t kept = read(surface, box);
    return out;
}

} // namespace haptics
