#include "core/surface/evaluation/summed_normals.h"

#include "core/surface/evaluation/near_sheets.h"
#include "core/surface/frames/frame_normal.h"
#include "core/surfel/shape.h"

namespace surface {

using base::Vec3f;

SummedNormals::SummedNormals(const Surface& surface) : m_surface(&surface) {
    const SurfaceDefinition& definition = surface.definition();
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    m_applies = surface.effectiveFrame() == Frame::Normals && layout.normals && layout.oriented &&
                definition.manifold == Manifold::Surface && !definition.interpolating;
    SumOptions options;
    options.weight = definition.weight;
    options.scale = surface.supportScale();
    options.shape = surfel::shapeChannel(layout);
    m_sums = kernelInput({}, {}, options);
    m_mu = definition.mu();
    m_limit = definition.boundaryLimit;
}

KernelInput SummedNormals::input(ClusterSpan clusters, const Vec3f& x) const {
    KernelInput out = m_sums;
    out.clusters = clusters.data();
    out.clusterCount = clusters.size();
    out.x[0] = x.x, out.x[1] = x.y, out.x[2] = x.z;
    return out;
}

struct SummedNormals::Sums {
    int samples;
    float weight, unit, square;
    Vec3f q, normals;
};

/// What all orders have in common.
bool SummedNormals::begin(const Sums& sums, const Vec3f& x, Evaluationf& out) const {
    const float w = sums.weight;
    if (!(w > leastWeight<float>) || sums.samples < leastSamples)
        return false;
    const float inverseWeight = 1.0f / w;
    const float agreement = length(sums.normals) / w, unit = sums.unit / w;
    const Vec3f e = sums.q * inverseWeight;
    const float square = sums.square * inverseWeight, apart = lengthSq(e), spread = square - apart;
    // a little more than the assembler asks for, which decides where it is close
    constexpr float clearly = 1.001f;
    if (!(agreement >= clearly * static_cast<float>(oneSheetBelow)) ||
        !(spread > clearly * static_cast<float>(leastSpread) * std::max(unit * unit, square)))
        return false;
    out.samples = sums.samples;
    out.weight = w;
    out.centroid = x + e;
    out.offCentre = std::sqrt(apart);
    out.unit = unit;
    out.agreement = agreement;
    const bool beyond = std::isfinite(m_limit) && out.offCentre > m_limit * unit;
    out.status = settled(beyond ? Status::BeyondBoundary : Status::Ok, x);
    out.cause = Cause::None;
    return true;
}

bool SummedNormals::values(ClusterSpan clusters, const Vec3f& x, Evaluationf& out) const {
    alignas(64) float s[maxSums];
    const int samples = sumKernel(0, Outer::None, input(clusters, x), s);
    const Vec3f q{s[QTerm], s[QTerm + 1], s[QTerm + 2]}, m{s[NTerm], s[NTerm + 1], s[NTerm + 2]};
    const float w = s[OneTerm];
    if (!begin({samples, w, unitOf(m_sums.weight, s[monomialCount(Outer::None)]), s[SquareTerm], q, m}, x, out))
        return false;
    const float inverseWeight = 1.0f / w;
    out.normal = m * std::sqrt(1.0f / lengthSq(m));
    out.value = -dot(out.normal, q * inverseWeight) * (1.0f - m_mu);
    if (m_mu > 0)
        out.value -= s[HeightTerm] * inverseWeight * m_mu;
    out.gradient = {};
    out.hessian = out.normalGradient = {};
    return true;
}

/// A jet of order 1 in four lanes: value, derivatives. As the kernel leaves its sums.
struct alignas(16) JetLanes {
    Four lanes;

