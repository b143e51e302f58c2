#include "core/surface/curves/curve.h"

#include "core/surface/evaluation/clusters.h"
#include "core/surface/evaluation/moving_sums.h"
#include "core/surface/frames/frame_normal.h"
#include "core/surfel/shape.h"

namespace surface {

using base::Mat3d;
using base::Vec3d;

namespace {

/// The definition's frame as it reads on curves.
Frame effectiveCurveFrame(const Surface& curve) {
    const FrameRow& row = rowOf(curve.definition().frame);
    const bool tangents = row.reads == NormalsRead::Unoriented && curve.tree().layout()->normals;
    return row.onCurves || tangents ? row.frame : Frame::CovarianceAtCentroid;
}

constexpr double leastCurveWeight = 1e-12;
constexpr int leastCurveSamples = 2; ///< surface/README 7.1

/// F as jets at one position: sums, centroid, direction, and what is left of x - c across the direction.
template <int O>
class CurveAssembler {
    using J = Jet<double, O>;
    using JV = JetVec<double, O>;

  public:
    CurveAssembler(const Surface& curve, const Vec3d& x) : m_curve(curve), m_x(x), m_frame(effectiveCurveFrame(curve)) {
        m_options.weight = curve.definition().weight;
        m_options.interpolating = curve.definition().interpolating;
        m_options.scale = curve.supportScale();
        m_options.shape = surfel::shapeChannel(*curve.tree().layout());
        m_options.outer = m_frame == Frame::Hyperplanes ? Outer::Normals : Outer::Offsets;
    }

    CurveEvaluation run() {
        const ScratchClusters clusters(m_curve.tree(), m_x);
        sum(clusters.span(), m_x, m_options, m_moments);
        if (!(m_moments.one.v > leastCurveWeight))
            return m_out;
        centre();
        const FrameNormal<double, O> frame = direction();
        if (!frame.valid)
            return m_out;
        finish(frame.n);
        return m_out;
    }

  private:
    void centre() {
        const J inverseWeight = inverse(m_moments.one);
        m_centroid = m_moments.q * inverseWeight;
        m_out.samples = m_moments.samples;
        m_out.weight = m_moments.one.v;
        m_out.unit = m_moments.unit / m_moments.one.v;
        m_out.centroid = m_x + valueOf(m_centroid);
        m_out.offCentre = length(valueOf(m_centroid));
        for (std::size_t a = 0; a < 3; ++a) {
            m_d[a] = -m_centroid[a];
            if constexpr (O >= 1)
                m_d[a].d[a] += 1;
        }
    }

    /// Names the degenerate case and leaves, or the frame's direction (surface/README 2.5).
    FrameNormal<double, O> direction() {
        m_out.status = Status::Degenerate;
        if (m_out.samples < leastCurveSamples) {
            m_out.cause = Cause::OnePoint;
            return {};
        }
        const double spread = m_moments.square.v / m_out.weight - lengthSq(valueOf(m_centroid));
        if (!(spread > 1e-12 * m_out.unit * m_out.unit)) {
            m_out.cause = Cause::Coincident;
            return {};
        }
        const FrameNormal<double, O> out = dominant();
        m_out.cause = out.cause;
        return out;
    }

    FrameNormal<double, O> dominant() const {
        if (m_frame == Frame::Hyperplanes)
            return eigenvector(m_moments.outer, Pick::Largest);
        if (m_frame == Frame::CentroidGradient) {
            Moments<double, O + 1> wide;
            const ScratchClusters clusters(m_curve.tree(), m_x);
            sum(clusters.span(), m_x, m_options, wide);
            J s[6];
            centroidGradientSquare(wide, s);
            return eigenvector(s, Pick::Largest, Eigenvalues::Squares);
        }
        if (m_frame != Frame::CovarianceAtCentroid)
            return covariance(m_moments);
        SumOptions options = m_options;
        Moments<double, O> there;
        const ScratchClusters clusters(m_curve.tree(), m_out.centroid);
        sum(clusters.span(), m_out.centroid, options, there);
        if (!(there.one.v > leastCurveWeight) || there.samples < leastCurveSamples)
            return {{}, false, Cause::NoSupport};
        FrameNormal<double, O> out = covariance(there);
        for (J& each : out.n)
            each = compose(each, m_centroid);
        return out;
    }

    static FrameNormal<double, O> covariance(const Moments<double, O>& m) {
        J s[6];
        movingOuter(m, s);
        return eigenvector(s, Pick::Largest);
    }

    void finish(const JV& t) {
        const JV along = t * dot(t, m_d);
        JV f;
        for (std::size_t a = 0; a < 3; ++a)
            f[a] = m_d[a] - along[a];
        m_out.direction = valueOf(t);
        m_out.value = valueOf(f);
        if constexpr (O >= 1)
            differentiate(f);
        const float limit = m_curve.definition().boundaryLimit;
        const bool beyond = std::isfinite(limit) && m_out.offCentre > static_cast<double>(limit) * m_out.unit;
        m_out.status = beyond ? Status::BeyondBoundary : Status::Ok;
    }

    /// DF = N^T F' with N spanning the plane across t; the curve runs along its kernel. On the curve F and its
    /// derivative along the tangent are zero, so that N may be held still under the second derivative.
    void differentiate(const JV& f) {
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t k = 0; k < 3; ++k)
                m_out.gradient.m[a][k] = f[a].d[k];
        const Vec3d u = base::perpendicular(m_out.direction), v = cross(m_out.direction, u);
        const Mat3d down = transposed(m_out.gradient);
        const Vec3d rowU = down * u, rowV = down * v;
        m_out.tangent = base::normalized(cross(rowU, rowV), m_out.direction);
        if (dot(m_out.tangent, m_out.direction) < 0)
            m_out.tangent = -m_out.tangent;
        if constexpr (O >= 2) {
            Vec3d bend; // t^T D^2F t
            for (std::size_t a = 0; a < 3; ++a)
                bend[a] = dot(m_out.tangent, detail::matrixOf(f[a].dd.data()) * m_out.tangent);
            const double uu = lengthSq(rowU), uv = dot(rowU, rowV), vv = lengthSq(rowV), det = uu * vv - uv * uv;
            const double bu = dot(u, bend), bv = dot(v, bend);
            m_out.curvature = (rowU * (vv * bu - uv * bv) + rowV * (uu * bv - uv * bu)) * (-1 / det);
        }
    }

    const Surface& m_curve;
    Vec3d m_x;
    Frame m_frame;
    SumOptions m_options;
    Moments<double, O> m_moments;
    JV m_d{}, m_centroid{};
    CurveEvaluation m_out;
};

} // namespace

CurveEvaluation evaluateCurve(const Surface& curve, const Vec3d& x, Need need) {
    switch (need) {
    case Need::Value:
        return CurveAssembler<0>(curve, x).run();
    case Need::Gradient:
        return CurveAssembler<1>(curve, x).run();
    case Need::Hessian:
        break;
    }
    return CurveAssembler<2>(curve, x).run();
}

} // namespace surface
