// Second stage of an evaluation: from the sums over surfels to n, f, g, Hessian and status. Shared by both precisions;
// `O` is the order of derivatives wanted.
//
//     sums at x -> near sheets? sums once more without those that face away
//               -> c, d = x - c -> n by the frame (covariance-at-centroid: sums at c) -> sign
//               -> unoriented? sums once more with the surfels' normals on n's side
//               -> f = (1-mu) n.d + mu sum theta n_i.(x - p_i) / w
#pragma once

#include "core/surface/frame_normal.h"
#include "core/surface/moments.h"
#include "core/surface/source.h"

namespace surface {

/// Below this sum of weights a position counts as outside (theta underflows near r = 1; alg. 2.1).
template <class T>
constexpr T leastWeight = std::is_same_v<T, float> ? T(1e-6) : T(1e-12);
constexpr int leastSamples = 3;        ///< surfels in support that a frame needs (alg. 2.4, test 1)
constexpr double leastAgreement = 0.2; ///< |m|/w below which summed normals cancel (test 2)
constexpr double oneSheetBelow = 0.7;  ///< |m|/w below which sheets are told apart (RESAMPLING 4)

template <class T, int O>
class Assembler {
  public:
    Assembler(const Source& source, ClusterSpan clusters, const base::Vec3<T>& x, const Hint& hint)
        : m_source(source), m_surface(source.surface()), m_clusters(clusters), m_x(x),
          m_hint(base::normalized(base::cast<double>(hint.direction))), m_frame(m_surface.effectiveFrame()),
          m_normals(m_surface.tree().layout()->normals), m_oriented(m_normals && m_surface.tree().layout()->oriented) {
        m_options.weight = m_surface.definition().weight;
        m_options.outer = m_frame == Frame::Hyperplanes  ? Outer::Normals
                          : m_frame == Frame::Covariance ? Outer::Offsets
                                                         : Outer::None;
    }

    Evaluation<T> run() {
        sum(m_clusters, m_x, m_options, m_moments);
        if (!(m_moments.one.v > leastWeight<T>))
            return m_out;
        tellSheetsApart();
        centre();
        m_out.status = Status::Degenerate;
        if (m_out.samples < leastSamples)
            return m_out;
        FrameNormal<T, O> frame = frameNormal();
        if (!frame.valid)
            return m_out;
        orient(frame.n);
        if (m_normals && !m_oriented)
            alignNormals(frame.n);
        finish(frame.n);
        return m_out;
    }

  private:
    T agreementOf(const Moments<T, O>& m) const { return length(valueOf(m.n)) / m.one.v; }

    void tellSheetsApart() {
        m_out.agreement = m_normals ? agreementOf(m_moments) : T(1);
        if (!m_oriented || !m_surface.definition().oneSheet || m_out.agreement >= T(oneSheetBelow))
            return;
        SumOptions options = m_options;
        options.facing = Facing::Skip;
        options.reference = lengthSq(m_hint) > 0 ? m_hint : nearestNormal(m_clusters, base::cast<double>(m_x));
        Moments<T, O> kept;
        sum(m_clusters, m_x, options, kept);
        if (!(kept.one.v > leastWeight<T>))
            return;
        m_options = options;
        m_moments = kept;
        m_out.agreement = agreementOf(kept);
    }

