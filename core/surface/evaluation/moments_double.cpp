#include "core/surface/evaluation/kernels/double_kernel.h"
#include "core/surface/evaluation/smooth_step.h"
#include "core/surfel/shape.h"

#include <bit>

namespace surface {

using base::Vec3d;

namespace {

/// A weight with its derivatives by u = r^2 / 2, r the distance over the support: phi, and alpha, beta, gamma of
/// surface/README 2.1. Those that r = 0 makes infinite are zero there, as are the products that they stand in.
struct Radial {
    double phi = 0, alpha = 0, beta = 0, gamma = 0;

    Radial& operator*=(double factor) {
        phi *= factor, alpha *= factor, beta *= factor, gamma *= factor;
        return *this;
    }
};

constexpr double atSample = 1e-14; ///< r below which 1/r is left out

Radial wendlandC2(double r) {
    const double t = 1 - r, inverse = r < atSample ? 0 : 1 / r;
    return {t * t * t * t * (4 * r + 1), -20 * t * t * t, 60 * t * t * inverse,
            -60 * t * (1 + r) * inverse * inverse * inverse};
}

Radial wendlandC4(double r) {
    const double t = 1 - r, inverse = r < atSample ? 0 : 1 / r, t3 = t * t * t, t4 = t3 * t;
    return {t3 * t3 * (35 * r * r + 18 * r + 3) / 3, -56.0 / 3 * t4 * t * (5 * r + 1), 560 * t4, -2240 * t3 * inverse};
}

Radial gaussian(double r) {
    constexpr double reach = gaussianReach, reachSq = reach * reach; // of exp(-s^2), s = r reach
    const double phi = std::exp(-r * r * reachSq);
    return {phi, -2 * phi * reachSq, 4 * phi * reachSq * reachSq, -8 * phi * reachSq * reachSq * reachSq};
}

/// w over max(r^2, least), by Leibniz' rule with v = 1 / (2u) where it moves (surface/README 2.10).
Radial interpolating(const Radial& w, double r) {
    const double square = r * r, least = leastInterpolation;
    const double v = 1 / std::max(square, least), moving = square > least ? v : 0;
    const double v1 = -2 * v * moving, v2 = -4 * v1 * moving, v3 = -6 * v2 * moving;
    return {w.phi * v, w.alpha * v + w.phi * v1, w.beta * v + 2 * w.alpha * v1 + w.phi * v2,
            w.gamma * v + 3 * w.beta * v1 + 3 * w.alpha * v2 + w.phi * v3};
}

Radial weightAt(double r, const SumOptions& options) {
    const Radial plain = options.weight == Weight::Wendland     ? wendlandC2(r)
                         : options.weight == Weight::WendlandC4 ? wendlandC4(r)
                                                                : gaussian(r);
    return options.interpolating ? interpolating(plain, r) : plain;
}

/// Times the factor of Facing::Part for a normal, with its derivatives as the axis moves.
template <int O>
void takePart(const Vec3d& n, const Axis& axis, Jet<double, O>& theta) {
    constexpr double slope = 0.5 / static_cast<double>(partingLimit);
    Jet<double, O> t;
    t.v = 0.5 + slope * dot(n, axis.at);
    if (t.v >= 1) // counts wholly
        return;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            t.d[k] = slope * dot(n, axis.slope[k]);
    if constexpr (O >= 2)
        for (int k = 0; k < 6; ++k)
            t.dd[k] = slope * dot(n, axis.bend[k]);
    static_assert(O <= 2);
    const SmoothStep<double> step(t.v);
    theta = theta * chain(t, step.v, step.d, step.dd, step.ddd);
}

/// theta with its derivatives by x (surface/README 2.1), M = (I + b b^T) / h^2 and G = M (x - p).
template <int O>
Jet<double, O> jetOf(const Radial& w, const Vec3d& q, const Vec3d& b, double h) {
    const double inverse = 1 / (h * h);
    const Vec3d g = -(q + b * dot(b, q)) * inverse;
    const auto m = [&](int k, int l) {
        return ((k == l ? 1 : 0) + b[static_cast<std::size_t>(k)] * b[static_cast<std::size_t>(l)]) * inverse;
    };
    Jet<double, O> out;
    out.v = w.phi;
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k)
            out.d[k] = w.alpha * g[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = k; l < 3; ++l)
                out.dd[sym(k, l)] = w.beta * g[k] * g[l] + w.alpha * m(k, l);
    if constexpr (O >= 3)
        forTriples([&](int j, int k, int l) {
            const double edges = m(j, k) * g[l] + m(j, l) * g[k] + m(k, l) * g[j];
            out.ddd[sym(j, k, l)] = w.beta * edges + w.gamma * g[j] * g[k] * g[l];
        });
    return out;
}

template <int O>
void add(const Jet<double, O>& theta, const Vec3d& q, const Vec3d& n, Outer outer, Moments<double, O>& out) {
    out.one += theta;
    for (int k = 0; k < 3; ++k) {
        out.q[k] += theta * q[k];
        out.n[k] += theta * n[k];
    }
    out.height += theta * dot(n, q);
    out.square += theta * lengthSq(q);
    if (outer == Outer::None)
        return;
    const Vec3d& y = outer == Outer::Normals ? n : q;
    for (int k = 0; k < 3; ++k)
        for (int l = k; l < 3; ++l)
            out.outer[sym(k, l)] += theta * (y[k] * y[l]);
}

/// The same for orders 1 and 2, some surfels at a time in lanes, with the same bits.
template <int O>
class Products {
  public:
    Products(Outer outer, Moments<double, O>& out) : m_outer(outer), m_out(out) {}

