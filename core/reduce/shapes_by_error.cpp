#include "core/reduce/shapes_by_error.h"

#include "core/base/parallel.h"
#include "core/reduce/density.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace reduce {

namespace {

using base::Mat3d, base::Vec3d, base::Vec3f;

constexpr std::size_t probesPerSample = 4;
constexpr double supportArea = 6; ///< of the unit, as in density.cpp
constexpr std::size_t mostNeighbours = 400;
constexpr float leastFacing = 0.1f, likeFacing = 0.3f, opposed = -0.1f;
constexpr double heightShare = 0.03;
constexpr double aspects[] = {1.5, 2.2, 3.2};
constexpr double widest = 3.2;
constexpr int directions = 8;
/// What an ellipse must leave of a disc's error to be worth its word.
constexpr double worth = 0.9;
/// Where normals within a spacing turn farther than this, an edge is there: supports along it would leave holes. Where
/// another sheet is within reach, they would reach over it.
constexpr float edge = 0.5f;
/// Errors below this part of the unit's root are none: what rounding leaves has no shape.
constexpr double least = 1e-5;
constexpr std::size_t smoothedOver = 12;
constexpr int smoothings = 3;
/// Shares go with this power of the error (reduce/README 3.2).
constexpr double power = 0.55;

/// The shape at a place as the logarithm of its metric, which means can be taken of: log (a1 / a2) (e e^T - u u^T), e
/// along the short axis, u along the long one; and the logarithm of what it leaves of the error.
struct Stretch {
    Mat3d log;
    double left = 0;
};

Mat3d stretchAlong(const Vec3d& e, const Vec3d& u, double aspect) {
    return (base::outer(e, e) - base::outer(u, u)) * std::log(aspect);
}

/// A place around the probe in its tangent plane, in radii of the disc; the square of what it errs.
struct Around {
    double u, v, square;
};

/// sum w e^2 / sum w over the ellipse of the disc's area.
double errorIn(const std::vector<Around>& around, double aspect, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    double sum = 0, weight = 0;
    for (const Around& a : around) {
        const double along = a.u * c + a.v * s, across = a.v * c - a.u * s;
        const double w = 1 - (along * along / aspect + across * across * aspect);
        if (w > 0)
            sum += w * a.square, weight += w;
    }
    return weight > 0 ? sum / weight : std::numeric_limits<double>::infinity();
}

Stretch stretchAt(const Places& places, const NumberedTree& tree, std::uint32_t j, double unit,
                  std::vector<std::uint32_t>& in, std::vector<Around>& around) {
    const double radius = std::sqrt(supportArea * unit / std::numbers::pi);
    const Vec3f y = places.position[j], n = places.normal[j];
    in.clear();
    bool sharp = false;
    tree.forBall(y, static_cast<float>(radius * std::sqrt(widest)), [&](std::uint32_t k, float distanceSq) {
        const float c = dot(n, places.normal[k]), cosine = places.oriented ? c : std::abs(c);
        sharp |= cosine < edge && (cosine <= opposed || double(distanceSq) < unit);
        if (cosine > leastFacing)
            in.push_back(k);
    });
    if (sharp)
        return {};
    const Vec3d v = base::cast<double>(n), first = base::perpendicular(v), second = cross(v, first);
    around.clear();
    const std::size_t stride = in.size() / mostNeighbours + 1;
    for (std::size_t k = 0; k < in.size(); k += stride) {
        const Vec3d q = base::cast<double>(places.position[in[k]] - y);
        Vec3d other = base::cast<double>(places.normal[in[k]]);
        if (dot(other, v) < 0)
            other = -other;
        const double e = 0.5 * dot(v + other, q), z = heightShare * dot(v, q);
        around.push_back({dot(q, first) / radius, dot(q, second) / radius, e * e + z * z});
    }
    const double noise = least * least * unit, disc = errorIn(around, 1, 0) + noise;
    double best = disc;
    Stretch out;
    if (around.size() < 8 || !std::isfinite(disc))
        return out;
    for (const double aspect : aspects)
        for (int k = 0; k < directions; ++k) {
            const double angle = k * std::numbers::pi / directions, error = errorIn(around, aspect, angle) + noise;
            if (error >= best || std::sqrt(error / disc) > worth)
                continue;
            best = error;
            const Vec3d u = first * std::cos(angle) + second * std::sin(angle);
            out = {stretchAlong(cross(v, u), u, aspect), 0.5 * std::log(error / disc)};
        }
    return out;
}

/// b of the metric whose logarithm this is, in the tangent plane across n.
Vec3f shapeOf(const Mat3d& log, const Vec3f& normal) {
    const Vec3d n = base::cast<double>(normal), s = base::perpendicular(n), t = cross(n, s);
    const Vec3d ls = log * s, lt = log * t;
    const double p = 0.5 * (dot(s, ls) - dot(t, lt)), q = dot(s, lt), k = std::hypot(p, q);
    const double most = std::log(double(surfel::mostAspect));
    constexpr double round = 0.02;
    if (!(k > round))
        return {};
    const double angle = 0.5 * std::atan2(q, p), size = std::sqrt(std::exp(2 * std::min(k, most)) - 1);
    return base::cast<float>(s * (size * std::cos(angle)) + t * (size * std::sin(angle)));
}

class Probes {
  public:
    Probes(const Places& places, const NumberedTree& tree, std::span<const float> shares, std::size_t count)
        : m_places(places) {
        const std::size_t stride = std::max<std::size_t>(1, places.size() / (probesPerSample * count));
        for (std::size_t j = 0; j < places.size(); j += stride) {
            m_which.push_back(static_cast<std::uint32_t>(j));
            m_position.push_back(places.position[j]);
            m_normal.push_back(places.normal[j]);
        }
        m_tree = NumberedTree(m_position, m_normal, {});
        m_stretch.resize(m_which.size());
        base::parallelChunks(m_which.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<std::uint32_t> in;
            std::vector<Around> around;
            for (std::size_t c = begin; c < end; ++c) {
                const float s = spacingAt(places, shares, m_which[c]);
                m_stretch[c] = stretchAt(places, tree, m_which[c], double(s) * double(s), in, around);
            }
        });
        for (int k = 0; k < smoothings; ++k)
            smooth();
    }