    /// c = sum theta p / w, d = x - c, o = |d|, h.
    void centre() {
        m_inverseWeight = inverse(m_moments.one);
        const JetVec<T, O> offset = m_moments.q * m_inverseWeight;
        const base::Vec3<T> e = valueOf(offset);
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

    /// sum theta q q^T with q moving: q_a q_b - x_a q_b - x_b q_a + x_a x_b about x0.
    static void movingOuter(const Moments<T, O>& m, Jet<T, O> (&s)[6]) {
        for (int a = 0; a < 3; ++a)
            for (int b = a; b < 3; ++b) {
                Jet<T, O>& out = s[sym(a, b)];
                out = m.outer[sym(a, b)];
                if constexpr (O >= 1) {
                    out = out - timesCoordinate(a, m.q[static_cast<std::size_t>(b)]) -
                          timesCoordinate(b, m.q[static_cast<std::size_t>(a)]);
                    if constexpr (O >= 2)
                        out += timesCoordinate(a, timesCoordinate(b, m.one));
                }
            }
    }

    FrameNormal<T, O> frameNormal() {
        switch (m_frame) {
        case Frame::Normals:
            return m_out.agreement >= T(leastAgreement) ? normalisedSum(m_moments.n) : FrameNormal<T, O>{};
        case Frame::Hyperplanes:
            return eigenvector(m_moments.outer, Pick::Largest);
        case Frame::Covariance: {
            Jet<T, O> s[6];
            movingOuter(m_moments, s);
            return eigenvector(s, Pick::Smallest);
        }
        case Frame::CovarianceAtCentroid:
        case Frame::CentroidGradient:
        case Frame::Apss:
        case Frame::Rimls:
            break;
        }
        return normalAtCentroid();
    }

    /// The covariance frame evaluated at y = c(x) (alg. 7, cov_c): N(y) composed with c(x).
    FrameNormal<T, O> normalAtCentroid() {
        SumOptions options = m_options;
        options.outer = Outer::Offsets;
        Moments<T, O> there;
        ScratchClusters clusters;
        m_source.gather(m_out.centroid, clusters.list());
        sum(clusters.span(), m_out.centroid, options, there);
        if (!(there.one.v > leastWeight<T>) || there.samples < leastSamples)
            return {};
        Jet<T, O> s[6];
        movingOuter(there, s);
        FrameNormal<T, O> out = eigenvector(s, Pick::Smallest);
        if (out.valid)
            for (Jet<T, O>& each : out.n)
                each = compose(each, m_centroid);
        return out;
    }

    /// Signs of alg. 2.4: by the surfels' normals where they are oriented, else by the hint, else as it came.
    void orient(JetVec<T, O>& n) const {
        const base::Vec3<T> reference = m_oriented ? valueOf(m_moments.n) : base::cast<T>(m_hint);
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

    void finish(const JetVec<T, O>& n) {
        const T mu = m_normals ? static_cast<T>(m_surface.definition().mu()) : T(0);
        Jet<T, O> f = dot(n, m_d) * (T(1) - mu);
        if (mu > T(0)) {
            Jet<T, O> height = -m_moments.height; // sum theta n_i.(x - p_i)
            for (int a = 0; a < 3; ++a)
                height += timesCoordinate(a, m_moments.n[static_cast<std::size_t>(a)]);
            f += height * m_inverseWeight * mu;
        }
        store(f, n);
        const float limit = m_surface.definition().boundaryLimit;
        const bool beyond = std::isfinite(limit) && m_out.offCentre > static_cast<T>(limit) * m_out.unit;
        m_out.status = beyond ? Status::BeyondBoundary : Status::Ok;
    }

    void store(const Jet<T, O>& f, const JetVec<T, O>& n) {
        m_out.value = f.v;
        m_out.normal = valueOf(n);
        if constexpr (O >= 1) {
            m_out.gradient = {f.d[0], f.d[1], f.d[2]};
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t k = 0; k < 3; ++k)
                    m_out.normalGradient.m[a][k] = n[a].d[k];
        }
        if constexpr (O >= 2)
            m_out.hessian = detail::matrixOf(f.dd.data());
    }

    const Source& m_source;
    const Surface& m_surface;
    ClusterSpan m_clusters;
    base::Vec3<T> m_x;
    base::Vec3d m_hint; ///< unit, or zero for none
    Frame m_frame;
    bool m_normals, m_oriented;
    SumOptions m_options;
    Moments<T, O> m_moments;
    Jet<T, O> m_inverseWeight;
    JetVec<T, O> m_d{}, m_centroid{}; ///< x - c, and c relative to where x is
    Evaluation<T> m_out;
};

} // namespace surface
