#include "app/cell_answers.h"

#include "core/base/parallel.h"

namespace app {

using base::Vec3d;
using surface::Need;

std::optional<CellAnswers> CellAnswers::of(const surface::Surface& surface, const Question& question) {
    auto plain = cells::CellSurface::of(surface);
    if (!plain)
        return std::nullopt;
    CellAnswers out(std::move(*plain));
    if (question.curvature)
        out.m_wide = cells::CellSurface::of(surface.withSupportScale(surface.definition().curvatureScale()));
    return out;
}

void CellAnswers::answer(const Question& question, std::span<const Vec3d> x, std::span<Answer> out) const {
    base::parallelChunks(x.size(), 16, [&](std::size_t begin, std::size_t end, std::size_t) {
        cells::CellSource source(m_surface);
        for (std::size_t i = begin; i < end; ++i) {
            Answer& a = out[i];
            if (question.evaluates) {
                const cells::CellValue value = evaluate(source, x[i], std::min(question.need, Need::Gradient));
                a.cell = value.cell;
                if (value.mixed)
                    a.at = value.at;
            }
            if (m_wide) {
                const cells::CellValue value = evaluate(*m_wide, x[i], Need::Hessian);
                if (value.mixed)
                    a.curvature = curvatureOf(value.at);
            }
            if (question.projector) {
                const cells::CellFoot foot = project(m_surface, x[i], {*question.projector});
                if (foot.mixed)
                    a.projection = foot.projection;
                a.feature = foot.feature;
            }
            if (question.feature && question.projector != surface::Projector::Orthogonal)
                a.feature = project(m_surface, x[i]).feature;
        }
    });
}

} // namespace app