    double meanLeft() const {
        double sum = 0;
        for (const Stretch& each : m_stretch)
            sum += each.left;
        return std::exp(sum / double(m_stretch.size()));
    }

    /// Of the nearest probes of its sheet.
    Stretch at(std::size_t place, float spacing, std::vector<tree::Neighbour>& near) const {
        m_tree.tree().nearest(m_places.position[place], 4, near);
        Stretch out;
        double weight = 0;
        for (const tree::Neighbour& n : near) {
            const std::uint32_t c = NumberedTree::number(n);
            if (!m_places.facing(m_normal[c], m_places.normal[place], likeFacing))
                continue;
            const double w = 1 / (double(n.distanceSq) + 0.05 * double(spacing) * double(spacing) + 1e-300);
            out.log += m_stretch[c].log * w, out.left += w * m_stretch[c].left, weight += w;
        }
        if (weight > 0)
            out.log *= 1 / weight, out.left /= weight;
        return out;
    }

  private:
    void smooth() {
        std::vector<Stretch> out(m_stretch.size());
        base::parallelChunks(out.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> near;
            for (std::size_t c = begin; c < end; ++c) {
                m_tree.tree().nearest(m_position[c], smoothedOver, near);
                Stretch sum = m_stretch[c];
                double weight = 1;
                for (const tree::Neighbour& n : near) {
                    const std::uint32_t k = NumberedTree::number(n);
                    if (k == c || !m_places.facing(m_normal[c], m_normal[k], likeFacing))
                        continue;
                    const double w = std::abs(double(dot(m_normal[c], m_normal[k])));
                    sum.log += m_stretch[k].log * w, sum.left += w * m_stretch[k].left, weight += w;
                }
                out[c] = {sum.log * (1 / weight), sum.left / weight};
            }
        });
        m_stretch = std::move(out);
    }

    const Places& m_places;
    std::vector<std::uint32_t> m_which;
    std::vector<Vec3f> m_position, m_normal;
    NumberedTree m_tree;
    std::vector<Stretch> m_stretch;
};

} // namespace

double shapeByError(Places& places, const NumberedTree& tree, std::vector<float>& shares, std::size_t count) {
    const Probes probes(places, tree, shares, count);
    places.shape.resize(places.size());
    base::parallelChunks(places.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<tree::Neighbour> near;
        for (std::size_t i = begin; i < end; ++i) {
            const Stretch at = probes.at(i, spacingAt(places, shares, i), near);
            places.shape[i] = shapeOf(at.log, places.normal[i]);
            shares[i] *= static_cast<float>(std::exp(power * at.left));
        }
    });
    scaleShares(shares, count);
    return probes.meanLeft();
}

} // namespace reduce
