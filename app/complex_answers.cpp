#include "app/complex_answers.h"

#include "core/base/parallel.h"
#include "core/complexes/complex_projection.h"

#include <algorithm>

namespace app {

using surface::Need;

/// What the place of a complex is that lies on a cell of that dimension.
static cells::Feature featureOf(int dimension) {
    return dimension == 2 ? cells::Feature::Face : dimension == 1 ? cells::Feature::Seam : cells::Feature::Corner;
}

void answerOnComplex(const complexes::Complex& complex, const Question& question, std::span<const base::Vec3d> x,
                     std::span<Answer> out) {
    const bool locates = std::any_of(question.rows.begin(), question.rows.end(),
                                     [](const WhatRow* row) { return row->of == Asks::Cells; });
    base::parallelFor(x.size(), 4, [&](std::size_t i) {
        Answer& a = out[i];
        if (question.evaluates || question.curvature)
            a.at = evaluate(complex, x[i], question.curvature ? Need::Hessian : question.need);
        if (question.curvature)
            a.curvature = curvatureOf(a.at);
        complexes::CellFoot foot;
        if (question.projector) {
            foot = project(complex, x[i], *question.projector);
            a.projection.status = foot.status;
            a.projection.foot = foot.position;
            a.projection.iterations = foot.iterations;
        }
        if (!locates)
            return;
        if (question.projector != surface::Projector::Almost)
            foot = project(complex, x[i], surface::Projector::Almost);
        if (foot.ok()) {
            a.cell = foot.on;
            a.feature = featureOf(complex[foot.on].dimension);
        }
    });
}

} // namespace app