    static JetLanes of(const float* sums) { return {Four{sums[0], sums[1], sums[2], sums[3]}}; }
    float value() const { return lanes[0]; }
    Vec3f derivative() const { return {lanes[1], lanes[2], lanes[3]}; }
    JetLanes withValue(float v) const { return {Four{v, lanes[1], lanes[2], lanes[3]}}; }
};
static JetLanes operator+(const JetLanes& a, const JetLanes& b) {
    return {a.lanes + b.lanes};
}
static JetLanes operator-(const JetLanes& a, const JetLanes& b) {
    return {a.lanes - b.lanes};
}
static JetLanes operator*(const JetLanes& a, float s) {
    return {a.lanes * s};
}
static JetLanes operator*(const JetLanes& a, const JetLanes& b) {
    return a.withValue(0) * b.value() + b * a.value();
}
static JetLanes inverse(const JetLanes& a) {
    const float i = 1.0f / a.value();
    return (a * (-i * i)).withValue(i);
}
static JetLanes inverseSqrt(const JetLanes& a) {
    const float i = 1.0f / a.value(), s = std::sqrt(i);
    return (a * (-0.5f * s * i)).withValue(s);
}

bool SummedNormals::gradients(ClusterSpan clusters, const Vec3f& x, Evaluationf& out) const {
    alignas(64) float s[maxSums];
    const int samples = sumKernel(1, Outer::None, input(clusters, x), s);
    constexpr int width = factorCount(1);
    const auto at = [&](int monomial) { return s[monomial * width]; };
    const Vec3f values{at(QTerm), at(QTerm + 1), at(QTerm + 2)}, normals{at(NTerm), at(NTerm + 1), at(NTerm + 2)};
    const float unit = unitOf(m_sums.weight, at(monomialCount(Outer::None)));
    if (!begin({samples, at(OneTerm), unit, at(SquareTerm), values, normals}, x, out))
        return false;

    const auto jet = [&](int monomial) { return JetLanes::of(s + monomial * width); };
    const JetLanes m[3] = {jet(NTerm), jet(NTerm + 1), jet(NTerm + 2)};
    const JetLanes inverseWeight = inverse(jet(OneTerm));
    const JetLanes scale = inverseSqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    JetLanes f{};
    for (int a = 0; a < 3; ++a) {
        JetLanes moving{}; // x itself
        moving.lanes[a + 1] = 1;
        const JetLanes d = moving - jet(QTerm + a) * inverseWeight, n = m[a] * scale;
        f = f + n * d;
        const std::size_t row = static_cast<std::size_t>(a);
        out.normal[row] = n.value();
        const Vec3f slope = n.derivative();
        for (std::size_t k = 0; k < 3; ++k)
            out.normalGradient.m[row][k] = slope[k];
    }
    f = f * (1.0f - m_mu);
    if (m_mu > 0) { // sum theta n_i.(x - p_i), x moving
        const JetLanes moving{Four{0, normals.x, normals.y, normals.z}};
        f = f + (moving - jet(HeightTerm)) * inverseWeight * m_mu;
    }
    out.value = f.value();
    out.gradient = f.derivative();
    out.hessian = {};
    return true;
}

bool SummedNormals::hessians(ClusterSpan clusters, const Vec3f& x, Evaluationf& out) const {
    Moments<float, 2> m;
    sum(input(clusters, x), Outer::None, m);
    if (!begin({m.samples, m.one.v, m.unit, m.square.v, valueOf(m.q), valueOf(m.n)}, x, out))
        return false;
    const Jet<float, 2> inverseWeight = inverse(m.one);
    const JetVec<float, 2> n = normalisedSum(m.n).n;
    JetVec<float, 2> d = m.q * inverseWeight * -1.0f; // x - c
    for (std::size_t a = 0; a < 3; ++a)
        d[a].d[a] += 1.0f;
    Jet<float, 2> f = dot(n, d) * (1.0f - m_mu);
    if (m_mu > 0)
        f += movingHeight(m) * inverseWeight * m_mu;
    out.value = f.v;
    out.gradient = {f.d[0], f.d[1], f.d[2]};
    out.hessian = detail::matrixOf(f.dd.data());
    out.normal = valueOf(n);
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t k = 0; k < 3; ++k)
            out.normalGradient.m[a][k] = n[a].d[k];
    return true;
}

bool SummedNormals::evaluate(ClusterSpan clusters, const Vec3f& x, Need need, Evaluationf& out) const {
    switch (need) {
    case Need::Value:
        return values(clusters, x, out);
    case Need::Gradient:
        return gradients(clusters, x, out);
    case Need::Hessian:
        break;
    }
    return hessians(clusters, x, out);
}

} // namespace surface
