#include "core/sculpt/tools/layer.h"

#include "core/base/parallel.h"
#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"height", "Height", "radii", "Greatest thickness of the layer that one stroke lays.", 0.1, 0.005, 0.5},
};

namespace {

using Foot = surface::Projection<float>;

std::vector<Foot> feetOf(const surface::Surface& first, const std::vector<base::Vec3f>& places) {
    surface::ProjectOptions options;
    options.tolerance = 1e-5;
    options.checkBoundary = false;
    std::vector<Foot> out(places.size());
    surface::project(first, places, options, out);
    return out;
}

/// 1 - P and its gradient after the dabs named.
struct Left {
    float value = 1;
    base::Vec3f gradient;
};

class Layering {
  public:
    Layering(const surface::Surface& first, const Dab& dab) : m_brush(dab) {
        std::vector<base::Vec3f> centres{dab.centre};
        m_dabs.push_back({dab.centre, dab.radius, std::abs(dab.strength)});
        for (const PastDab& past : dab.past)
            if (distance(past.centre, dab.centre) < 2 * (past.radius + dab.radius))
                m_dabs.push_back(past), centres.push_back(past.centre);
        const std::vector<Foot> feet = feetOf(first, centres);
        for (std::size_t j = 0; j < feet.size(); ++j)
            m_dabs[j].centre = feet[j].ok() ? feet[j].foot : centres[j];
    }

    /// P_k - P_{k-1} at q, and its gradient over q.
    void step(const base::Vec3f& q, float& value, base::Vec3f& gradient) const {
        const Left past = left(q, 1, m_dabs.size()), now = left(q, 0, 1);
        value = past.value * (1 - now.value);
        gradient = past.gradient * (1 - now.value) - now.gradient * past.value;
    }

  private:
    Left left(const base::Vec3f& q, std::size_t begin, std::size_t end) const {
        Left out;
        for (std::size_t j = begin; j < end && out.value > 0; ++j) {
            const base::Vec3f d = q - m_dabs[j].centre;
            const float l = length(d), r = l / m_dabs[j].radius;
            if (r >= 1)
                continue;
            float w = 0, slope = 0;
            weights(m_brush.falloff, 0, {&r, 1}, {&w, 1}, {&slope, 1}, m_brush.curve.get());
            const float s = std::min(1.0f, std::abs(m_dabs[j].strength)), factor = 1 - s * w;
            const float k = l > 1e-12f ? -s * slope / (m_dabs[j].radius * l) : 0.0f; // grad factor = k d
            out.gradient = out.gradient * factor + d * (k * out.value);
            out.value *= factor;
        }
        return out;
    }

    const Brush m_brush;
    std::vector<PastDab> m_dabs; ///< the present one first; centres on the first version
};

/// D of one surfel and its gradient; false where it has no foot.
bool shiftOf(const Layering& layering, const base::Vec3f& p, const base::Vec3f& outwards, const Foot& foot,
             float height, base::Vec3f& shift, base::Mat3f& gradient) {
    base::Vec3f n = normalized(foot.at.gradient);
    if (!foot.ok() || n == base::Vec3f{})
        return false;
    base::Mat3f bend = foot.at.normalGradient;
    if (dot(foot.at.normal, n) < 0)
        bend *= -1;
    if (dot(n, outwards) < 0)
        n = -n, bend *= -1;
    const base::Mat3f flat = base::Mat3f::identity() - outer(n, n);
    bend = flat * bend * flat;
    const base::Mat3f toFoot = inverse(base::Mat3f::identity() + bend * dot(n, p - foot.foot)) * flat;
    float step = 0;
    base::Vec3f slope;
    layering.step(foot.foot, step, slope);
    shift = n * (height * step);
    gradient = outer(n, transposed(toFoot) * (slope * height)) + bend * toFoot * (height * step);
    return true;
}

} // namespace

static tree::Edit layer(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.strength == 0)
        return {};
    const surface::Surface& first = dab.first ? *dab.first : version;
    const float height = std::copysign(dab.parameter("height") * dab.radius, dab.strength);
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const Gathered list = gather(blocks, brush);
    const std::vector<Foot> feet = feetOf(first, list.places);
    const Layering layering(first, dab);
    return deform(version.tree(), blocks, brush, [&](const LanePlace& where, const BrushLanes&, ShiftLanes& out) {
        out.clear();
        list.forCluster(where.index, where.cluster, [&](std::size_t i, std::size_t lane) {
            const base::Vec3f outwards = dab.oriented ? where.in.block->normal(list.slots[i]) : dab.areaNormal;
            base::Vec3f shift;
            base::Mat3f gradient;
            if (shiftOf(layering, list.places[i], outwards, feet[i], height, shift, gradient))
                out.set(lane, shift, gradient);
        });
    });
}

const ToolRow layerTool{"layer",
                        "Layer",
                        "icons/tool-layer.svg",
                        "L",
                        "Raises the surface by a limited height, however often the stroke passes; inverted, lowers it.",
                        Motion::Along,
                        0.5,
                        parameters,
                        layer,
                        Writes::Surface};

} // namespace sculpt
