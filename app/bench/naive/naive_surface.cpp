#include "app/bench/naive/naive_surface.h"

#include "app/bench/naive/naive_cloud.h"
#include "app/bench/naive/naive_jet.h"

namespace bench {

using base::Vec3d;
using base::Vec3f;
using surface::Need;
using surface::Projector;

namespace {

Eigen::Vector3d eigenOf(const Vec3f& v) {
    return {v.x, v.y, v.z};
}

Vec3d vectorOf(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Wendland's (1-r)^4 (4r+1) of |q| / h, with t = 1 - r: grad = -20 t^3 / h^2 q.
template <int O>
NaiveJet<O> weight(const Eigen::Vector3d& q, double distance, double h) {
    NaiveJet<O> out;
    const double t = 1 - distance / h;
    out.v = t * t * t * t * (5 - 4 * t);
    const double slope = -20 * t * t * t / (h * h);
    if constexpr (O >= 1)
        out.g = slope * q;
    if constexpr (O >= 2) {
        out.h = slope * Eigen::Matrix3d::Identity();
        if (distance > 1e-12 * h)
            out.h += (60 * t * t / (h * h * h * distance)) * q * q.transpose();
    }
    return out;
}

template <int O>
struct Sums {
    NaiveJet<O> one, height;      ///< sum theta, sum theta n.(x-p)
    NaiveJet<O> offset[3], up[3]; ///< sum theta (x-p), sum theta n
    double support = 0;           ///< sum theta h

    void add(const surfel::Surfel& s, const Vec3d& x, double scale) {
        const Eigen::Vector3d q = Eigen::Vector3d(x.x, x.y, x.z) - eigenOf(s.position), n = eigenOf(s.normal);
        const double h = scale * static_cast<double>(s.support), distance = q.norm();
        if (distance >= h)
            return;
        const NaiveJet<O> theta = weight<O>(q, distance, h);
        one += theta;
        support += theta.v * h;
        height.add(theta, n.dot(q));
        for (int k = 0; k < 3; ++k) {
            offset[k].add(theta, q[k]);
            up[k].add(theta, n[k]);
        }
    }
    /// Puts back that x - p moves with x.
    void move() {
        for (int k = 0; k < 3; ++k) {
            offset[k].addTimesCoordinate(one, k);
            height.addTimesCoordinate(up[k], k);
        }
    }
};

/// f = (1-mu) m.sum theta (x-p) / (|m| w) + mu sum theta n.(x-p) / w with m = sum theta n.
template <int O>
NaiveEvaluation finished(Sums<O>& sums, const Vec3d& x, double mu) {
    NaiveEvaluation out;
    NaiveJet<O> square, along;
    sums.move();
    for (int k = 0; k < 3; ++k) {
        square += sums.up[k] * sums.up[k];
        along += sums.up[k] * sums.offset[k];
    }
    if (!(sums.one.v > 0) || !(square.v > 0))
        return out;
    const NaiveJet<O> perWeight = inverse(sums.one), perLength = inverseRoot(square);
    NaiveJet<O> f;
    f.add(along * perLength * perWeight, 1 - mu);
    f.add(sums.height * perWeight, mu);
    out.valid = true;
    out.value = f.v;
    out.unit = sums.support * perWeight.v;
    out.centroid = x - Vec3d{sums.offset[0].v, sums.offset[1].v, sums.offset[2].v} * perWeight.v;
    out.normal = Vec3d{sums.up[0].v, sums.up[1].v, sums.up[2].v} * perLength.v;
    if constexpr (O >= 1)
        out.gradient = vectorOf(f.g);
    if constexpr (O >= 2)
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                out.hessian.m[a][b] = f.h(a, b);
    return out;
}

} // namespace

NaiveSurface::NaiveSurface(const surface::Surface& surface)
    : m_cloud(std::make_unique<NaiveCloud>(surface.tree().surfels().items)),
      m_mu(static_cast<double>(surface.definition().mu())) {}
NaiveSurface::~NaiveSurface() = default;

bool NaiveSurface::speaks(const surface::Surface& surface) {
    const surface::SurfaceDefinition& d = surface.definition();
    return surface.effectiveFrame() == surface::Frame::Normals && surface.tree().layout()->oriented &&
           d.manifold == surface::Manifold::Surface && d.weight == surface::Weight::Wendland && !d.interpolating;
}

NaiveEvaluation NaiveSurface::evaluate(const Vec3d& x, Need need, double scale) const {
    const auto answer = [&]<int O>(Sums<O> sums) {
        m_cloud->forSupports(base::cast<float>(x), static_cast<float>(scale),
                             [&](const surfel::Surfel& s) { sums.add(s, x, scale); });
        return finished(sums, x, m_mu);
    };
    return need == Need::Value ? answer(Sums<0>()) : need == Need::Gradient ? answer(Sums<1>()) : answer(Sums<2>());
}

bool NaiveSurface::project(const Vec3d& x, Projector projector, double tolerance, Vec3d& foot) const {
    const bool orthogonal = projector == Projector::Orthogonal;
    foot = x;
    for (int i = 0; i < 30; ++i) {
        const NaiveEvaluation at = evaluate(foot, orthogonal ? Need::Gradient : Need::Value);
        if (!at.valid)
            return false;
        const Vec3d& n = orthogonal ? at.gradient : at.normal;
        const Vec3d from = projector == Projector::Basic ? foot : x;
        const Vec3d next = from - n * ((at.value + dot(n, from - foot)) / dot(n, n));
        const double moved = distance(next, foot);
        foot = next;
        if (moved <= tolerance * at.unit)
            return true;
    }
    return false;
}

} // namespace bench
