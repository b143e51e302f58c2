#include "app/curve_answers.h"

#include "core/base/parallel.h"
#include "core/surface/curves/curve.h"

namespace app {

using base::Vec3d;

static surface::Evaluationd evaluationOf(const surface::CurveEvaluation& e) {
    surface::Evaluationd out;
    const double away = length(e.value);
    out.status = e.status;
    out.cause = e.cause;
    out.samples = e.samples;
    out.weight = e.weight;
    out.unit = e.unit;
    out.value = away;
    out.centroid = e.centroid;
    out.normal = away > 0 ? e.value / away : Vec3d{};
    out.gradient = transposed(e.gradient) * out.normal;
    out.offCentre = e.offCentre;
    out.agreement = 1;
    return out;
}

static surface::Curvature curvatureOf(const surface::CurveEvaluation& e) {
    surface::Curvature out;
    out.status = e.usable() ? surface::Status::Ok : e.status;
    out.cause = e.cause;
    out.k1 = length(e.curvature);
    out.normal = -base::normalized(e.curvature);
    out.direction1 = e.tangent;
    out.direction2 = cross(out.normal, e.tangent);
    return out;
}

void answerOnCurve(const surface::Surface& curve, const Question& question, std::span<const Vec3d> x,
                   std::span<Answer> out) {
    base::parallelFor(x.size(), 16, [&](std::size_t i) {
        if (question.evaluates) {
            const surface::CurveEvaluation at = evaluateCurve(curve, x[i], question.need);
            out[i].at = evaluationOf(at);
            out[i].curvature = curvatureOf(at);
            out[i].tangent = at.tangent;
            out[i].curvatureVector = at.curvature;
        }
        if (question.projector) {
            const surface::CurveProjection foot = projectOnCurve(curve, x[i], {*question.projector});
            out[i].projection.status = foot.status;
            out[i].projection.foot = foot.foot;
            out[i].projection.iterations = foot.iterations;
        }
    });
}

} // namespace app
