// Second stage of an evaluation: from the sums over surfels to n, f, g, Hessian and status. Shared by both precisions;
// `O` is the order of derivatives wanted.
//
//     sums at x -> near sheets? sums once more without those that face away (sheets.h)
//               -> c, d = x - c -> tests of alg. 2.4, each failure with its cause
//               -> n by the frame (sums at c for covariance-at-centroid, of one order more for centroid-gradient)
//               -> its sign
//               -> unoriented? sums once more with the surfels' normals on n's side
//               -> f = (1-mu) n.d + mu sum theta n_i.(x - p_i) / w
// apss has its own f by the same sums, rimls by sums with refitted weights; mu has no part in them.
#pragma once

#include "core/surface/evaluation/fields.h"
#include "core/surface/evaluation/poverty.h"
#include "core/surface/evaluation/sheets.h"
#include "core/surface/evaluation/source.h"

#include <cassert>

namespace surface {

constexpr double leastAgreement = 0.2; ///< |m|/w below which summed normals cancel (test 2)
constexpr int refitPasses = 3;         ///< of rimls, the first without factors (alg. 10.4)
constexpr double refitStill = 1e-3;    ///< |g - g_before|^2 that ends them
/// Interpolating weights: this close to a surfel, in h, the answer is the surfel itself; its Hessian is taken a little
/// above it, where formulas hold.
constexpr double atSurfel = 1e-12, besideSurfel = 1e-5;

template <class T, int O>
class Assembler {
  public:
    Assembler(const Source& source, ClusterSpan clusters, const base::Vec3<T>& x, const Hint& hint)
        : m_source(source), m_surface(source.surface()), m_clusters(clusters), m_x(x),
          m_side(base::normalized(base::cast<double>(hint.direction))), m_frame(m_surface.effectiveFrame()),
          m_normals(m_surface.tree().layout()->normals), m_oriented(m_normals && m_surface.tree().layout()->oriented) {
        m_options.weight = m_surface.definition().weight;
        m_options.interpolating = m_surface.definition().interpolating;
        m_options.scale = m_surface.supportScale();
        m_options.outer = m_frame == Frame::Hyperplanes  ? Outer::Normals
                          : m_frame == Frame::Covariance ? Outer::Offsets
                                                         : Outer::None;
    }

    Evaluation<T> run() {
        sum(m_clusters, m_x, m_options, m_moments);
        if (!(m_moments.one.v > leastWeight<T>))
            return failed(Status::Outside, Cause::NoSupport);
        tellSheetsApart();
        centre();
        if (const Cause cause = poverty(m_moments, m_clusters, m_x); cause != Cause::None)
            return failed(Status::Degenerate, cause);
        if (m_options.interpolating && m_normals && atSomeSurfel())
            return m_out;
        const Field<T, O> found = field();
        if (found.cause != Cause::None)
            return failed(Status::Degenerate, found.cause);
        store(found);
        return m_out;
    }

    /// dc_a/dx_b at x, by the surfels that the answer kept to. REQUIRES: run() was called and f has a value.
    base::Mat3<T> centroidGradient() const {
        static_assert(O >= 1);
        base::Mat3<T> out;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t k = 0; k < 3; ++k)
                out.m[a][k] = m_centroid[a].d[k];
        return out;
    }
    /// grad h at x, likewise. REQUIRES: T is double.
    base::Vec3<T> unitGradient() const {
        static_assert(O >= 1 && std::is_same_v<T, double>);
        const auto& w = m_moments.one;
        return (m_moments.unitSlope - base::Vec3<T>{w.d[0], w.d[1], w.d[2]} * m_out.unit) / w.v;
    }

  private:
    using Vector = base::Vec3<T>;

    static T agreementOf(const Moments<T, O>& m) { return length(valueOf(m.n)) / m.one.v; }

    /// What was counted stays, so that a failure can be explained; what would be used as an answer is no number.
    Evaluation<T> failed(Status status, Cause cause) {
        constexpr T nan = std::numeric_limits<T>::quiet_NaN();
        constexpr Vector none{nan, nan, nan};
        m_out.status = status;
        m_out.cause = cause;
        m_out.value = m_out.offCentre = nan;
        m_out.centroid = m_out.normal = m_out.gradient = none;
        m_out.hessian = m_out.normalGradient = {{{nan, nan, nan}, {nan, nan, nan}, {nan, nan, nan}}};
        return m_out;
    }

