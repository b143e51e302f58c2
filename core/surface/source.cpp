#include "core/surface/source.h"

#include "core/surface/assemble.h"

namespace surface {

constexpr float slackOfUnit = 0.3f; ///< steps of projections and rays are mostly shorter

void Source::gather(const base::Vec3f& x, ClusterList& out) const {
    if (m_candidates.covers(x))
        m_candidates.select(x, out);
    else
        surface::gather(m_surface.tree(), x, out);
}

void Source::gather(const base::Vec3d& x, ClusterList& out) const {
    surface::gather(m_surface.tree(), x, out);
}

Evaluationf Source::evaluate(const base::Vec3f& x, Need need, const Hint& hint) {
    if (m_steps == Steps::Close && m_slack > 0 && !m_candidates.covers(x))
        expect(base::Box3f{x, x}.inflated(m_slack));
    ScratchClusters clusters;
    gather(x, clusters.list());
    const Evaluationf out = need == Need::Value ? Assembler<float, 0>(*this, clusters.span(), x, hint).run()
                                                : Assembler<float, 1>(*this, clusters.span(), x, hint).run();
    if (out.unit > 0)
        m_slack = slackOfUnit * out.unit;
    return out;
}

Evaluationd Source::evaluate(const base::Vec3d& x, Need need, const Hint& hint) {
    ScratchClusters clusters;
    gather(x, clusters.list());
    switch (need) {
    case Need::Value:
        return Assembler<double, 0>(*this, clusters.span(), x, hint).run();
    case Need::Gradient:
        return Assembler<double, 1>(*this, clusters.span(), x, hint).run();
    case Need::Hessian:
        break;
    }
    return Assembler<double, 2>(*this, clusters.span(), x, hint).run();
}

} // namespace surface
