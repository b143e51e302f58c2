// Second stage of an evaluation: from the sums over surfels to n, f, g, Hessian and status. Shared by both precisions;
// `O` is the order of derivatives wanted.
//
//     sums at x -> near sheets? both of them (two_solids.h), or sums once more without what faces away (near_sheets.h)
//               -> c, d = x - c -> are there enough surfels? (sufficiency.h)
//               -> weights interpolate and a surfel is here? then it is the answer (surfel_here.h)
//               -> n and f by the frame (frames/)
//               -> what is asked for, beyond the boundary or not
#pragma once

#include "core/surface/evaluation/surfel_here.h"
#include "core/surface/evaluation/two_solids.h"
#include "core/surface/frames/frame_part.h"
#include "core/surface/rims.h"

namespace surface {

constexpr double leastAgreement = 0.2; ///< |m|/w below which oriented normals cancel (surface/README 2.5)

template <class T, int O>
class Assembler {
  public:
    Assembler(const Source& source, ClusterSpan clusters, const base::Vec3<T>& x, const OrientationHint& hint)
        : m_at(source, clusters, x, hint) {}

    Evaluation<T> run() {
        const bool solids = sumAll();
        if (!(m_at.moments.one.v > leastWeight<T>))
            return failed(Status::Outside, Cause::NoSupport);
        if (!solids)
            m_at.keepOneSheet();
        m_at.centre();
        count();
        if (const Cause cause = scarcity(m_at.clusters, m_at.x, m_at.options, m_at.moments); cause != Cause::None)
            return failed(Status::Degenerate, cause);
        if (m_at.options.interpolating && m_at.normals)
            if (const auto here = surfelHere(m_at.clusters, m_at.x, m_at.options.scale))
                return take(*here);
        if (!solids && m_at.frame.reads == NormalsRead::Oriented && !(m_at.agreement >= T(leastAgreement)))
            return failed(Status::Degenerate, Cause::CancellingNormals);
        const Field<T, O> found = solids ? TwoSolids<T, O>(m_at).run() : fieldOf(*m_at.frame.part, m_at);
        if (found.cause != Cause::None)
            return failed(Status::Degenerate, found.cause);
        m_out.agreement = m_at.agreement;
        if (solids)
            locate();
        store(found);
        return m_out;
    }

    /// dc_a/dx_b at x, by the surfels that the answer kept to. REQUIRES: run() was called and f has a value.
    base::Mat3<T> centroidGradient() const {
        static_assert(O >= 1);
        base::Mat3<T> out;
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t k = 0; k < 3; ++k)
                out.m[a][k] = m_at.centroid[a].d[k];
        return out;
    }
    /// grad h at x, likewise. REQUIRES: T is double.
    base::Vec3<T> unitGradient() const {
        static_assert(O >= 1 && std::is_same_v<T, double>);
        const auto& w = m_at.moments.one;
        return (m_at.moments.unitSlope - base::Vec3<T>{w.d[0], w.d[1], w.d[2]} * m_out.unit) / w.v;
    }

  private:
    using Vector = base::Vec3<T>;

    /// Sums over all surfels; tells whether near sheets are put together as two solids. Only then products of normals
    /// are summed: the other sums keep their bits.
    bool sumAll() {
        if (m_at.tellsSolids()) {
            SumOptions options = m_at.options;
            options.outer = Outer::Normals;
            sum(m_at.clusters, m_at.x, options, m_at.moments);
            m_at.agreement = agreementOf(m_at.moments);
            if (m_at.agreement < T(oneSheetBelow) || !(m_at.moments.one.v > leastWeight<T>))
                return true;
        }
        sum(m_at.clusters, m_at.x, m_at.options, m_at.moments);
        return false;
    }

    void locate() {
        m_out.centroid = m_at.centroidPosition();
        m_out.offCentre = length(valueOf(m_at.centroid));
    }

    /// What stays even where there is no answer, so that a failure can be explained.
    void count() {
        m_out.samples = m_at.moments.samples;
        m_out.weight = m_at.moments.one.v;
        m_out.unit = m_at.moments.unit / m_at.moments.one.v;
        m_out.agreement = m_at.agreement;
        locate();
    }

    /// What would be used as an answer is not a number.
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

    Evaluation<T> take(SurfelHere<T> here) {
        if (!m_at.oriented && dot(base::cast<double>(here.normal), m_at.side) < 0)
            here.normal = -here.normal;
        Field<T, O> field;
        for (std::size_t a = 0; a < 3; ++a)
            field.n[a].v = here.normal[a];
        if constexpr (O >= 1)
            field.f.d = {here.normal.x, here.normal.y, here.normal.z};
        m_out.centroid = here.position;
        m_out.offCentre = length(m_at.x - here.position);
        store(field);
        if constexpr (O >= 2) {
            const Evaluation<T> near = above(here);
            if (near.cause != Cause::None)
                return failed(Status::Degenerate, near.cause);
            m_out.hessian = near.hessian;
        }
        return m_out;
    }

    Evaluation<T> above(const SurfelHere<T>& here) const {
        const Vector x = m_at.x + here.normal * (static_cast<T>(besideSurfel) * here.support);
        ScratchClusters clusters;
        m_at.source.gather(x, clusters.list());
        return Assembler(m_at.source, clusters.span(), x, {base::cast<float>(here.normal)}).run();
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
        const bool beyond = isPastEnd(m_at.source.surface(), m_at.x, m_out.offCentre, m_out.unit);
        m_out.status = beyond ? Status::BeyondBoundary : Status::Ok;
        m_out.cause = Cause::None;
    }

    Neighbourhood<T, O> m_at;
    Evaluation<T> m_out;
};

} // namespace surface