    void tellSheetsApart() {
        m_out.agreement = m_normals ? agreementOf(m_moments) : T(1);
        if (!m_oriented || !m_surface.definition().oneSheet || m_out.agreement >= T(oneSheetBelow))
            return;
        m_towards = lengthSq(m_side) > 0 ? m_side
                                         : nearestNormal(m_clusters, base::cast<double>(m_x), m_surface.supportScale());
        SumOptions options = m_options;
        options.facing = Facing::Skip;
        options.reference = m_towards;
        Moments<T, O> kept;
        sum(m_clusters, m_x, options, kept);
        if (!(kept.one.v > leastWeight<T>))
            return;
        m_twoSheets = true;
        m_share = shareOfFacingAway(m_out.agreement);
        m_moments = mixed(m_moments, kept, m_share);
        m_out.agreement = agreementOf(m_moments);
    }

    /// Sums over the sheet that was chosen at x, whatever else is asked for.
    template <int P>
    void sumSheet(ClusterSpan clusters, const Vector& x, SumOptions options, Moments<T, P>& out) const {
        sum(clusters, x, options, out);
        if (!m_twoSheets)
            return;
        options.facing = Facing::Skip;
        options.reference = m_towards;
        Moments<T, P> kept;
        sum(clusters, x, options, kept);
        out = mixed(out, kept, m_share);
    }

    /// c = sum theta p / w, d = x - c, o = |d|, h.
    void centre() {
        m_inverseWeight = inverse(m_moments.one);
        const JetVec<T, O> offset = m_moments.q * m_inverseWeight;
        const Vector e = valueOf(offset);
        m_out.samples = m_moments.samples;
        m_out.weight = m_moments.one.v;
        m_out.centroid = m_x + e;
        m_out.offCentre = length(e);
        m_out.unit = m_moments.unit / m_moments.one.v;
        m_centroid = offset;
        for (std::size_t a = 0; a < 3; ++a) {
            m_d[a] = -offset[a];
            if constexpr (O >= 1)
                m_d[a].d[a] += T(1);
        }
    }

    /// Test 1 of alg. 2.4 and whether the samples are all at one place. Interpolating weights bring every sum to one
    /// place as x comes to a sample; there the question is put with plain ones.
    Cause poverty(const Moments<T, O>& m, ClusterSpan clusters, const Vector& x) const {
        if (!m_options.interpolating)
            return povertyOf(m);
        SumOptions options = m_options;
        options.interpolating = false;
        options.outer = Outer::None;
        Moments<T, 0> plain;
        sum(clusters, x, options, plain);
        return povertyOf(plain);
    }

    Field<T, O> field() {
        const SurfaceDefinition& definition = m_surface.definition();
        const bool sums = m_frame == Frame::Normals || m_frame == Frame::Apss || m_frame == Frame::Rimls;
        if (sums && !(m_out.agreement >= T(leastAgreement)))
            return {{}, {}, Cause::CancellingNormals};
        if (m_frame == Frame::Apss)
            return sphereField(m_moments, static_cast<T>(definition.apssBeta));
        if (m_frame == Frame::Rimls)
            return refitted();
        FrameNormal<T, O> frame = frameNormal();
        if (!frame.valid)
            return {{}, {}, frame.cause};
        orient(frame.n);
        if (m_normals && !m_oriented)
            alignNormals(frame.n);
        return planeField(frame.n);
    }

    FrameNormal<T, O> frameNormal() {
        switch (m_frame) {
        case Frame::Hyperplanes:
            return eigenvector(m_moments.outer, Pick::Largest);
        case Frame::Covariance:
            return normalHere();
        case Frame::CovarianceAtCentroid:
            return normalAtCentroid();
        case Frame::CentroidGradient:
            return normalOfCentroidGradient();
        case Frame::Normals:
        case Frame::Apss:
        case Frame::Rimls:
            break;
        }
        return normalisedSum(m_moments.n);
    }

