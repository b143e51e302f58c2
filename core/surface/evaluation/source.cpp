#include "core/surface/evaluation/source.h"

#include "core/surface/evaluation/assemble.h"

namespace surface {

constexpr float slackOfUnit = 0.3f; ///< steps of projections and rays are mostly shorter
/// A list pays for itself where it holds no more blocks than this. What a box costs is counted, not judged by its size:
/// supports and density may differ a hundredfold from place to place.
constexpr std::size_t fairBlocks(std::size_t positions) {
    return 8 + positions / 4;
}

static base::Mat3f rounded(const base::Mat3d& m) {
    base::Mat3f out;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            out.m[row][column] = static_cast<float>(m.m[row][column]);
    return out;
}

static Evaluationf rounded(const Evaluationd& e) {
    Evaluationf out;
    out.status = e.status;
    out.cause = e.cause;
    out.samples = e.samples;
    out.weight = static_cast<float>(e.weight);
    out.value = static_cast<float>(e.value);
    out.centroid = base::cast<float>(e.centroid);
    out.normal = base::cast<float>(e.normal);
    out.gradient = base::cast<float>(e.gradient);
    out.hessian = rounded(e.hessian);
    out.normalGradient = rounded(e.normalGradient);
    out.offCentre = static_cast<float>(e.offCentre);
    out.unit = static_cast<float>(e.unit);
    out.agreement = static_cast<float>(e.agreement);
    return out;
}

bool Source::announce(const base::Box3f& box, float slack, std::size_t positions, float distance) {
    const std::size_t most = positions > 1 ? fairBlocks(positions) : Candidates::anyNumber;
    if (!m_candidates.findBlocks(*m_surface, box, most))
        return false;
    const float around = std::max(distance, slack * localSupport());
    if (around > 0 && !m_candidates.findBlocks(*m_surface, box.inflated(around), 2 * fairBlocks(positions)))
        m_candidates.findBlocks(*m_surface, box);
    return true;
}

void Source::gather(const base::Vec3f& x, ClusterList& out) const {
    if (m_candidates.covers(x))
        m_candidates.select(x, out);
    else
        surface::gather(m_surface->tree(), x, out, m_surface->supportScale());
}

void Source::gather(const base::Vec3d& x, ClusterList& out) const {
    surface::gather(m_surface->tree(), x, out, m_surface->supportScale());
}

void Source::gather(const base::Vec3f& x, float around, ClusterList& out) const {
    const base::Box3f box = base::Box3f{x, x}.inflated(around);
    if (m_candidates.covers(box))
        m_candidates.select(box, out);
    else
        surface::gather(m_surface->tree(), box, out, m_surface->supportScale());
}

Evaluationf Source::hessian(const base::Vec3f& x, const OrientationHint& hint, ClusterSpan clusters) const {
    if (m_surface->effectiveFrame() == Frame::Normals && !m_surface->definition().interpolating)
        return Assembler<float, 2>(*this, clusters, x, hint).run();
    ScratchClusters around;
    const base::Vec3d at = base::cast<double>(x);
    gather(at, around.list());
    return rounded(Assembler<double, 2>(*this, around.span(), at, hint).run());
}

Evaluationf Source::assemble(const base::Vec3f& x, Need need, const OrientationHint& hint, ClusterSpan clusters) const {
    switch (need) {
    case Need::Value:
        return Assembler<float, 0>(*this, clusters, x, hint).run();
    case Need::Gradient:
        return Assembler<float, 1>(*this, clusters, x, hint).run();
    case Need::Hessian:
        break;
    }
    return hessian(x, hint, clusters);
}

void Source::evaluate(const base::Vec3f& x, Need need, const OrientationHint& hint, Evaluationf& out) {
    if (m_steps == Steps::Close && m_slack > 0 && !m_candidates.covers(x))
        expect(base::Box3f{x, x}.inflated(m_slack));
    ScratchClusters clusters;
    gather(x, clusters.list());
    if (!m_plain.applies() || !m_plain.evaluate(clusters.span(), x, need, out))
        out = assemble(x, need, hint, clusters.span());
    if (out.unit > 0)
        m_slack = slackOfUnit * out.unit;
}

Evaluationd Source::evaluate(const base::Vec3d& x, Need need, const OrientationHint& hint) {
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
