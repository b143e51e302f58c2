#include "core/haptics/texture.h"

#include "core/surface/evaluation/weights.h"
#include "core/surface/projection/foot_step.h"

#include <algorithm>

namespace haptics {

using base::Vec3d, surface::Surface;

namespace {

constexpr double step = 0.05;     ///< of h, to each side: differences
constexpr double middling = 0.02; ///< of h: a height that is felt by 0.7 of what a large one is
constexpr double steepest = 4;    ///< of h: what changes faster is no texture but a fold, or noise
constexpr double deepest = 0.4;   ///< of h: texture is felt as if the tool were no deeper
constexpr double approach = 0.1;  ///< of h: contacts come in from there

/// From -1 in hollows to 1 on ridges. A surface stands over the mean of its surfels by how it bends.
double heightAt(const Surface& surface, const Foot& foot) {
    const auto at =
        surface.evaluateReference(foot.position, surface::Need::Value, {base::cast<float>(foot.normal * foot.side)});
    if (!at.ok())
        return 0;
    const double height = dot(foot.normal, foot.position - at.centroid) / (middling * at.unit);
    return height / std::sqrt(1 + height * height);
}

/// From -1, black, to 1, white; as the eye weighs colours.
double lightnessAt(const Surface& surface, const Foot& foot) {
    double weight = 0, sum = 0;
    forWeights(surface, base::cast<float>(foot.position), [&](const surfel::SurfelBlock& block, int slot, float theta) {
        const surfel::Colour c =
            block.words(slot / surfel::clusterSize, surfel::ColourWord)[slot % surfel::clusterSize];
        const unsigned light = 2126 * (c & 255) + 7152 * (c >> 8 & 255) + 722 * (c >> 16 & 255);
        weight += static_cast<double>(theta);
        sum += static_cast<double>(theta) * light;
    });
    return weight > 0 ? sum / weight / (0.5 * 255 * 10000) - 1 : 0;
}

/// What is added to a factor of 1.
double excessAt(const Texture& texture, const Surface& surface, const Foot& foot) {
    double out = 0;
    if (texture.relief != 0)
        out += 0.5 * texture.relief * heightAt(surface, foot);
    if (texture.colour != 0 && surface.tree().layout()->colours)
        out += 0.5 * texture.colour * lightnessAt(surface, foot);
    return out;
}

/// Its change as the tool moves, `depth` in the surface: the foot goes farther than the tool does where that is inside
/// of a bend.
Vec3d slopeAt(const Texture& texture, const Surface& surface, const Foot& foot, double above) {
    const Vec3d u = base::perpendicular(foot.normal), v = cross(foot.normal, u);
    Vec3d along;
    for (const Vec3d& way : {u, v}) {
        Foot there[2];
        if (track(surface, foot.position + way * (step * foot.unit), foot, there[1]) != Tracked::Found ||
            track(surface, foot.position - way * (step * foot.unit), foot, there[0]) != Tracked::Found)
            continue; // beside a rim there is no telling
        const double apart = dot(there[1].position - there[0].position, way);
        if (!(apart > step * foot.unit)) // nor where both ended at one place
            continue;
        along += way * ((excessAt(texture, surface, there[1]) - excessAt(texture, surface, there[0])) / apart);
    }
    surface::TangentMatrix<double> matrix(foot.normal);
    matrix.add(foot.bend, above);
    const Vec3d out = matrix.solve(along, 0.5);
    const double most = steepest / foot.unit, size = length(out);
    return size > most ? out * (most / size) : out;
}

} // namespace

Grain grainAt(const Texture& texture, const Proxy& proxy, const Surface& surface) {
    Grain out;
    if (texture.none())
        return out;
    double sum = 0, excess = 0;
    Vec3d slope;
    const double radius = proxy.tool().radius;
    for (const Foot& foot : proxy.contacts().feet()) {
        const double gap = gapOf(foot, proxy.position(), radius);
        const double part = std::clamp(1 - gap / (approach * foot.unit), 0.0, 1.0);
        if (part == 0)
            continue;
        sum += part;
        out.felt += part * deepest * foot.unit;
        excess += part * excessAt(texture, surface, foot);
        slope += slopeAt(texture, surface, foot, radius - proxy.depth()) * part;
    }
    if (sum > 0) {
        out.factor += excess / sum;
        out.slope = slope / sum;
        out.felt /= sum;
    }
    return out;
}

} // namespace haptics
