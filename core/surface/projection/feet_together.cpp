#include "core/surface/projection/feet_together.h"

#include "core/surface/evaluation/near_sheets.h"

#include <bit>

namespace surface {

using base::Vec3f;
using End = LaneFoot::End;

/// Positions that come this close to a limit of the assembler's are left to it.
constexpr float clearly = 1.001f;
/// Steps in lanes. From then on second derivatives are worth what they cost (surface/README 3.2).
constexpr int mostSteps = 5;
constexpr float laterSlack = 0.1f; ///< the same as packetSlack once the surface is near

static Vec3f column(const float (&v)[3][FootLanes::lanes], std::size_t lane) {
    return {v[0][lane], v[1][lane], v[2][lane]};
}
static void setColumn(float (&v)[3][FootLanes::lanes], std::size_t lane, const Vec3f& to) {
    v[0][lane] = to.x, v[1][lane] = to.y, v[2][lane] = to.z;
}

FeetTogether::FeetTogether(const Surface& surface, const ProjectOptions& options, std::span<const Vec3f> x)
    : m_options(options), m_x(x), m_plain(surface),
      m_applies(m_plain.applies() && m_plain.shape() == 0 && options.projector == Projector::Orthogonal &&
                options.need != Need::Hessian && options.maxIterations > mostSteps),
      m_foot{m_plain.weight(), m_plain.mu(), toleranceOf<float>(options), clearly * static_cast<float>(oneSheetBelow),
             clearly * static_cast<float>(leastSpread)} {}

void FeetTogether::add(Source& source, std::size_t index) {
    const std::size_t lane = m_count++;
    m_source[lane] = &source;
    m_index[lane] = index;
}

void FeetTogether::project() {
    m_active = (1u << m_count) - 1;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Vec3f x = m_x[m_index[lane < m_count ? lane : 0]];
        for (auto* to : {&m_lanes.from, &m_lanes.at, &m_centre})
            setColumn(*to, lane, x);
        m_lanes.lastSize[lane] = std::numeric_limits<float>::infinity();
        m_lanes.unit[lane] = 0;
        m_slack[lane] = lane < m_count ? -1.0f : 0.0f; // nothing is picked yet
        m_near.counts[lane] = 0;
    }
    for (int steps = 0; m_active != 0; ++steps) {
        pickStrayed();
        footKernel(m_foot, m_near, m_lanes);
        for (unsigned left = m_active; left != 0; left &= left - 1)
            take(static_cast<std::size_t>(std::countr_zero(left)), steps);
    }
}

/// For lanes that have come farther than the surfels that they know.
void FeetTogether::pickStrayed() {
    bool any = false;
    for (unsigned left = m_active; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        if (distance(column(m_lanes.at, lane), column(m_centre, lane)) <= m_slack[lane])
            continue;
        any = true;
        const float slack =
            m_lanes.unit[lane] > 0 ? laterSlack * m_lanes.unit[lane] : packetSlack * m_source[lane]->localSupport();
        if (!pick(lane, slack) && !pick(lane, 0))
            end(lane, End::Anew, 0);
    }
    if (any)
        turnNear(m_centre, m_slack, m_count, m_near);
}

bool FeetTogether::pick(std::size_t lane, float slack) {
    const Vec3f at = column(m_lanes.at, lane);
    setColumn(m_centre, lane, at);
    m_slack[lane] = slack;
    ScratchClusters clusters;
    m_source[lane]->gather(at, slack, clusters.list());
    return pickNear(clusters.span(), at, m_plain.supportScale(), slack, lane, m_near);
}

void FeetTogether::end(std::size_t lane, End end, int steps) {
    m_end[lane] = end;
    m_steps[lane] = steps;
    m_active &= ~(1u << lane);
}

/// What the kernel says of a lane: goes its step, or ends it.
void FeetTogether::take(std::size_t lane, int steps) {
    const unsigned bit = 1u << lane;
    if (!(m_lanes.usual & bit))
        return end(lane, End::Anew, steps);
    if (m_lanes.settled & bit)
        return end(lane, m_lanes.onZero & bit ? End::Found : End::Anew, steps);
    if (!(m_lanes.leads & bit) || steps == mostSteps)
        return end(lane, End::Resume, steps);
    setColumn(m_lanes.at, lane, column(m_lanes.to, lane));
    m_lanes.lastSize[lane] = m_lanes.size[lane];
}

Projection<float> FeetTogether::soFar(std::size_t lane) const {
    Projection<float> out;
    out.foot = column(m_lanes.at, lane);
    out.iterations = m_steps[lane];
    out.evaluations = m_steps[lane] + 1;
    if (m_end[lane] != End::Found)
        return out;
    Evaluationf& at = out.at;
    at.offCentre = m_lanes.offCentre[lane];
    at.unit = m_lanes.unit[lane];
    const bool beyond = at.offCentre > m_plain.boundaryLimit() * at.unit;
    at.status = m_plain.settled(beyond ? Status::BeyondBoundary : Status::Ok, out.foot);
    at.cause = Cause::None;
    at.samples = static_cast<int>(m_lanes.samples[lane]);
    at.weight = m_lanes.weight[lane];
    at.value = m_lanes.value[lane];
    at.agreement = m_lanes.agreement[lane];
    at.centroid = column(m_lanes.centroid, lane);
    at.normal = column(m_lanes.normal, lane);
    at.gradient = column(m_lanes.gradient, lane);
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
            at.normalGradient.m[a][b] = m_lanes.normalGradient[3 * a + b][lane];
    out.status = m_options.checkBoundary ? at.status : Status::Ok;
    return out;
}

} // namespace surface
