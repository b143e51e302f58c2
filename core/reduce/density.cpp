#include "core/reduce/density.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"

#include <algorithm>
#include <numbers>

namespace reduce {

namespace {

/// Errors are measured at so many places for each sample, and are smooth in between.
constexpr std::size_t probesPerSample = 4;
/// A support holds this many samples (reduce/README 3.3), less what its rim weighs.
constexpr double supportArea = 6;
constexpr std::size_t mostNeighbours = 220;
constexpr float leastFacing = 0.1f, likeFacing = 0.3f, opposed = -0.1f;
/// What irregular samples cost through n(x), as a part of heights over the tangent plane.
constexpr double heightShare = 0.03;
/// Least errors that count: a part of the median one, and of the dense spacing.
constexpr double leastOfMedian = 0.25, leastOfSpacing = 0.003;
/// Errors fall with some power p of a sample's area; with e' in roots of the local unit of area a0, the sum of squares
/// is least for areas as a0 (a0 e')^(-2 / (2 p + 1)). p = 1.3.
constexpr double power = -0.55;
/// Near another sheet samples get smaller with this power of their own sheet's share.
constexpr double crowdPower = 1;
constexpr double widest = 8; ///< farthest that areas depart from the local unit, either way
/// Where less than this part of the disc holds surface, as on strips and crumbs, samples get smaller.
constexpr double fullDisc = 0.5;
constexpr std::size_t smoothedOver = 12;
constexpr int smoothings = 3;
constexpr double mostShare = 0.77; ///< of a place: reduced samples are not denser than dense ones

struct Probe {
    double error = -1; ///< relative to the root of the unit of area; < 0: unknown
    double fill = 1;   ///< share of the disc that holds surface
    double clear = 1;  ///< share of the surface in reach that is of the same sheet
};

/// The terms of the shrink-free form between one place and those around it, as if one support held them all.
Probe probeAt(const Places& places, const NumberedTree& tree, std::size_t j, double unit,
              std::vector<std::uint32_t>& in) {
    const float radius = static_cast<float>(std::sqrt(supportArea * unit / std::numbers::pi));
    const base::Vec3f y = places.position[j], v = places.normal[j];
    in.clear();
    double area = 0, against = 0;
    tree.forBall(y, radius, [&](std::uint32_t k, float) {
        if (places.oriented && dot(v, places.normal[k]) < opposed)
            against += double(places.area[k]);
        if (!places.facing(v, places.normal[k], leastFacing))
            return;
        in.push_back(k);
        area += double(places.area[k]);
    });
    Probe out;
    out.fill = std::min(1.0, area / (supportArea * unit));
    out.clear = area / (area + against);
    const std::size_t stride = in.size() / mostNeighbours + 1;
    double sum = 0, weight = 0;
    for (std::size_t k = 0; k < in.size(); k += stride) {
        const base::Vec3d q = base::cast<double>(places.position[in[k]] - y);
        base::Vec3f other = places.normal[in[k]];
        if (dot(other, v) < 0)
            other = -other;
        const double w = 1 - lengthSq(q) / double(radius * radius), z = dot(base::cast<double>(v), q);
        const double e = 0.5 * dot(base::cast<double>(v + other), q);
        sum += w * (e * e + heightShare * heightShare * z * z);
        weight += w;
    }
    if (in.size() >= 4 && weight > 0)
        out.error = std::sqrt(sum / weight / unit);
    return out;
}

/// Places that errors are measured at, with the logarithm of the area that a sample may have there.
class Probes {
  public:
    Probes(const Places& places, const NumberedTree& tree, std::size_t count) : m_places(places) {
        const std::size_t stride = std::max<std::size_t>(1, places.size() / (probesPerSample * count));
        for (std::size_t j = 0; j < places.size(); j += stride) {
            m_which.push_back(static_cast<std::uint32_t>(j));
            m_position.push_back(places.position[j]);
            m_normal.push_back(places.normal[j]);
        }
        m_tree = NumberedTree(m_position, m_normal, {});
        measure(tree, double(places.size()) / double(count));
        for (int k = 0; k < smoothings; ++k)
            smooth();
    }
    /// At a place: of the nearest probes of its sheet.
    double logArea(const base::Vec3f& x, const base::Vec3f& normal, std::vector<tree::Neighbour>& near) const {
        m_tree.tree().nearest(x, 4, near);
        double sum = 0, weight = 0;
        for (const tree::Neighbour& n : near) {
            const std::uint32_t c = NumberedTree::number(n);
            if (!m_places.facing(m_normal[c], normal, likeFacing))
                continue;
            const double w = 1 / (double(n.distanceSq) + 0.05 * std::exp(m_log[c]) + 1e-300);
            sum += w * m_log[c], weight += w;
        }
        return weight > 0 ? sum / weight : m_log[NumberedTree::number(near.front())];
    }

