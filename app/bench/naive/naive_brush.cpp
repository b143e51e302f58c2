#include "app/bench/naive/naive_brush.h"

#include "app/bench/naive/naive_cloud.h"
#include "core/base/scratch.h"

#include <algorithm>
#include <Eigen/Dense>

namespace bench {

using base::Vec3f;

namespace {

/// Of a dab of full strength, in radii.
constexpr double depth = 0.05;

Eigen::Vector3d eigenOf(const Vec3f& v) {
    return Eigen::Vector3d(v.x, v.y, v.z);
}
Vec3f vectorOf(const Eigen::Vector3d& v) {
    return base::cast<float>(base::Vec3d{v.x(), v.y(), v.z()});
}

/// The smooth falloff at r radii.
double weight(double r) {
    return 1 + r * r * (2 * r - 3);
}

} // namespace

void naiveDraw(const NaiveSurface& surface, const NaiveDab& dab, std::vector<surfel::Surfel>& out) {
    const Eigen::Vector3d centre = eigenOf(dab.centre), up = eigenOf(dab.normal);
    const double radius = static_cast<double>(dab.radius), full = static_cast<double>(dab.strength) * depth * radius;
    out.clear();
    surface.cloud().forBall(dab.centre, dab.radius, [&](surfel::Surfel s, float) {
        const Eigen::Vector3d q = eigenOf(s.position) - centre, n = eigenOf(s.normal);
        const double r = std::min(1.0, q.norm() / radius);
        const Eigen::Vector3d slope = q * (6 * (r - 1) * full / (radius * radius));
        s.position = vectorOf(eigenOf(s.position) + up * (full * weight(r)));
        s.normal = vectorOf((n * (1 + slope.dot(up)) - slope * up.dot(n)).normalized());
        out.push_back(s);
    });
}

void naiveSmooth(const NaiveSurface& surface, const NaiveDab& dab, std::vector<surfel::Surfel>& out) {
    static base::Scratch<std::vector<std::pair<surfel::Surfel, double>>> scratch;
    const auto under = scratch.take();
    under->clear();
    out.clear();
    surface.cloud().forBall(dab.centre, dab.radius, [&](const surfel::Surfel& s, float distanceSq) {
        const double r = std::sqrt(static_cast<double>(distanceSq)) / static_cast<double>(dab.radius);
        under->push_back({s, static_cast<double>(dab.strength) * weight(std::min(1.0, r))});
    });
    for (auto& [s, share] : *under) {
        const NaiveEvaluation e = surface.evaluate(base::cast<double>(s.position), surface::Need::Gradient);
        const double slope = length(e.gradient);
        if (e.valid && slope > 0.1) {
            const base::Vec3d along = e.gradient / slope;
            s.position += base::cast<float>(along * (-share * e.value / slope));
            s.normal = base::cast<float>(normalized(base::cast<double>(s.normal) * (1 - share) + along * share));
        }
        out.push_back(s);
    }
}

} // namespace bench
