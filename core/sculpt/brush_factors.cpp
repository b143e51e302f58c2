#include "core/sculpt/brush_factors.h"

#include "core/base/mat3.h"
#include "core/sculpt/brush_connected.h"
#include "core/sculpt/brush_stamp.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

using base::Vec3d;
using base::Vec3f;
using surfel::clusterSize;
using surfel::SurfelBlock;

/// Cosine up to which a surfel counts as fully facing: 70 degrees.
constexpr float fullyFacing = 0.342f;

BrushFactors::BrushFactors(const Dab& dab)
    : m_frontFacing(dab.frontFacing), m_oriented(dab.oriented), m_view(dab.view), m_centre(dab.centre),
      m_right(dab.stampRight), m_up(dab.stampUp), m_radius(dab.radius), m_level(dab.stampLevel), m_stamp(dab.stamp),
      m_connected(dab.connected) {}

static void multiplyLane(FactorLanes& out, std::size_t i, float value, const Vec3f& gradient) {
    out.gx[i] = out.gx[i] * value + out.value[i] * gradient.x;
    out.gy[i] = out.gy[i] * value + out.value[i] * gradient.y;
    out.gz[i] = out.gz[i] * value + out.value[i] * gradient.z;
    out.value[i] *= value;
}

/// Gradient of the least-squares plane through `value` over the chosen slots; zero where they make none.
static Vec3f planeGradient(const SurfelBlock& block, int first, const float* value, const bool* chosen) {
    Vec3d mean;
    double mid = 0, count = 0;
    for (int i = 0; i < clusterSize; ++i)
        if (chosen[i])
            mean += base::cast<double>(block.position(first + i)), mid += double(value[i]), ++count;
    if (count < 4)
        return {};
    mean = mean / count, mid /= count;
    base::Mat3d spread;
    Vec3d slope;
    for (int i = 0; i < clusterSize; ++i)
        if (chosen[i]) {
            const Vec3d d = base::cast<double>(block.position(first + i)) - mean;
            spread += outer(d, d);
            slope += d * (double(value[i]) - mid);
        }
    const double ridge = 1e-4 * trace(spread); // the surface is flat: nothing is known across it
    if (!(ridge > 0))
        return {};
    spread += base::Mat3d::identity() * ridge;
    return base::cast<float>(solvePositive(spread, slope));
}

void BrushFactors::face(const SurfelBlock& block, int cluster, FactorLanes& out) const {
    const int first = cluster * clusterSize, count = std::min(clusterSize, block.size() - first);
    float value[clusterSize] = {};
    Vec3f normal[clusterSize];
    int best = 0;
    float highest = -2, lowest = 2, bestFacing = -2;
    for (int i = 0; i < count; ++i) {
        normal[i] = block.normal(first + i);
        float facing = -dot(normal[i], m_view);
        if (!m_oriented && facing < 0)
            facing = -facing, normal[i] = -normal[i];
        const float t = std::clamp(facing / fullyFacing, 0.0f, 1.0f);
        value[i] = t * t * (3 - 2 * t);
        if (facing > bestFacing)
            bestFacing = facing, best = i;
        highest = std::max(highest, value[i]), lowest = std::min(lowest, value[i]);
    }
    bool sameSide[clusterSize] = {};
    Vec3f gradient;
    if (highest > lowest) {
        for (int i = 0; i < count; ++i)
            sameSide[i] = dot(normal[i], normal[best]) > 0;
        gradient = planeGradient(block, first, value, sameSide);
    }
    for (int i = 0; i < count; ++i) {
        const bool fades = sameSide[i] && value[i] > 0 && value[i] < 1;
        multiplyLane(out, static_cast<std::size_t>(i), value[i],
                     fades ? gradient - normal[i] * dot(gradient, normal[i]) : Vec3f{});
    }
}

void BrushFactors::press(const SurfelBlock& block, int cluster, FactorLanes& out) const {
    const int first = cluster * clusterSize, count = std::min(clusterSize, block.size() - first);
    const float scale = 1 / m_radius;
    for (int i = 0; i < count; ++i) {
        const Vec3f p = (block.position(first + i) - m_centre) * scale;
        const BrushStamp::Value at = m_stamp->at(dot(p, m_right), dot(p, m_up), m_level);
        multiplyLane(out, static_cast<std::size_t>(i), at.value, (m_right * at.du + m_up * at.dv) * scale);
    }
}

void BrushFactors::fill(std::uint32_t number, const SurfelBlock& block, int cluster, FactorLanes& out) const {
    std::fill_n(out.value, clusterSize, 1.0f);
    for (float* gradient : {out.gx, out.gy, out.gz})
        std::fill_n(gradient, clusterSize, 0.0f);
    if (m_frontFacing)
        face(block, cluster, out);
    if (m_stamp)
        press(block, cluster, out);
    if (!m_connected)
        return;
    const Connected::Slots* slots = m_connected->slotsOf(number);
    for (std::size_t i = 0; i < clusterSize; ++i)
        if (!slots || !slots->test(static_cast<std::size_t>(cluster) * clusterSize + i))
            out.value[i] = out.gx[i] = out.gy[i] = out.gz[i] = 0;
}

void BrushFactors::multiply(std::uint32_t number, const SurfelBlock& block, int cluster, float* weight) const {
    if (none())
        return;
    FactorLanes by;
    fill(number, block, cluster, by);
    for (std::size_t i = 0; i < clusterSize; ++i)
        weight[i] *= by.value[i];
}

void BrushFactors::multiply(std::uint32_t number, const SurfelBlock& block, int cluster, float* amount, float* gx,
                            float* gy, float* gz) const {
    if (none())
        return;
    FactorLanes by;
    fill(number, block, cluster, by);
    for (std::size_t i = 0; i < clusterSize; ++i) {
        gx[i] = by.value[i] * gx[i] + amount[i] * by.gx[i];
        gy[i] = by.value[i] * gy[i] + amount[i] * by.gy[i];
        gz[i] = by.value[i] * gz[i] + amount[i] * by.gz[i];
        amount[i] *= by.value[i];
    }
}

} // namespace sculpt
