#include "core/surface/moments.h"
#include "core/surfel/surfel_block.h"

namespace surface {

using base::Vec3d;

/// Weight and its radial derivatives over powers of h (alg. 2.1): theta_,k = a q_k, theta_,kl = b q_k q_l - a delta_kl.
struct RadialWeight {
    double theta = 0, a = 0, b = 0;
};

static RadialWeight wendland(double distance, double h) {
    const double r = distance / h, t = 1 - r, h2 = h * h;
    if (!(t > 0))
        return {};
    const double t3 = t * t * t;
    return {t3 * t * (5 - 4 * t), 20 * t3 / h2, r < 1e-14 ? 0 : 60 * t * t / (r * h2 * h2)};
}

static RadialWeight gaussian(double distance, double h) {
    if (!(distance < h))
        return {};
    const double scale = h / gaussianReach, s2 = scale * scale;
    const double phi = std::exp(-distance * distance / s2);
    return {phi, 2 * phi / s2, 4 * phi / (s2 * s2)};
}

template <int O>
static Jet<double, O> jetOf(const RadialWeight& w, const Vec3d& q) {
    Jet<double, O> out;
    out.v = w.theta;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            out.d[k] = w.a * q[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                out.dd[sym(k, l)] = w.b * q[k] * q[l] - (k == l ? w.a : 0);
    return out;
}

template <int O>
static void add(const Jet<double, O>& theta, const Vec3d& q, const Vec3d& n, Outer outer, Moments<double, O>& out) {
    out.one += theta;
    for (int k = 0; k < 3; ++k) {
        out.q[k] += theta * q[k];
        out.n[k] += theta * n[k];
    }
    out.height += theta * dot(n, q);
    if (outer == Outer::None)
        return;
    const Vec3d& y = outer == Outer::Normals ? n : q;
    for (int k = 0; k < 3; ++k)
        for (int l = k; l < 3; ++l)
            out.outer[sym(k, l)] += theta * (y[k] * y[l]);
}

template <int O>
void sum(ClusterSpan clusters, const Vec3d& x, const SumOptions& options, Moments<double, O>& out) {
    constexpr int lanes = surfel::clusterSize;
    out = {};
    for (const float* c : clusters)
        for (int i = 0; i < lanes; ++i) {
            const double h = c[surfel::Support * lanes + i];
            const Vec3d q = Vec3d{c[i], c[lanes + i], c[2 * lanes + i]} - x;
            const double distance = length(q);
            if (!(distance < h))
                continue;
            Vec3d n{c[surfel::NormalX * lanes + i], c[surfel::NormalY * lanes + i], c[surfel::NormalZ * lanes + i]};
            const double facing = dot(n, options.reference);
            if (options.facing == Facing::Skip && facing <= facingLimit)
                continue;
            if (options.facing == Facing::Flip && facing < 0)
                n = -n;
            const RadialWeight w = options.weight == Weight::Gaussian ? gaussian(distance, h) : wendland(distance, h);
            if (!(w.theta > 0))
                continue;
            ++out.samples;
            out.unit += w.theta * (options.weight == Weight::Gaussian ? h / gaussianReach : h);
            add(jetOf<O>(w, q), q, n, options.outer, out);
        }
}

template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 0>&);
template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 1>&);
template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 2>&);

} // namespace surface
