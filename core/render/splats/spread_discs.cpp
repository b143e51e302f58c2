#include "core/render/splats/spread_discs.h"

#include "core/render/splats/disc_cuts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

namespace {

/// Of one ring: a disc in the middle and six about it cover all of the disc they stand for but for a fiftieth of its
/// radius.
constexpr float finerRadius = 0.6f, ringRadius = 0.75f;
/// The step of lattices with more, in finer radii: 1.73 leave no gap, from 1.5 on shading shows it.
constexpr float latticeStep = 1.35f;
/// How far from its end a disc's lattice ends, in finer radii: what is left is covered.
constexpr float toEnd = 0.3f;
/// How far finer discs reach where the surface ends.
constexpr float endReach = 1.85f;

/// In pixels: discs are not worth a finer one below the first, shall stand out by less than the second; where the
/// surface ends none shall be larger than the third, and none is made smaller than the last.
constexpr float leastSeen = 4, mostStandOut = 0.7f, mostAtEnds = 5, leastMade = 2.5f;

} // namespace

int spreadRings(const SeenDisc& disc) {
    if (!(disc.radius >= leastSeen))
        return 0;
    const float bends = finerRadius * std::sqrt(disc.standOut / mostStandOut);
    const float ends = disc.ends ? finerRadius * disc.radius / mostAtEnds : 0;
    const float most = std::min(float(mostRings), finerRadius * disc.radius / leastMade);
    return std::max(1, static_cast<int>(std::min(std::ceil(std::max(bends, ends)), most)));
}

static float stepOf(int rings) {
    return rings > 1 ? latticeStep * spreadRadius(rings) : ringRadius;
}

float spreadRadius(int rings) {
    return rings > 0 ? finerRadius / static_cast<float>(rings) : 1;
}

std::vector<base::Vec3f> spreadPlaces(const base::Vec3f& normal, int rings, bool ends) {
    std::vector<base::Vec3f> out{{}};
    if (rings == 0)
        return out;
    const base::Vec3f u = discAxis(normal), v = cross(normal, u);
    const float step = stepOf(rings), radius = spreadRadius(rings);
    const float reach = ends && rings > 1 ? endReach - radius : 1 - toEnd * radius;
    const int count = static_cast<int>(reach / (step * std::numbers::sqrt3_v<float> / 2)) + 1;
    for (int j = -count; j <= count; ++j)
        for (int i = -2 * count; i <= 2 * count; ++i) {
            const float a = step * (static_cast<float>(i) + 0.5f * static_cast<float>(j)),
                        b = step * static_cast<float>(j) * (std::numbers::sqrt3_v<float> / 2);
            if ((i != 0 || j != 0) && a * a + b * b <= reach * reach)
                out.push_back(u * a + v * b);
        }
    return out;
}

base::Vec3f fartherIn(const base::Vec3f& place, int rings) {
    const float far = length(place), half = 0.5f * stepOf(rings);
    return far > half ? place * (1 - half / far) : place;
}

} // namespace render