  private:
    void measure(const NumberedTree& tree, double ratio) {
        const std::size_t n = m_which.size();
        std::vector<Probe> probes(n);
        std::vector<double> unit(n);
        base::parallelChunks(n, 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<std::uint32_t> in;
            for (std::size_t c = begin; c < end; ++c) {
                unit[c] = std::max(double(m_places.area[m_which[c]]) * ratio, 1e-300);
                probes[c] = probeAt(m_places, tree, m_which[c], unit[c], in);
            }
        });
        std::vector<double> errors, units = unit;
        for (const Probe& p : probes)
            if (p.error >= 0)
                errors.push_back(p.error);
        const double typical = base::median(errors), typicalUnit = base::median(units);
        const double least = std::max(leastOfMedian * typical, leastOfSpacing / std::sqrt(ratio));
        const double reference = std::hypot(typical, least);
        m_log.resize(n);
        for (std::size_t c = 0; c < n; ++c) {
            const double e = std::hypot(probes[c].error >= 0 ? probes[c].error : typical, least);
            const double asked = power * std::log(e / reference * unit[c] / typicalUnit);
            m_log[c] = std::log(unit[c]) + std::clamp(asked, -std::log(widest), std::log(widest)) +
                       2 * std::log(std::clamp(probes[c].fill / fullDisc, 0.1, 1.0)) +
                       crowdPower * std::log(std::clamp(probes[c].clear, 0.2, 1.0));
        }
    }

    void smooth() {
        std::vector<double> out(m_log.size());
        base::parallelChunks(m_log.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> near;
            for (std::size_t c = begin; c < end; ++c) {
                m_tree.tree().nearest(m_position[c], smoothedOver, near);
                double sum = m_log[c], weight = 1;
                for (const tree::Neighbour& n : near) {
                    const std::uint32_t k = NumberedTree::number(n);
                    if (k == c || !m_places.facing(m_normal[c], m_normal[k], likeFacing))
                        continue;
                    const double w = std::abs(double(dot(m_normal[c], m_normal[k])));
                    sum += w * m_log[k], weight += w;
                }
                out[c] = sum / weight;
            }
        });
        m_log = std::move(out);
    }

    const Places& m_places;
    std::vector<std::uint32_t> m_which;
    std::vector<base::Vec3f> m_position, m_normal;
    NumberedTree m_tree;
    std::vector<double> m_log;
};

/// One factor for all, so that together they are `count` and none is above `most`.
void scale(std::vector<float>& shares, double count, double most) {
    double low = -60, high = 60; // powers of e
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high), factor = std::exp(middle);
        base::CancelScope::check();
        double sum = 0;
        for (const float share : shares)
            sum += std::min(factor * double(share), most);
        (sum < count ? low : high) = middle;
    }
    const double factor = std::exp(high);
    for (float& share : shares)
        share = static_cast<float>(std::max(std::min(factor * double(share), most), 1e-9));
}

} // namespace

std::vector<float> sharesByError(const Places& places, const NumberedTree& tree, std::size_t count) {
    const Probes probes(places, tree, count);
    std::vector<float> out(places.size());
    base::parallelChunks(out.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            const double log = probes.logArea(places.position[i], places.normal[i], near);
            out[i] = static_cast<float>(std::clamp(double(places.area[i]) * std::exp(-log), 1e-6, 1e3));
        }
    });
    scaleShares(out, count);
    return out;
}

void scaleShares(std::vector<float>& shares, std::size_t count) {
    const double n = double(shares.size());
    scale(shares, double(count), std::min(1.0, std::max(mostShare, 1.02 * double(count) / n)));
}

std::vector<float> sharesBySpacing(const Places& places, float spacing) {
    std::vector<float> out(places.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = std::clamp(places.area[i] / (spacing * spacing), 1e-9f, 1.0f);
    return out;
}

} // namespace reduce