    void add(const Jet<double, O>& theta, const Vec3d& q, const Vec3d& n) {
        double* jet = m_factors.jet[m_count];
        jet[0] = theta.v;
        std::copy(theta.d.begin(), theta.d.end(), jet + 1);
        std::copy(theta.dd.begin(), theta.dd.end(), jet + 4);
        std::fill(jet + used, jet + width, 0.0);
        double* term = m_factors.term[m_count];
        const double values[] = {1, q.x, q.y, q.z, n.x, n.y, n.z, dot(n, q), lengthSq(q)};
        std::copy(std::begin(values), std::end(values), term);
        const Vec3d& y = m_outer == Outer::Normals ? n : q;
        if (m_outer != Outer::None)
            for (int k = 0; k < 3; ++k)
                for (int l = k; l < 3; ++l)
                    term[plainTerms + sym(k, l)] = y[k] * y[l];
        if (++m_count == DoubleFactors::atOnce)
            flush();
    }
    /// After the last.
    void finish() {
        flush();
        m_out.one = jetOf(0);
        for (int k = 0; k < 3; ++k)
            m_out.q[k] = jetOf(1 + k), m_out.n[k] = jetOf(4 + k);
        m_out.height = jetOf(7);
        m_out.square = jetOf(8);
        for (int k = 0; k < 6 && m_outer != Outer::None; ++k)
            m_out.outer[k] = jetOf(plainTerms + k);
    }

  private:
    static constexpr int plainTerms = 9;
    static constexpr std::size_t used = O == 1 ? 4 : 10, width = O == 1 ? 4 : DoubleFactors::width;
    void flush() {
        productKernel(m_factors, m_count, m_outer == Outer::None ? plainTerms : DoubleFactors::terms, width, m_sums);
        m_count = 0;
    }
    Jet<double, O> jetOf(int term) const {
        const double* from = m_sums[term];
        Jet<double, O> out;
        out.v = from[0];
        std::copy_n(from + 1, out.d.size(), out.d.begin());
        std::copy_n(from + 4, out.dd.size(), out.dd.begin());
        return out;
    }

    Outer m_outer;
    Moments<double, O>& m_out;
    std::size_t m_count = 0;
    DoubleFactors m_factors;
    alignas(64) double m_sums[DoubleFactors::terms][DoubleFactors::width] = {};
};

/// Of the other orders.
template <int O>
struct None {
    None(Outer, Moments<double, O>&) {}
};

} // namespace

template <int O>
void sum(ClusterSpan clusters, const Vec3d& x, const SumOptions& options, Moments<double, O>& out) {
    constexpr int lanes = surfel::clusterSize;
    const double scale = options.scale, sigma = options.sigma;
    out = {};
    constexpr bool together = O == 1 || O == 2;
    [[maybe_unused]] std::conditional_t<together, Products<O>, None<O>> products(options.outer, out);
    for (const float* c : clusters)
        for (unsigned left = options.shape > 0 ? (1u << lanes) - 1 : holdingKernel(c, x, scale); left != 0;
             left &= left - 1) {
            const int i = std::countr_zero(left);
            const double h = scale * static_cast<double>(c[surfel::Support * lanes + i]);
            const Vec3d q = Vec3d{c[i], c[lanes + i], c[2 * lanes + i]} - x;
            Vec3d b;
            if (options.shape > 0)
                for (std::size_t k = 0; k < 3; ++k)
                    b[k] = static_cast<double>(c[(options.shape + static_cast<int>(k)) * lanes + i]);
            const double along = dot(b, q), distance = std::sqrt(lengthSq(q) + along * along);
            if (!(distance < h))
                continue;
            Vec3d n{c[surfel::NormalX * lanes + i], c[surfel::NormalY * lanes + i], c[surfel::NormalZ * lanes + i]};
            const double facing = dot(n, options.reference);
            if (options.facing == Facing::Skip && facing <= static_cast<double>(facingLimit))
                continue;
            if (options.facing == Facing::Flip && facing < 0)
                n = -n;
            Radial w = weightAt(distance / h, options);
            if (options.facing == Facing::Refit)
                w *= std::exp(-lengthSq(n - options.reference) / (sigma * sigma));
            if (!(w.phi > 0))
                continue;
            if (options.facing == Facing::Part && dot(n, options.axis->at) <= -static_cast<double>(partingLimit))
                continue;
            ++out.samples;
            Jet<double, O> theta = jetOf<O>(w, q, b, h);
            if constexpr (O <= 2)
                if (options.facing == Facing::Part)
                    takePart(n, *options.axis, theta);
            const double mean = options.shape > 0 ? h / std::sqrt(std::sqrt(1 + lengthSq(b))) : h;
            const double unit = options.weight == Weight::Gaussian ? mean / static_cast<double>(gaussianReach) : mean;
            out.unit += theta.v * unit;
            if constexpr (O >= 1)
                out.unitSlope += Vec3d{theta.d[0], theta.d[1], theta.d[2]} * unit;
            if constexpr (together)
                products.add(theta, q, n);
            else
                add(theta, q, n, options.outer, out);
        }
    if constexpr (together)
        products.finish();
}

template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 0>&);
template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 1>&);
template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 2>&);
template void sum(ClusterSpan, const Vec3d&, const SumOptions&, Moments<double, 3>&);

} // namespace surface