    /// The covariance frame about x. Seen from beside a line of points, x and the line span a plane that is nothing but
    /// an accident: whether they are on a line is asked about their centroid (alg. 2.4).
    FrameNormal<T, O> normalHere() {
        const Vector e = valueOf(m_moments.q) / m_moments.one.v;
        T about[6];
        for (int a = 0; a < 3; ++a)
            for (int b = a; b < 3; ++b)
                about[sym(a, b)] = m_moments.outer[sym(a, b)].v -
                                   m_moments.one.v * e[static_cast<std::size_t>(a)] * e[static_cast<std::size_t>(b)];
        const base::SymmetricEigen<T> eigen = base::symmetricEigen(detail::matrixOf(about));
        FrameNormal<T, O> out;
        if (!(eigen.value[1] >= T(1e-2) * eigen.value[2])) {
            out.cause = Cause::Collinear;
            return out;
        }
        Jet<T, O> s[6];
        movingOuter(m_moments, s);
        out = eigenvector(s, Pick::Smallest);
        if (out.cause == Cause::Collinear)
            out.cause = Cause::ClosedGap;
        return out;
    }

    /// The covariance frame evaluated at y = c(x) (alg. 7, cov_c): N(y) composed with c(x).
    FrameNormal<T, O> normalAtCentroid() {
        SumOptions options = m_options;
        options.outer = Outer::Offsets;
        Moments<T, O> there;
        ScratchClusters clusters;
        m_source.gather(m_out.centroid, clusters.list());
        sumSheet(clusters.span(), m_out.centroid, options, there);
        FrameNormal<T, O> out;
        out.cause = poverty(there, clusters.span(), m_out.centroid);
        if (out.cause != Cause::None)
            return out;
        Jet<T, O> s[6];
        movingOuter(there, s);
        out = eigenvector(s, Pick::Smallest);
        if (out.valid)
            for (Jet<T, O>& each : out.n)
                each = compose(each, m_centroid);
        return out;
    }

    /// Left singular vector of grad c (alg. 2.2). Third derivatives of weights are summed in double alone: whoever
    /// wants this frame's Hessian asks the reference (source.cpp).
    FrameNormal<T, O> normalOfCentroidGradient() const {
        if constexpr (O < 2 || std::is_same_v<T, double>) {
            Moments<T, O + 1> wide;
            sumSheet(m_clusters, m_x, m_options, wide);
            Jet<T, O> s[6];
            centroidGradientSquare(wide, s);
            return eigenvector(s, Pick::Smallest, Eigenvalues::Squares);
        } else {
            assert(!"the Hessian of centroid-gradient is the reference's");
            return {};
        }
    }

    /// Signs of alg. 2.4: by the surfels' normals where they are oriented, else by the hint, else as it came.
    void orient(JetVec<T, O>& n) const {
        const Vector reference = m_oriented ? valueOf(m_moments.n) : base::cast<T>(m_side);
        if (dot(valueOf(n), reference) < T(0))
            n = n * T(-1);
    }

    void alignNormals(const JetVec<T, O>& n) {
        SumOptions options = m_options;
        options.outer = Outer::None;
        options.facing = Facing::Flip;
        options.reference = base::cast<double>(valueOf(n));
        Moments<T, O> aligned;
        sum(m_clusters, m_x, options, aligned);
        m_moments.n = aligned.n;
        m_moments.height = aligned.height;
        m_out.agreement = agreementOf(m_moments);
    }

    Field<T, O> planeField(const JetVec<T, O>& n) const {
        const T mu = m_normals ? static_cast<T>(m_surface.definition().mu()) : T(0);
        Field<T, O> out{dot(n, m_d) * (T(1) - mu), n, Cause::None};
        if (mu > T(0))
            out.f += movingHeight(m_moments) * m_inverseWeight * mu;
        return out;
    }

    /// Robust implicit moving least squares (alg. 10.4, after Oeztireli, Guennebaud & Gross 2009):
    /// f = sum w_i n_i.(x - p_i) / sum w_i with w_i = theta_i b_i, b_i = 1 in the first pass and then
    /// exp(-|n_i - g|^2 / sigma^2) by the gradient g of the pass before. Gradient and Hessian are the exact derivatives
    /// of the last pass's f with its b_i held constant; n is the sum of w_i n_i, normalised.
    Field<T, O> refitted() const {
        constexpr int P = O < 1 ? 1 : O; // g leads from pass to pass, whatever is asked for
        SumOptions options = m_options;
        options.sigma = m_surface.definition().rimlsSigma;
        Moments<T, P> m;
        Jet<T, P> f;
        Vector g;
        for (int pass = 0; pass < refitPasses; ++pass) {
            if (pass == 0)
                sumSheet(m_clusters, m_x, options, m);
            else
                sum(m_clusters, m_x, options, m);
            if (!(m.one.v > leastWeight<T>))
                return {{}, {}, Cause::CancellingNormals};
            f = movingHeight(m) * inverse(m.one);
            const Vector now{f.d[0], f.d[1], f.d[2]};
            if (!(lengthSq(now - g) > T(refitStill)))
                break;
            g = now;
            options.facing = Facing::Refit;
            options.reference = base::cast<double>(g);
        }
        JetVec<T, O> sum;
        for (std::size_t a = 0; a < 3; ++a)
            sum[a] = truncated<O>(m.n[a]);
        const FrameNormal<T, O> n = normalisedSum(sum);
        return {truncated<O>(f), n.n, n.valid ? Cause::None : n.cause};
    }

    /// Where weights interpolate, a surfel at x is the answer itself: f = 0, c = p_i, n = g = n_i (alg. 10.5).
    bool atSomeSurfel() {
        constexpr int lanes = surfel::clusterSize;
        for (const float* c : m_clusters)
            for (int i = 0; i < lanes; ++i) {
                const base::Vec3d p{c[i], c[lanes + i], c[2 * lanes + i]};
                const base::Vec3d n{c[surfel::NormalX * lanes + i], c[surfel::NormalY * lanes + i],
                                    c[surfel::NormalZ * lanes + i]};
                const double h = static_cast<double>(c[surfel::Support * lanes + i] * m_options.scale);
                if (lengthSq(n) > 0 && distance(p, base::cast<double>(m_x)) < atSurfel * h) {
                    takeSurfel(base::cast<T>(p), base::normalized(base::cast<T>(n)), static_cast<T>(h));
                    return true;
                }
            }
        return false;
    }

    void takeSurfel(const Vector& p, Vector n, T h) {
        if (!m_oriented && dot(base::cast<double>(n), m_side) < 0)
            n = -n;
        Field<T, O> out;
        for (std::size_t a = 0; a < 3; ++a)
            out.n[a].v = n[a];
        if constexpr (O >= 1)
            out.f.d = {n.x, n.y, n.z};
        m_out.centroid = p;
        m_out.offCentre = length(m_x - p);
        store(out);
        if constexpr (O >= 2) {
            const Vector beside = m_x + n * (static_cast<T>(besideSurfel) * h);
            ScratchClusters clusters;
            m_source.gather(beside, clusters.list());
            const Evaluation<T> near = Assembler(m_source, clusters.span(), beside, {base::cast<float>(n)}).run();
            if (near.cause != Cause::None)
                failed(Status::Degenerate, near.cause);
            else
                m_out.hessian = near.hessian;
        }
    }

    void store(const Field<T, O>& field) {
        m_out.value = field.f.v;
        m_out.normal = valueOf(field.n);
        if constexpr (O >= 1) {
            m_out.gradient = {field.f.d[0], field.f.d[1], field.f.d[2]};
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t k = 0; k < 3; ++k)
                    m_out.normalGradient.m[a][k] = field.n[a].d[k];
        }
        if constexpr (O >= 2)
            m_out.hessian = detail::matrixOf(field.f.dd.data());
        const float limit = m_surface.definition().boundaryLimit;
        const bool beyond = std::isfinite(limit) && m_out.offCentre > static_cast<T>(limit) * m_out.unit;
        m_out.status = beyond ? Status::BeyondBoundary : Status::Ok;
        m_out.cause = Cause::None;
    }

    const Source& m_source;
    const Surface& m_surface;
    ClusterSpan m_clusters;
    Vector m_x;
    base::Vec3d m_side; ///< the hint's direction, unit, or zero for none
    Frame m_frame;
    bool m_normals, m_oriented;
    SumOptions m_options;
    bool m_twoSheets = false;
    base::Vec3d m_towards; ///< where the sheet that is kept faces, if there are two
    T m_share = 1;         ///< part of what faces away that counts then
    Moments<T, O> m_moments;
    Jet<T, O> m_inverseWeight;
    JetVec<T, O> m_d{}, m_centroid{}; ///< x - c, and c relative to where x is
    Evaluation<T> m_out;
};

} // namespace surface
